// Signals as a run takes them: those that ask it to end are remembered, those of a log or disk that fails are
// not allowed to kill it.
#pragma once
#include <array>
#include <csignal>
#include <string>

namespace swarf {

// Ctrl-C, kill, a terminal that closes, a batch system's warnings.
inline constexpr std::array<int, 9> ending_signals{SIGINT,    SIGTERM, SIGHUP,  SIGQUIT, SIGALRM,
                                                   SIGVTALRM, SIGUSR1, SIGUSR2, SIGXCPU};

void handle_ending_signals(void (*handler)(int)); // all of them, but a hang-up that nohup has ignored

// From here on writing to a closed pipe, or beyond the limit of a file's size, is an error of the call
// instead of the program's death.
void survive_failed_writes();

// While it lives the ending signals are only remembered.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;
  int received() const; // the first one; 0: none
};

std::string signal_name(int signal); // "SIGTERM"

} // namespace swarf
