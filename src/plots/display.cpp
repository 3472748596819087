#include "src/plots/display.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

namespace swarf {
namespace {

// libX11 comes with VTK.
template <class Function>
Function* find_in_x11(const char* name) {
  void* x11 = dlopen("libX11.so.6", RTLD_NOW | RTLD_LOCAL);
  return x11 ? reinterpret_cast<Function*>(dlsym(x11, name)) : nullptr;
}

void* connect_to_display() {
  const auto open = find_in_x11<void*(const char*)>("XOpenDisplay");
  return std::getenv("DISPLAY") && open ? open(nullptr) : nullptr;
}

// The number that Xvfb writes when it is ready; "" after ten seconds without one.
std::string read_display_number(int fd) {
  std::string text;
  pollfd waiting{fd, POLLIN, 0};
  while (text.find('\n') == text.npos && poll(&waiting, 1, 10000) > 0) {
    char buffer[32];
    const ssize_t got = read(fd, buffer, sizeof buffer);
    if (got <= 0) return "";
    text.append(buffer, std::size_t(got));
  }
  return text.substr(0, text.find('\n'));
}

} // namespace

// VTK aborts the whole program where it cannot connect, so we try first, and stay: a server that loses its
// last client starts anew, and turns away who comes then, which would be the next window of ours.
Display::Display() {
  connection = connect_to_display();
  if (connection) return;
  start_server();
  if (!why_not.empty())
    why_not +=
        "; install the package xvfb, or set DISPLAY, and draw again: swarf plot FOLDER, swarf render FOLDER";
}

void Display::start_server() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    why_not = "no X display, and no pipe for a private one";
    return;
  }
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) { // between fork and exec only calls that need no lock
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(127);
    setpgid(0, 0); // a Ctrl-C for us must not take the server away in the middle of a picture
    const int null = open("/dev/null", O_RDWR);
    dup2(null, 0), dup2(null, 1), dup2(null, 2);
    dup2(ends[1], 3); // clears close-on-exec
    if (ends[1] == 3) fcntl(3, F_SETFD, 0);
    execlp("Xvfb", "Xvfb", "-displayfd", "3", "-screen", "0", "1280x1024x24", "-nolisten", "tcp", "-noreset",
           static_cast<char*>(nullptr));
    _exit(127);
  }
  close(ends[1]);
  const std::string number = child > 0 ? read_display_number(ends[0]) : "";
  close(ends[0]);
  server = child > 0 ? child : 0;
  if (number.empty()) {
    why_not = "no X display, and no private one: Xvfb did not start";
    return;
  }
  setenv("DISPLAY", (":" + number).c_str(), 1);
  connection = connect_to_display();
  if (!connection) why_not = "no X display: the private Xvfb does not answer";
}

Display::~Display() {
  if (connection) find_in_x11<int(void*)>("XCloseDisplay")(connection);
  if (server <= 0) return;
  unsetenv("DISPLAY");
  kill(pid_t(server), SIGTERM);
  waitpid(pid_t(server), nullptr, 0);
}

std::string open_display() {
  static const Display display;
  return display.reason();
}

} // namespace swarf
