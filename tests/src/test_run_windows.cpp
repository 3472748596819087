// Windows as the program runs them: side by side, kept, continued, and named where they fail.
#include "src/output/history.hpp"
#include "support/run_program.hpp"
#include "support/small_deck.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace {

// The small deck as a pass: the tooth goes on through its five degrees.
const std::string pass =
    edit_small_deck({{"end_immersion = \"86.5 deg\"", "end_immersion = \"90 deg\""},
                     {"[run]", "[windows]\nfirst = \"88 deg\"\nlast = \"88.6 deg\"\n"
                               "step = \"0.6 deg\"\nwidth = \"0.5 deg\"\nrun_in = \"0 deg\"\n"
                               "ahead = \"1.4 deg\"\n[run]"}});

std::vector<std::string> window_arguments(const std::string& deck, const fs::path& results,
                                          const std::vector<std::string>& more = {}) {
  std::vector<std::string> all{"run", deck, "--output", results.string(), "--no-pictures"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

void expect_joined(const fs::path& results, std::size_t rows) {
  const HistoryTable table = read_history(results / "windows.csv");
  ASSERT_EQ(table.rows(), rows);
  for (const double force : table.at("force_planar")) EXPECT_GT(force, 0);
  for (const double seconds : table.at("core_seconds")) EXPECT_GT(seconds, 0);
}

} // namespace

TEST(RunWindows, side_by_side_and_kept) {
  const TemporaryFolder folder;
  const std::string deck = write_deck(folder, pass);
  const Ended end = run_program(window_arguments(deck, folder / "results", {"--jobs", "2"}));
  ASSERT_EQ(end.status, 0) << end.output;
  expect_joined(folder / "results", 2);
  EXPECT_THAT(read_bytes(folder / "results/windows.json"),
              HasSubstr("\"predicted_core_seconds_of_whole_pass\": "));
  EXPECT_THAT(read_bytes(folder / "results/window_088.60/summary.json"), HasSubstr("\"threads\": 1"));
  const std::string table = read_bytes(folder / "results/windows.csv");

  // Again, with one window more: two are kept as they are. One is alone on the command line.
  const Ended again = run_program(window_arguments(deck, folder / "results", {"--windows", "88:89.2:0.6"}));
  ASSERT_EQ(again.status, 0) << again.output;
  EXPECT_THAT(again.output, HasSubstr("window 88 deg: complete already"));
  EXPECT_THAT(again.output, HasSubstr("window 88.6 deg: complete already"));
  EXPECT_THAT(again.output, HasSubstr("window 89.2 deg: starts"));
  expect_joined(folder / "results", 3);
  EXPECT_THAT(read_bytes(folder / "results/windows.csv"), HasSubstr(table));
}

TEST(RunWindows, one_that_fails_is_named_and_the_other_goes_on) {
  const TemporaryFolder folder;
  const std::string deck = write_deck(folder, pass);
  fs::create_directories(folder / "results");
  std::ofstream(folder / "results/window_088") << "no folder";
  const Ended end = run_program(window_arguments(deck, folder / "results"));
  EXPECT_EQ(end.status, 3) << end.output;
  EXPECT_THAT(end.output, HasSubstr("88 deg: failed with exit status 1: "));
  EXPECT_THAT(end.output, HasSubstr("cannot make the results folder"));
  EXPECT_THAT(end.output, HasSubstr("window 88.6 deg: complete"));
  expect_joined(folder / "results", 1);
  EXPECT_THAT(read_bytes(folder / "results/windows.json"), HasSubstr("\"unfinished\": \"window_088\""));
}

TEST(RunWindows, interrupted_and_resumed) {
  const TemporaryFolder folder;
  const std::string deck = write_deck(folder, pass);
  Program run(window_arguments(deck, folder / "results"));
  while (run.runs() && !fs::exists(folder / "results/window_088/checkpoint.h5")) pause_for(0.002);
  run.send(SIGINT); // to the parent only
  const Ended end = run.wait();
  ASSERT_EQ(end.status, 130) << end.output;
  EXPECT_THAT(end.output, HasSubstr("88 deg: interrupted"));
  EXPECT_THAT(end.output, HasSubstr("88.6 deg: not run"));
  const Ended rest = run_program(window_arguments(deck, folder / "results", {"--resume"}));
  ASSERT_EQ(rest.status, 0) << rest.output;
  EXPECT_THAT(rest.output, HasSubstr("window 88 deg: goes on"));
  const Ended whole = run_program(window_arguments(deck, folder / "truth"));
  ASSERT_EQ(whole.status, 0) << whole.output;
  EXPECT_EQ(read_bytes(folder / "results/window_088/history.csv"),
            read_bytes(folder / "truth/window_088/history.csv"));
}

TEST(RunWindows, refused) {
  const TemporaryFolder folder;
  const std::string deck = write_deck(folder, pass);
  const auto refuse = [&](const std::vector<std::string>& more, const std::string& message) {
    const Ended end = run_program(window_arguments(deck, folder / "results", more));
    EXPECT_EQ(end.status, 1) << end.output;
    EXPECT_THAT(end.output, HasSubstr(message));
    EXPECT_FALSE(fs::exists(folder / "results"));
  };
  refuse({"--windows", "10:20"}, "--windows 10:20: expected three numbers with : between them");
  refuse({"--windows", "x:20:1"}, "--windows x:20:1: \"x\" is not a number");
  refuse({"--windows", "10:20:0"}, "step must be more than 0 deg");
  refuse({"--stop-after", "10"}, "--stop-after does not go with windows");
  refuse({"--whole", "--jobs", "2"}, "--jobs counts windows");
}
