// Decks and windows that do not go together: refused with the file, the line, the key and what to do.
#include "src/windows/windows.hpp"
#include "tests/decks/good_deck.hpp"
#include <gmock/gmock.h>

using namespace swarf;
using namespace swarf::test;
using testing::HasSubstr;

namespace {

// The good deck covers immersions from 70 to 100 deg and runs from 65 to 95.
std::string with_windows(const std::string& windows, const std::string& deck = good_deck) {
  return deck + "[windows]\n" + windows;
}
const std::string inside = "first = \"85 deg\"\nlast = \"90 deg\"\nstep = \"5 deg\"\n";

std::string fault_of(const std::string& text) {
  const TemporaryFolder folder;
  try {
    const Deck deck = read_deck(folder.write("deck.toml", text));
    cut_windows(deck, *deck.windows);
  } catch (const DeckError& error) {
    return error.what();
  }
  return "no error";
}

} // namespace

TEST(WindowFaults, none_in_good_ones) {
  EXPECT_EQ(fault_of(with_windows(inside)), "no error");
  const Deck deck = read_text(with_windows(inside));
  EXPECT_EQ(cut_windows(deck, *deck.windows).size(), 2u);
}

TEST(WindowFaults, keys) {
  EXPECT_THAT(fault_of(with_windows("frist = \"10 deg\"\n")),
              HasSubstr("windows.frist: is not a known key. Did you mean \"first\"?"));
  EXPECT_THAT(fault_of(with_windows("width = \"4 um\"\n")), HasSubstr("windows.width: "));
  EXPECT_THAT(fault_of(with_windows("step = \"0 deg\"\n")), HasSubstr("more than 0 deg"));
  EXPECT_THAT(fault_of("windows = 3\n" + good_deck),
              HasSubstr(":1: windows: expected one section [windows]"));
}

TEST(WindowFaults, places) {
  const std::string line =
      "deck.toml:" + std::to_string(1 + std::count(good_deck.begin(), good_deck.end(), '\n'));
  EXPECT_THAT(fault_of(with_windows("first = \"90 deg\"\nlast = \"80 deg\"\n")),
              HasSubstr(line + ": windows.last: expected at least first = 90 deg, got 80 deg."));
  EXPECT_THAT(
      fault_of(with_windows("first = \"60 deg\"\nlast = \"60 deg\"\n")),
      HasSubstr(
          "windows.first: the window at 60 deg is measured from 57 to 63 deg, before tool.start_angle"));
  EXPECT_THAT(fault_of(with_windows("first = \"94 deg\"\nlast = \"94 deg\"\n")),
              HasSubstr("windows.last: the window at 94 deg is measured from 91 to 97 deg, past 95 deg"));
  EXPECT_THAT(
      fault_of(with_windows("first = \"69 deg\"\nlast = \"69 deg\"\n")),
      HasSubstr(
          "body \"cut zone\" of line 15 has no material there: it lies at immersions from 70 to 100 deg"));
  EXPECT_THAT(fault_of(with_windows("first = \"10 deg\"\nlast = \"170 deg\"\nstep = \"0.1 deg\"\n")),
              HasSubstr("windows.step: makes 1601 windows: expected at most 1000"));
}

TEST(WindowFaults, decks) {
  EXPECT_THAT(fault_of(with_windows(inside, edit_deck("end_immersion = \"95 deg\"", "end_time = \"1 ms\""))),
              HasSubstr("windows: need run.end_immersion instead of end_time"));
  const std::string block =
      "[[body]]\nname = \"b\"\nshape = \"block\"\nfill = \"hexes\"\nmaterial = \"ti64\"\n"
      "size = [\"1 um\", \"1 um\", \"1 um\"]\nspacing = \"1 um\"\n";
  EXPECT_THAT(fault_of(with_windows(inside, good_deck + block)),
              HasSubstr("body.shape: \"b\" is a block: windows are cut from rings only"));
  EXPECT_THAT(
      fault_of(with_windows(
          inside,
          edit_deck("diameter", "flutes = 8\ndiameter",
                    edit_deck("start_angle = \"-10 deg\"\nend_angle = \"20 deg\"\nspacing", "spacing",
                              edit_deck("start_angle = \"-10 deg\"\nend_angle = \"20 deg\"\ncells", "cells",
                                        edit_deck("end = { velocity = [\"0 m/s\", \"0 m/s\", \"1 mm/s\"] }\n",
                                                  "")))))),
      HasSubstr("windows: hold one tooth each, and 8 flutes cut an arc of 180 deg together"));
  EXPECT_THAT(
      fault_of(with_windows(inside, edit_deck("spindle_speed", "position = [\"100 um\", \"0 um\", \"0 um\"]\n"
                                                               "spindle_speed"))),
      HasSubstr("windows: need the mill's axis near the rings'"));
  EXPECT_THAT(
      fault_of(with_windows(inside, edit_deck("name = \"bulk\"", "name = \"bulk\"\norigin = [\"1 um\", \"0 "
                                                                 "um\", \"0 um\"]"))),
      HasSubstr("body.origin: \"bulk\" has another axis than \"cut zone\""));
}
