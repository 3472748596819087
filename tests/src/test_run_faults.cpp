// The program told or made to fail: exit status, message, and what it leaves behind.
#include "src/files/results.hpp"
#include "src/output/history.hpp"
#include "src/output/write_hdf5.hpp"
#include "src/output/write_vtk.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/small_deck.hpp"
#include "tests/verification/drive.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>

using namespace swarf;
using namespace swarf::test;
using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;
namespace fs = std::filesystem;

namespace {

using Arguments = std::vector<std::string>;

Arguments operator+(Arguments a, const Arguments& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// The first steps of the small deck, with a checkpoint at the start and one at step 30 or so.
void run_shortly(const std::string& deck, const fs::path& results) {
  const Ended end = run_program(run_arguments(deck, results) + Arguments{"--stop-after", "40"});
  ASSERT_EQ(end.status, 0) << end.output;
}

void expect_failure(const Ended& end, int status, const std::vector<std::string>& fragments) {
  EXPECT_EQ(end.status, status) << end.output;
  for (const std::string& fragment : fragments) EXPECT_THAT(end.output, HasSubstr(fragment));
}

std::map<std::string, std::string> read_folder(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[entry.path().string()] = read_bytes(entry.path());
  return files;
}

// A whole checkpoint, history and frames; times of the last of each, in s.
struct LastTimes {
  double checkpoint = 0, history = 0, frame = 0;
};
LastTimes read_results(const fs::path& results) {
  LastTimes last;
  CheckpointReader(results / "checkpoint.h5").get("time", last.checkpoint);
  const HistoryTable history = read_history(results / "history.csv");
  if (history.rows() > 0) last.history = history.at("time").back();
  const std::vector<FrameEntry> frames = read_frame_list(ResultsFolder{results});
  if (!frames.empty()) last.frame = frames.back().time;
  for (const FrameEntry& entry : frames)
    EXPECT_THAT(read_bytes(frame_file(ResultsFolder{results}, entry.index, "particles")),
                AllOf(HasSubstr("<VTKFile"), HasSubstr("</VTKFile>")));
  return last;
}

struct RunFaults : testing::Test {
  TemporaryFolder folder;
  const std::string deck = write_deck(folder, small_deck);
  const fs::path results = folder / "results";
};

} // namespace

TEST_F(RunFaults, missing_deck) {
  const std::string none = (folder / "none.toml").string();
  expect_failure(run_program(run_arguments(none, results)), 1, {"swarf: ", none});
  EXPECT_FALSE(fs::exists(results));
}

TEST_F(RunFaults, wrong_command_line) {
  EXPECT_NE(run_program({}).status, 0);
  expect_failure(run_program({"run", deck, "--threads", "-1"}), 105, {"--threads"});
  EXPECT_NE(run_program({"mill", deck}).status, 0);
}

TEST_F(RunFaults, nothing_to_resume) {
  expect_failure(run_program(run_arguments(deck, results, true)), 1,
                 {results.string() + ": no such results folder", "give the folder that a run wrote"});
  run_shortly(deck, results);
  fs::remove(results / "checkpoint.h5");
  const auto before = read_folder(results);
  expect_failure(run_program(run_arguments(deck, results, true)), 1,
                 {"checkpoint.h5: there is no such checkpoint", "start the run anew with --overwrite"});
  EXPECT_TRUE(read_folder(results) == before);
}

TEST_F(RunFaults, truncated_checkpoint) {
  run_shortly(deck, results);
  fs::resize_file(results / "checkpoint.h5", fs::file_size(results / "checkpoint.h5") / 2);
  const auto before = read_folder(results);
  expect_failure(run_program(run_arguments(deck, results, true)), 1,
                 {"checkpoint.h5: the checkpoint is cut short or damaged", "start the run anew"});
  EXPECT_TRUE(read_folder(results) == before);
}

TEST_F(RunFaults, checkpoint_of_another_deck) {
  run_shortly(deck, results);
  const auto before = read_folder(results);
  const std::string other =
      write_deck(folder, edit_small_deck({{"friction = 0.5", "friction = 0.4"}}), "other.toml");
  expect_failure(run_program(run_arguments(other, results, true)), 1,
                 {"checkpoint.h5: belongs to another deck", "[contact] friction = 0.4, was 0.5",
                  "Resume with the values it was written with"});
  EXPECT_TRUE(read_folder(results) == before)
      << "nothing may be overwritten before the deck is known to be right";
}

TEST_F(RunFaults, history_cut_after_the_run) {
  run_shortly(deck, results);
  const std::string header = read_bytes(results / "history.csv");
  fs::resize_file(results / "history.csv", header.find('\n') + 1);
  expect_failure(run_program(run_arguments(deck, results, true)), 1, {"history.csv: holds 0 samples"});
}

// Not after the hours of the rest of the run.
TEST_F(RunFaults, history_damaged_after_the_run) {
  run_shortly(deck, results);
  std::string text = read_bytes(results / "history.csv");
  const auto third = text.find('\n', text.find('\n', text.find('\n') + 1) + 1) + 1;
  text[third] = 'x';
  std::ofstream(results / "history.csv", std::ios::binary) << text;
  const auto before = read_folder(results);
  expect_failure(run_program(run_arguments(deck, results, true)), 1,
                 {"history.csv:4: expected ", " numbers, found 'x", "copy it again or start the run anew"});
  EXPECT_TRUE(read_folder(results) == before);
}

TEST_F(RunFaults, output_folder_that_cannot_be) {
  std::ofstream(folder / "file") << "not a folder";
  expect_failure(run_program(run_arguments(deck, folder / "file" / "results")), 1,
                 {"file/results: cannot make the results folder: Not a directory", "--output"});
}

TEST_F(RunFaults, full_disk_at_the_start) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  fs::create_directories(results);
  fs::create_symlink("/dev/full", results / "deck.toml.tmp");
  expect_failure(run_program(run_arguments(deck, results)), 1,
                 {"deck.toml: cannot write the results: No space left on device", "free some space"});
  fs::remove(results / "deck.toml.tmp");
  fs::create_symlink("/dev/full", results / "checkpoint.h5.tmp");
  expect_failure(run_program(run_arguments(deck, results)), 1,
                 {"checkpoint.h5: the checkpoint cannot", "free some space"});
}

