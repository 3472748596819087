// The program swarf as a child process: started, watched, killed.
#pragma once
#include "tests/support/temporary_folder.hpp"
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace swarf::test {

struct Ended {
  int status = 0; // as a shell sees it: 128 + the signal for a child that a signal ended
  std::string output;
};

inline std::string read_bytes(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

class Program {
 public:
  // file_limit: bytes that a file may grow to; 0: no limit.
  explicit Program(std::vector<std::string> arguments, rlim_t file_limit = 0) {
    std::string program = SWARF_PROGRAM;
    std::vector<char*> argv{program.data()};
    for (auto& a : arguments) argv.push_back(a.data());
    argv.push_back(nullptr);
    const std::string log = (folder / "log").string();
    child = fork();
    if (child != 0) return;
    const int to = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    dup2(to, STDOUT_FILENO), dup2(to, STDERR_FILENO);
    setenv("OMP_WAIT_POLICY", "passive", 1), setenv("OMP_PROC_BIND", "false", 1);
    if (file_limit > 0) {
      const rlimit limit{file_limit, file_limit};
      setrlimit(RLIMIT_FSIZE, &limit);
    }
    execv(argv[0], argv.data());
    _exit(127);
  }
  ~Program() {
    if (!ended) kill(child, SIGKILL), wait();
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void send(int signal) {
    if (runs()) kill(child, signal); // the number of a child that has ended may be another's by now
  }
  bool runs() {
    if (!ended) ended = waitpid(child, &raw_status, WNOHANG) == child;
    return !ended;
  }
  Ended wait() {
    if (!ended) waitpid(child, &raw_status, 0), ended = true;
    const int status = WIFSIGNALED(raw_status) ? 128 + WTERMSIG(raw_status) : WEXITSTATUS(raw_status);
    return {status, read_bytes(folder / "log")};
  }

 private:
  TemporaryFolder folder;
  pid_t child = -1;
  int raw_status = 0;
  bool ended = false;
};

inline Ended run_program(const std::vector<std::string>& arguments, rlim_t file_limit = 0) {
  return Program(arguments, file_limit).wait();
}

inline void pause_for(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

inline std::string write_deck(const TemporaryFolder& folder, const std::string& text,
                              const std::string& name = "deck.toml") {
  std::ofstream(folder / name, std::ios::binary) << text;
  return (folder / name).string();
}

inline std::vector<std::string> run_arguments(const std::string& deck, const std::filesystem::path& results,
                                              bool resume = false, int threads = 1) {
  std::vector<std::string> all{
      "run", deck, "--output", results.string(), "--threads", std::to_string(threads), "--no-pictures"};
  all.push_back(resume ? "--resume" : "--overwrite"); // what a test has left in its folder may go
  return all;
}

} // namespace swarf::test
