// Words for the user while a run goes on. A log that has gone away, or whose disk is full, takes them
// silently: it must not end a run.
#pragma once
#include <cstdio>
#include <fmt/format.h>

namespace swarf {

inline void say_text(std::FILE* to, const std::string& text) {
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), to));
  std::fflush(to);
  std::clearerr(to);
}

template <class... T>
void say(fmt::format_string<T...> text, T&&... values) {
  say_text(stdout, fmt::format(text, std::forward<T>(values)...));
}

// On stderr, after what was said before.
template <class... T>
void complain(fmt::format_string<T...> text, T&&... values) {
  std::fflush(stdout);
  say_text(stderr, "swarf: " + fmt::format(text, std::forward<T>(values)...) + "\n");
}

} // namespace swarf
