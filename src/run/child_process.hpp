// This program once more, as a child process: windows run side by side.
#pragma once
#include <filesystem>
#include <string>
#include <sys/types.h>
#include <vector>

namespace swarf {

struct EndedChild {
  pid_t pid = -1;
  int status = 0; // as a shell sees it: 128 + the signal for a child that a signal ended
  double core_seconds = 0;
};

// While it lives, SIGINT and SIGTERM are passed on to the children, which then write checkpoints and end. One
// at a time.
class ChildProcesses {
 public:
  ChildProcesses();
  ~ChildProcesses();
  ChildProcesses(const ChildProcesses&) = delete;
  ChildProcesses& operator=(const ChildProcesses&) = delete;

  // Its output goes to `log`. Throws ResultsError.
  pid_t start(std::vector<std::string> arguments, const std::filesystem::path& log, bool append_log);
  EndedChild wait();        // for any; pid -1 if there is none
  bool interrupted() const; // by either

  static constexpr int most = 256;
};

} // namespace swarf
