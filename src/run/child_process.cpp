#include "src/run/child_process.hpp"
#include "src/files/results.hpp"
#include "src/run/signals.hpp"
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace swarf {
namespace {

volatile std::sig_atomic_t signalled = 0;
std::array<volatile pid_t, ChildProcesses::most> children{}; // 0: free

void pass_on(int signal) {
  signalled = 1;
  for (const volatile pid_t& child : children)
    if (child > 0) kill(child, signal);
}

void block(sigset_t& before) {
  sigset_t all;
  sigemptyset(&all);
  for (const int signal : ending_signals) sigaddset(&all, signal);
  sigprocmask(SIG_BLOCK, &all, &before);
}

} // namespace

ChildProcesses::ChildProcesses() {
  signalled = 0;
  handle_ending_signals(pass_on);
}

ChildProcesses::~ChildProcesses() {
  handle_ending_signals(SIG_DFL);
  for (volatile pid_t& child : children)
    if (child > 0) kill(child, SIGTERM); // only after an error of the parent's
}

bool ChildProcesses::interrupted() const { return signalled != 0; }

pid_t ChildProcesses::start(std::vector<std::string> arguments, const std::filesystem::path& log,
                            bool append_log) {
  const int to = open(log.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | (append_log ? O_APPEND : O_TRUNC), 0666);
  if (to < 0)
    throw ResultsError(fmt::format("{}: cannot write the log: {}; choose a folder that you may write",
                                   log.string(), std::strerror(errno)));
  arguments.insert(arguments.begin(), "swarf");
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  sigset_t before; // no signal between the child's start and the row that it is passed on by
  block(before);
  const pid_t parent = getpid(), child = fork();
  if (child == 0) { // between fork and exec only calls that need no lock
    handle_ending_signals(SIG_DFL);
    sigprocmask(SIG_SETMASK, &before, nullptr);
    prctl(PR_SET_PDEATHSIG, SIGTERM); // it writes a checkpoint
    if (getppid() != parent) _exit(127);
    dup2(to, STDOUT_FILENO), dup2(to, STDERR_FILENO);
    execv("/proc/self/exe", argv.data());
    _exit(127);
  }
  const int error = errno;
  for (volatile pid_t& row : children)
    if (child > 0 && row == 0) {
      row = child;
      break;
    }
  sigprocmask(SIG_SETMASK, &before, nullptr);
  close(to);
  if (child < 0)
    throw ResultsError(
        fmt::format("cannot start a process for a window: {}; run with fewer --jobs", std::strerror(error)));
  return child;
}

EndedChild ChildProcesses::wait() {
  EndedChild ended;
  siginfo_t first{};
  int failed = 0;
  do {
    failed = waitid(P_ALL, 0, &first, WEXITED | WNOWAIT);
  } while (failed != 0 && errno == EINTR);
  if (failed != 0) return ended;
  for (volatile pid_t& row : children) // while the number is still this child's
    if (row == first.si_pid) row = 0;
  int status = 0;
  rusage usage{};
  ended.pid = wait4(first.si_pid, &status, 0, &usage);
  ended.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  ended.core_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  return ended;
}

} // namespace swarf
