// What is the user's stays: one run at a time in a folder, no input and no foreign file written over, nothing
// lost by signals, and folders that may be moved.
#include "src/files/folder_lock.hpp"
#include "src/files/results.hpp"
#include "src/output/history.hpp"
#include "src/output/write_hdf5.hpp"
#include "src/output/write_vtk.hpp"
#include "src/pictures/render.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/small_deck.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

namespace {

using Arguments = std::vector<std::string>;

Arguments plain_run(const std::string& deck, const fs::path& results, const Arguments& more = {}) {
  Arguments all{"run", deck, "--output", results.string(), "--threads", "1", "--no-pictures"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

// A block that flies at a tool of an STL file in the deck's folder, for a moment.
std::string stl_deck(const std::string& file) {
  return R"([material.steel]
law = "elastic"
density = "7800 kg/m3"
youngs_modulus = "200 GPa"
poissons_ratio = 0.3
[[body]]
name = "block"
shape = "block"
fill = "particles"
material = "steel"
origin = ["-20 um", "-20 um", "0.5 um"]
size = ["40 um", "40 um", "20 um"]
spacing = "10 um"
velocity = ["0 m/s", "0 m/s", "-100 m/s"]
[tool]
kind = "stl"
file = ")" +
         file + R"("
file_scale = "1 mm"
[contact]
friction = 0.0
[run]
courant = 0.3
end_time = "10 ns"
)";
}

// A box from (-50, -50, -100) to (50, 50, 0) um, in mm.
std::string box_stl() {
  const double lo = -0.05, hi = 0.05, down = -0.1;
  const double corner[8][3] = {{lo, lo, down}, {hi, lo, down}, {hi, hi, down}, {lo, hi, down},
                               {lo, lo, 0},    {hi, lo, 0},    {hi, hi, 0},    {lo, hi, 0}};
  const int facet[12][3] = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                            {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  std::string text = "solid box\n";
  for (const auto& f : facet) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int v : f)
      text += "vertex " + std::to_string(corner[v][0]) + " " + std::to_string(corner[v][1]) + " " +
              std::to_string(corner[v][2]) + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid box\n";
}

struct Folder : testing::Test {
  TemporaryFolder folder;
  const std::string deck = write_deck(folder, small_deck);
  const fs::path results = folder / "results";
  std::string summary() const { return read_bytes(results / "summary.json"); }
};

void expect_refused(const Arguments& arguments, const std::vector<std::string>& fragments) {
  const Ended end = run_program(arguments);
  EXPECT_EQ(end.status, 1) << end.output;
  for (const std::string& fragment : fragments) EXPECT_THAT(end.output, HasSubstr(fragment));
}

} // namespace

using ResultsFolderOfARun = Folder;

TEST_F(ResultsFolderOfARun, is_one_runs_at_a_time) {
  const std::string longer = write_deck(folder, edit_small_deck({{"86.5 deg", "89.5 deg"}}), "longer.toml");
  Program first(plain_run(longer, results));
  while (first.runs() && read_bytes(results / "history.csv").size() < 20000) pause_for(0.005);
  ASSERT_TRUE(first.runs());
  const std::string before = read_bytes(results / "deck.toml");
  for (const Arguments& second : {plain_run(longer, results), plain_run(longer, results, {"--overwrite"}),
                                  plain_run(longer, results, {"--resume"}),
                                  Arguments{"plot", results.string()}, Arguments{"render", results.string()}})
    expect_refused(second,
                   {results.string() + ": is being written by process ", "swarf", " run ", "--output"});
  EXPECT_TRUE(first.runs());
  EXPECT_EQ(read_bytes(results / "deck.toml"), before);
  first.send(SIGKILL), first.wait();
  const Ended end = run_program(plain_run(longer, results, {"--resume", "--stop-after", "1"}));
  EXPECT_EQ(end.status, 0) << "a killed run must leave no lock\n" << end.output;
  EXPECT_FALSE(fs::exists(results / "swarf.lock"));
}

TEST_F(ResultsFolderOfARun, a_lock_ends_with_its_holder) {
  {
    const FolderLock lock(results);
    EXPECT_THAT(message_of<ResultsError>([&] { FolderLock again(results); }),
                HasSubstr("is being written by process"));
  }
  EXPECT_EQ(message_of<ResultsError>([&] { FolderLock again(results); }), "");
}

// The run would cut the other file short and write its own name into it.
TEST_F(ResultsFolderOfARun, the_lock_follows_no_link) {
  fs::create_directories(results);
  std::ofstream(folder / "thesis.txt") << "of the user";
  fs::create_symlink(folder / "thesis.txt", results / "swarf.lock");
  const Ended end = run_program(plain_run(deck, results));
  EXPECT_EQ(end.status, 1) << end.output;
  EXPECT_THAT(end.output, HasSubstr("swarf.lock: is a link, a folder or a device"));
  EXPECT_EQ(read_bytes(folder / "thesis.txt"), "of the user");
}

TEST_F(ResultsFolderOfARun, is_replaced_only_when_asked) {
  ASSERT_EQ(run_program(plain_run(deck, results)).status, 0);
  const std::string history = read_bytes(results / "history.csv");
  fs::create_directories(results / "pictures");
  std::ofstream(results / "pictures/mine.png") << "mine";
  expect_refused(plain_run(deck, results),
                 {results.string() + ": holds the results of a run", "--resume", "--overwrite"});
  EXPECT_EQ(read_bytes(results / "history.csv"), history);
  const Ended end = run_program(plain_run(deck, results, {"--overwrite"}));
  EXPECT_EQ(end.status, 0) << end.output;
  EXPECT_EQ(read_bytes(results / "history.csv"), history);
  EXPECT_EQ(read_bytes(results / "pictures/mine.png"), "mine");
}

TEST_F(ResultsFolderOfARun, never_writes_over_an_input) {
  const std::string own = write_deck(folder, small_deck, "deck.toml");
  expect_refused(plain_run(own, folder.path), {"deck.toml: the results would be written over this file"});
  expect_refused(plain_run(own, folder.path, {"--overwrite"}),
                 {"deck.toml: the results would be written over this file"});
  EXPECT_EQ(read_bytes(own), small_deck);
  const TemporaryFolder other;
  other.write("tool.stl", box_stl());
  expect_refused(plain_run(other.write("t.toml", stl_deck("tool.stl")), other.path),
                 {"tool.stl: the results would be written over this file"});
  EXPECT_EQ(read_bytes(other / "tool.stl"), box_stl());
}

TEST_F(ResultsFolderOfARun, takes_no_file_of_others) {
  fs::create_directories(results / "pictures");
  std::ofstream(results / "pictures/force.png") << "mine";
  expect_refused(plain_run(deck, results, {"--overwrite"}), {"force.png: is in the way"});
  EXPECT_EQ(read_bytes(results / "pictures/force.png"), "mine");
}

TEST_F(ResultsFolderOfARun, goes_on_without_the_stl_it_came_from) {
  folder.write("t.stl", box_stl());
  const std::string with = write_deck(folder, stl_deck("t.stl"), "stl.toml");
  const Ended whole = run_program(plain_run(with, folder / "whole"));
  ASSERT_EQ(whole.status, 0) << whole.output;
  const Ended part = run_program(plain_run(with, results, {"--stop-after", "5"}));
  ASSERT_EQ(part.status, 0) << part.output;
  EXPECT_EQ(read_bytes(results / "tool.stl"), box_stl()) << "to the last byte";
  fs::create_directories(folder / "elsewhere");
  fs::rename(results, folder / "elsewhere/moved");
  fs::remove(folder / "t.stl");
  const fs::path moved = folder / "elsewhere/moved";
  EXPECT_EQ(run_program({"plot", moved.string()}).status, 0);
  const Ended rest = run_program(plain_run(with, moved, {"--resume"}));
  EXPECT_EQ(rest.status, 0) << rest.output;
  EXPECT_EQ(read_bytes(moved / "history.csv"), read_bytes(folder / "whole/history.csv"));
  const Ended own = run_program(plain_run((moved / "deck.toml").string(), moved, {"--resume"}));
  EXPECT_EQ(own.status, 0) << "with its own deck\n" << own.output;
}

TEST_F(ResultsFolderOfARun, says_which_frames_are_missing) {
  ASSERT_EQ(run_program(plain_run(deck, results)).status, 0);
  fs::remove(results / "frames/frame_0001_hexes.vtu");
  const Ended end = run_program(plain_run(deck, results, {"--resume"}));
  EXPECT_EQ(end.status, 0) << end.output;
  EXPECT_THAT(end.output, HasSubstr("1 file(s) of the earlier frames are missing: " +
                                    (results / "frames/frame_0001_hexes.vtu").string()));
}

// Bytes that VTK would believe: each is found before VTK sees it.
// The pictures of the other frames are drawn, and the exit status says that one is not.
TEST_F(ResultsFolderOfARun, a_frame_that_is_gone_or_empty_is_said) {
  run_program(plain_run(deck, results));
  const std::vector<FrameEntry> frames = read_frame_list(ResultsFolder{results});
  ASSERT_GE(frames.size(), 3u);
  const auto drawn = choose_frames(frames, {}, {});
  const fs::path gone = frame_file(ResultsFolder{results}, drawn.front().index, "particles");
  const fs::path empty = frame_file(ResultsFolder{results}, drawn.back().index, "particles");
  fs::remove(gone);
  std::ofstream(empty, std::ios::trunc).close();
  const Ended end = run_program({"render", results.string()});
  EXPECT_EQ(end.status, 1) << end.output;
  if (end.output.find("no display") != std::string::npos || end.output.find("Xvfb") != std::string::npos)
    GTEST_SKIP() << end.output;
  EXPECT_THAT(end.output,
              HasSubstr(gone.filename().string() + ": is missing, though frames.csv lists it; copy it"));
  EXPECT_THAT(end.output, HasSubstr(empty.filename().string() + ": is not what the run wrote"));
  EXPECT_THAT(end.output, Not(HasSubstr("output.frame_time")));
  EXPECT_EQ(fs::exists(results / "pictures" / "chip.png"), drawn.size() > 2)
      << "of the frames that are there";
}

TEST_F(ResultsFolderOfARun, damaged_frames_are_named) {
  ASSERT_EQ(run_program(plain_run(deck, results)).status, 0);
  const fs::path file = results / "frames/frame_0001_particles.vtu";
  const std::string whole = read_bytes(file);
  for (const std::size_t at : {whole.size() / 10, whole.size() / 2, whole.size() - 200}) {
    std::string damaged = whole;
    damaged[at] = char(damaged[at] ^ 0x55);
    std::ofstream(file, std::ios::binary) << damaged;
    const Ended end = run_program({"render", results.string()});
    EXPECT_EQ(end.status, 1) << end.output;
    if (end.output.find("no display") == std::string::npos && end.output.find("Xvfb") == std::string::npos) {
      EXPECT_THAT(end.output, HasSubstr("frame_0001_particles.vtu: is not what the run wrote"));
    }
  }
}

using EndOfARun = Folder;

TEST_F(EndOfARun, every_signal_that_asks_for_it_leaves_a_checkpoint) {
  const std::string longer = write_deck(folder, edit_small_deck({{"86.5 deg", "120 deg"}}), "longer.toml");
  for (const int signal : {SIGTERM, SIGHUP, SIGUSR1, SIGXCPU, SIGQUIT, SIGALRM}) {
    fs::remove_all(results);
    Program run(plain_run(longer, results));
    while (run.runs() && read_bytes(results / "history.csv").size() < 20000) pause_for(0.005);
    run.send(signal);
    const Ended end = run.wait();
    EXPECT_EQ(end.status, 130) << end.output;
    EXPECT_THAT(end.output, HasSubstr("checkpoint written; continue with: swarf run "));
    EXPECT_THAT(summary(), HasSubstr("\"ended\": \"interrupted\",\n  \"why\": \"SIG"));
    double time = 0;
    CheckpointReader(results / "checkpoint.h5").get("time", time);
    EXPECT_EQ(time, read_history(results / "history.csv").rows() > 0 ? time : -1);
    EXPECT_GT(time, 1e-6);
  }
}

TEST_F(EndOfARun, a_log_that_goes_away_stops_nothing) {
  const std::string command = "'" SWARF_PROGRAM "' run '" + deck + "' --output '" + results.string() +
                              "' --threads 1 --no-pictures | head -c 1 >/dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_THAT(summary(), HasSubstr("\"ended\": \"complete\""));
}

