// Pictures need an X display, even off screen: the user's, or a private one for as long as this lives.
#pragma once
#include <string>

namespace swarf {

class Display {
 public:
  Display(); // never throws: ask ready()
  ~Display();
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  bool ready() const { return why_not.empty(); }
  const std::string& reason() const { return why_not; } // and what to do about it

 private:
  void start_server();
  std::string why_not;
  void* connection = nullptr; // to the display, for as long as this lives
  long server = 0;            // process of the private Xvfb, 0: none
};

// One display for the rest of the program's life. "" if there is one, else the reason why not.
std::string open_display();

} // namespace swarf