// A limit on the size of files stands for a disk that fills up: the history passes it in the middle of the
// run.
TEST_F(RunFaults, full_disk_in_the_middle) {
  const std::string often = write_deck(folder, edit_small_deck({{"history_steps = 10", "history_steps = 1"},
                                                                {"\"1.5 us\"", "\"1 s\""},
                                                                {"86.5 deg", "98 deg"}}));
  run_shortly(often, results);
  const rlim_t limit = fs::file_size(results / "checkpoint.h5") + 20000;
  const Ended end = run_program(run_arguments(often, results), limit);
  expect_failure(end, 1,
                 {"history.csv: cannot write the history: File too large", "ulimit -f",
                  "A last checkpoint has been written"});
  const LastTimes last = read_results(results);
  EXPECT_GT(last.history, 0);
  EXPECT_GE(last.checkpoint, last.history) << "the steps of the sample that found no room are not lost";
  const Ended resumed = run_program(run_arguments(often, results, true) + Arguments{"--stop-after", "40"});
  EXPECT_EQ(resumed.status, 0) << resumed.output;
}

// The largest step and pressure diffusion that a deck may have: the stable step knows nothing of the latter.
TEST_F(RunFaults, unstable_run) {
  const std::string wild =
      write_deck(folder, edit_small_deck({{"courant = 0.3", "courant = 1\nenergy_limit = \"1000 %\""},
                                          {"smoothing_length = \"fixed\"",
                                           "smoothing_length = \"fixed\"\npressure_diffusion = 1"}}));
  const Ended end = run_program(run_arguments(wild, results));
  EXPECT_EQ(end.status, 3) << end.output;
  EXPECT_THAT(end.output,
              testing::ContainsRegex("swarf: the run became unstable: .*particle [0-9]+ \\(row "
                                     "[0-9]+\\) at \\(.*\\) m; t = [0-9.e-]+ s, step [0-9]+\\. Try a "
                                     "smaller run\\.courant"));
  const LastTimes last = read_results(results);
  EXPECT_GT(last.checkpoint, 0);
  EXPECT_EQ(last.frame, last.checkpoint);
  EXPECT_LT(last.history, last.frame) << "the state that failed is no sample";
  for (const auto& column : read_history(results / "history.csv").values)
    for (const double value : column) EXPECT_TRUE(std::isfinite(value));
  EXPECT_THAT(read_bytes(results / "summary.json"),
              AllOf(HasSubstr("\"ended\": \"failed\""), HasSubstr("\"why\": \"the run became unstable")));
  EXPECT_TRUE(fs::exists(results / "results.h5"));

  const Ended again = run_program(run_arguments(wild, results, true));
  EXPECT_EQ(again.status, 3) << "a run that failed must not go on as if nothing had been\n" << again.output;
}

// Fewer steps than may pass unseen: what failed on the way must not pass at the end.
TEST_F(RunFaults, unstable_in_the_last_steps) {
  const Ended end = run_program(run_arguments(write_deck(folder, R"([material.m]
law = "elastic"
density = "4430 kg/m3"
youngs_modulus = "110 GPa"
poissons_ratio = 0.33
[[body]]
name = "bar"
shape = "block"
fill = "hexes"
material = "m"
size = ["4 mm", "4 mm", "4 mm"]
cells = [4, 4, 4]
velocity = ["-5000 m/s", "0 m/s", "0 m/s"]
[body.faces]
x_min = "fixed"
[hexes]
viscosity_linear = 0
viscosity_quadratic = 0
[run]
end_time = "2 us"
energy_limit = "1e6 %"
[output]
history_steps = 1000000
)"),
                                              results));
  EXPECT_EQ(end.status, 3) << end.output;
  EXPECT_THAT(end.output, testing::ContainsRegex("hex [0-9]+ \\(row [0-9]+\\) at "));
}