TEST_F(EndOfARun, closed_streams_become_no_results) {
  const std::string command = "'" SWARF_PROGRAM "' run '" + deck + "' --output '" + results.string() +
                              "' --threads 1 --no-pictures <&- >&- 2>&-";
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_THAT(summary(), HasSubstr("\"ended\": \"complete\""));
  for (const auto& entry : fs::recursive_directory_iterator(results))
    if (entry.is_regular_file()) {
      EXPECT_THAT(read_bytes(entry.path()), Not(HasSubstr("particle-steps/s |"))) << entry.path();
    }
  EXPECT_GT(read_history(results / "history.csv").rows(), 50u);
}

// The limit kills a program that does not look: this one says what to do, also before its first checkpoint.
TEST_F(EndOfARun, a_limit_on_files_is_a_message) {
  const Ended end = run_program(plain_run(deck, results), 150 * 1024);
  EXPECT_EQ(end.status, 1) << end.output;
  EXPECT_THAT(end.output,
              AllOf(HasSubstr("File too large"), HasSubstr("raise the limit on file sizes (ulimit -f)"),
                    HasSubstr("No last checkpoint")));
  EXPECT_THAT(summary(), HasSubstr("\"ended\": \"failed\""));
  EXPECT_FALSE(fs::exists(results / "checkpoint.h5.tmp"));
}

