#include "src/run/signals.hpp"

namespace swarf {
namespace {

volatile std::sig_atomic_t first_signal = 0;

void remember(int signal) {
  if (first_signal == 0) first_signal = signal;
}

bool is_ignored(int signal) {
  struct sigaction now {};
  return sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

} // namespace

void handle_ending_signals(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler, action.sa_flags = SA_RESTART;
  for (const int signal : ending_signals)
    if (signal != SIGHUP || !is_ignored(signal)) sigaction(signal, &action, nullptr);
}

void survive_failed_writes() { std::signal(SIGPIPE, SIG_IGN), std::signal(SIGXFSZ, SIG_IGN); }

SignalWatch::SignalWatch() { first_signal = 0, handle_ending_signals(remember); }
SignalWatch::~SignalWatch() { handle_ending_signals(SIG_DFL); }
int SignalWatch::received() const { return first_signal; }

std::string signal_name(int signal) {
  switch (signal) {
  case SIGINT:
    return "SIGINT";
  case SIGTERM:
    return "SIGTERM";
  case SIGHUP:
    return "SIGHUP";
  case SIGQUIT:
    return "SIGQUIT";
  case SIGALRM:
    return "SIGALRM";
  case SIGVTALRM:
    return "SIGVTALRM";
  case SIGUSR1:
    return "SIGUSR1";
  case SIGUSR2:
    return "SIGUSR2";
  case SIGXCPU:
    return "SIGXCPU";
  }
  return "signal " + std::to_string(signal);
}

} // namespace swarf
