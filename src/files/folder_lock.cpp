#include "src/files/folder_lock.hpp"
#include "src/files/results.hpp"
#include "src/files/say.hpp"
#include <cerrno>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <fmt/chrono.h>
#include <fstream>
#include <sstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace swarf {
namespace fs = std::filesystem;
namespace {

std::string command_line() {
  std::ostringstream text;
  text << std::ifstream("/proc/self/cmdline", std::ios::binary).rdbuf();
  std::string words = text.str();
  for (char& c : words)
    if (c == '\0' || c == '\n') c = ' ';
  while (!words.empty() && words.back() == ' ') words.pop_back();
  return words;
}

std::string describe_self() {
  char host[256] = "this machine";
  gethostname(host, sizeof host - 1);
  return fmt::format("process {} on {} since {:%Y-%m-%d %H:%M:%S}: {}\n", getpid(), host,
                     fmt::localtime(std::time(nullptr)), command_line());
}

std::string read_holder(int descriptor) {
  char text[1024];
  const ssize_t count = pread(descriptor, text, sizeof text, 0);
  std::string holder(text, std::size_t(std::max<ssize_t>(0, count)));
  holder.resize(std::min(holder.size(), holder.find('\n')));
  return holder.empty() ? "another process" : holder;
}

bool is_file(int descriptor) {
  struct stat what {};
  return fstat(descriptor, &what) == 0 && S_ISREG(what.st_mode);
}

// Whoever let go of the lock has removed the file with it: then the name is another file's by now.
bool is_still_named(int descriptor, const fs::path& file) {
  struct stat held {
  }, named{};
  return fstat(descriptor, &held) == 0 && lstat(file.c_str(), &named) == 0 && held.st_dev == named.st_dev &&
         held.st_ino == named.st_ino;
}

} // namespace

FolderLock::FolderLock(const fs::path& folder) : file(folder / "swarf.lock") {
  make_folder(folder);
  for (;;) {
    descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
    if ((descriptor < 0 && (errno == ELOOP || errno == ENXIO)) || (descriptor >= 0 && !is_file(descriptor))) {
      if (descriptor >= 0) close(descriptor);
      throw ResultsError(fmt::format(
          "{}: is a link, a folder or a device, and the run would write in it: remove it, or choose another "
          "folder with --output",
          file.string()));
    }
    if (descriptor < 0) fail_to(folder, "write in the results folder", errno);
    const int failed = flock(descriptor, LOCK_EX | LOCK_NB);
    const int error = errno;
    if (failed != 0 && error == EWOULDBLOCK) {
      const std::string holder = read_holder(descriptor);
      close(descriptor);
      throw ResultsError(
          fmt::format("{}: is being written by {}; wait until it has ended, stop it, or choose "
                      "another folder with --output",
                      folder.string(), holder));
    }
    if (failed != 0)
      complain("warning: {}: this disk keeps no locks ({}): see that no other run writes here.",
               folder.string(), std::strerror(error));
    if (failed != 0 || is_still_named(descriptor, file)) break;
    close(descriptor);
  }
  const std::string self = describe_self();
  if (ftruncate(descriptor, 0) == 0) static_cast<void>(!pwrite(descriptor, self.data(), self.size(), 0));
}

FolderLock::~FolderLock() {
  unlink(file.c_str()); // while it is held
  close(descriptor);
}

} // namespace swarf