namespace {

// Hexes alone, sampled never: nothing but the bound on unseen steps makes the run look.
Deck unsampled_bar() {
  Deck deck = shipped_defaults();
  deck.materials = {titanium()};
  deck.bodies = {block("bar", "hexes", {0, 0, 0}, {4e-3, 1e-3, 1e-3}, 1e-3)};
  deck.bodies[0].velocity = {1, 0, 0};
  deck.output.history_steps = 1000000;
  return deck;
}

// Steps until a fault is thrown after `spoil` has gone at the velocities, and what it says.
template <class Spoil>
std::pair<long, std::string> steps_until_seen(const Spoil& spoil) {
  Simulation simulation(unsampled_bar());
  simulation.start();
  for (int k = 0; k < 30; ++k) simulation.step();
  const VectorField velocity = simulation.scene().hexes.velocity;
  const auto v = host_copy(velocity);
  spoil(v);
  Kokkos::deep_copy(velocity, v);
  try {
    for (int k = 0; k < 1000; ++k) {
      simulation.step();
      if (simulation.steps_to_check() > 0) continue;
      simulation.check(), simulation.take_sample();
    }
  } catch (const SimulationFault& fault) {
    return {simulation.step_count() - 30, fault.what()};
  }
  return {-1, "no fault"};
}

} // namespace

TEST_F(RunFaults, are_seen_within_a_bounded_number_of_steps) {
  const auto [steps, what] =
      steps_until_seen([](const auto& v) { v(0, 0) = std::numeric_limits<Real>::quiet_NaN(); });
  EXPECT_LE(steps, Simulation::most_unseen_steps);
  EXPECT_THAT(what, HasSubstr("not a finite number, in hex "));
}

// All numbers finite, all hexes whole: only the balance shows it.
TEST_F(RunFaults, energy_out_of_nothing) {
  const auto [steps, what] = steps_until_seen([](const auto& v) {
    for (std::size_t i = 0; i < v.extent(0); ++i) v(i, 0) = 200;
  });
  EXPECT_GT(steps, 0);
  EXPECT_LE(steps, Simulation::most_unseen_steps);
  EXPECT_THAT(what,
              testing::ContainsRegex("it has made .* J of energy and was given .* J; fastest, 200 m/s: node "
                                     "[0-9]+ at \\(.*\\) m; t = "));
}

TEST_F(RunFaults, tool_inside_the_workpiece) {
  const std::string inside =
      write_deck(folder, edit_small_deck({{"start_angle = \"84.8 deg\"", "start_angle = \"86.2 deg\""}}));
  expect_failure(run_program(run_arguments(inside, results)), 1,
                 {"deck.toml:", "tool.position: the tool overlaps body \"cut zone\" of line 17 by ",
                  " um at the start"});
  EXPECT_FALSE(fs::exists(results));
}

TEST_F(RunFaults, missing_stl) {
  const std::string text = small_deck.substr(0, small_deck.find("[tool]")) +
                           "[tool]\nkind = \"stl\"\nfile = \"none.stl\"\n" +
                           small_deck.substr(small_deck.find("[contact]"));
  std::string timed = text;
  timed.replace(timed.find("end_immersion = \"86.5 deg\""), 26, "end_time = \"1 us\"");
  timed.replace(timed.find("frame_immersion = \"0.5 deg\"\n"), 28, "");
  timed.replace(timed.find("previous_tooth = true\n"), 22, "");
  expect_failure(run_program(run_arguments(write_deck(folder, timed), results)), 1,
                 {(folder / "none.stl").string()});
  EXPECT_FALSE(fs::exists(results));
}

TEST_F(RunFaults, faulty_deck_leaves_earlier_results) {
  run_shortly(deck, results);
  const auto before = read_folder(results);
  for (const Edits& edits :
       {Edits{{"friction = 0.5", "fricton = 0.5"}}, Edits{{"\"84.8 deg\"", "\"86.2 deg\""}},
        Edits{{"tie = \"bulk\"", "tie = \"bull\""}}}) {
    const std::string faulty = write_deck(folder, edit_small_deck(edits), "faulty.toml");
    expect_failure(run_program(run_arguments(faulty, results)), 1, {"faulty.toml"});
    EXPECT_TRUE(read_folder(results) == before) << edits.front().second;
  }
}

// A body at rest is soon as fast as the tool: the lists must be looked at in time all the same.
TEST_F(RunFaults, none_where_samples_are_rare) {
  const std::string rare =
      write_deck(folder, edit_small_deck({{"history_steps = 10", "history_steps = 1000000"}}));
  const Ended end = run_program(run_arguments(rare, results));
  EXPECT_EQ(end.status, 0) << end.output;
}