TEST_F(EndOfARun, is_the_time_that_was_asked_for) {
  ASSERT_EQ(run_program(plain_run(deck, results)).status, 0);
  const double end = (86.5 - 84.8) / 360 * 60 / 10000; // s, from 84.8 to 86.5 deg at 10000 rpm
  const HistoryTable history = read_history(results / "history.csv");
  EXPECT_NEAR(history.at("time").back(), end, 1e-15);
  EXPECT_NEAR(history.at("immersion").back(), 86.5, 1e-9);
  EXPECT_EQ(read_frame_list(ResultsFolder{results}).back().time, history.at("time").back());
}

TEST_F(EndOfARun, of_a_stopped_run_is_not_called_complete) {
  const Ended end = run_program(plain_run(deck, results, {"--stop-after", "40"}));
  ASSERT_EQ(end.status, 0) << end.output;
  EXPECT_THAT(summary(), HasSubstr("\"ended\": \"stopped\",\n  \"why\": \"--stop-after 40\""));
  const Ended rest = run_program(plain_run(deck, results, {"--resume"}));
  ASSERT_EQ(rest.status, 0) << rest.output;
  EXPECT_THAT(summary(), HasSubstr("\"ended\": \"complete\""));
  ASSERT_EQ(run_program(plain_run(deck, folder / "whole")).status, 0);
  EXPECT_EQ(read_bytes(results / "history.csv"), read_bytes(folder / "whole/history.csv"));
  EXPECT_EQ(read_bytes(results / "frames.csv"), read_bytes(folder / "whole/frames.csv"));
}

