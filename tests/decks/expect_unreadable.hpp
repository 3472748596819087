// What reading a deck says is wrong with it.
#pragma once
#include "tests/decks/good_deck.hpp"
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace swarf::test {

inline std::string fault_of_reading(const std::string& text) {
  try {
    read_text(text);
  } catch (const DeckError& error) {
    return error.what();
  }
  return "no error";
}

inline void expect_unreadable(const std::string& text, const std::vector<std::string>& fragments) {
  const std::string message = fault_of_reading(text);
  for (const std::string& fragment : fragments)
    EXPECT_NE(message.find(fragment), std::string::npos) << fragment << "\n" << message;
}

} // namespace swarf::test