using Resume = Folder;

TEST_F(Resume, a_later_end_is_the_longer_run) {
  ASSERT_EQ(run_program(plain_run(deck, results)).status, 0);
  const std::string longer =
      write_deck(folder,
                 edit_small_deck(
                     {{"86.5 deg", "87 deg"},
                      {"a small cut", "a longer cut"},
                      {"[output]", "[output]\npicture_field = \"von_mises\"\nfilter_frequency = \"1 MHz\""}}),
                 "longer.toml");
  const Ended rest = run_program(plain_run(longer, results, {"--resume"}));
  ASSERT_EQ(rest.status, 0) << rest.output;
  ASSERT_EQ(run_program(plain_run(longer, folder / "whole")).status, 0);
  EXPECT_EQ(read_bytes(results / "history.csv"), read_bytes(folder / "whole/history.csv"));
  EXPECT_EQ(read_bytes(results / "deck.toml"), read_bytes(folder / "whole/deck.toml"));
  expect_refused(plain_run(write_deck(folder, edit_small_deck({{"86.5 deg", "85 deg"}}), "early.toml"),
                           results, {"--resume"}),
                 {"run.end_immersion asks for an end at", "Give a later end"});
}

TEST_F(Resume, more_frames_from_here_on) {
  ASSERT_EQ(run_program(plain_run(deck, results, {"--stop-after", "300"})).status, 0);
  const auto before = read_frame_list(ResultsFolder{results}).size();
  const std::string often = write_deck(
      folder, edit_small_deck({{"frame_immersion = \"0.5 deg\"", "frame_immersion = \"0.1 deg\""}}),
      "often.toml");
  const Ended rest = run_program(plain_run(often, results, {"--resume"}));
  ASSERT_EQ(rest.status, 0) << rest.output;
  EXPECT_GT(read_frame_list(ResultsFolder{results}).size(), before + 5);
}

TEST_F(Resume, names_each_key_that_must_not_change) {
  ASSERT_EQ(run_program(plain_run(deck, results, {"--stop-after", "20"})).status, 0);
  const std::string other = write_deck(
      folder, edit_small_deck({{"mass_factor = 1e5", "mass_factor = 2e5"}, {"n = 0.34", "n = 0.35"}}),
      "other.toml");
  expect_refused(plain_run(other, results, {"--resume"}),
                 {"[run] mass_factor = 200000.0, was 100000.0", "[material.ti64] n = 0.35, was 0.34"});
}
