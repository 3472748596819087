// A run that is killed, interrupted or spread over threads ends in the same bytes as one that is not.
#include "src/files/results.hpp"
#include "src/output/history.hpp"
#include "src/output/write_hdf5.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/small_deck.hpp"
#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <random>

using namespace swarf;
using namespace swarf::test;
using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace {

// Every file of a results folder; of the summary all but the times that the run took.
std::map<std::string, std::string> read_folder(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::string bytes = read_bytes(entry.path());
    if (entry.path().filename() == "summary.json") bytes.resize(bytes.find("\"cost\""));
    files[fs::relative(entry.path(), folder).string()] = bytes;
  }
  return files;
}

void expect_equal(const fs::path& truth, const fs::path& other) {
  const auto a = read_folder(truth), b = read_folder(other);
  for (const char* name : {"history.csv", "results.h5", "frames.pvd", "checkpoint.h5", "deck.toml",
                           "summary.json", "frames/frame_0000_particles.vtu"})
    EXPECT_TRUE(a.contains(name)) << name;
  for (const auto& [name, bytes] : a) EXPECT_TRUE(b.contains(name) && b.at(name) == bytes) << name;
  for (const auto& [name, bytes] : b) EXPECT_TRUE(a.contains(name)) << name << " is too many";
}

// Returns the length of its history.
std::size_t run_whole(const std::string& deck, const fs::path& results, int threads = 1) {
  const Ended end = run_program(run_arguments(deck, results, false, threads));
  EXPECT_EQ(end.status, 0) << end.output;
  return fs::file_size(results / "history.csv");
}

// Kills the run `kills` times, each at a random moment of its own share of the run, then lets it end. The
// history's length says how far it is: a time would not, on a machine with other work.
void run_with_kills(const std::string& deck, const fs::path& results, std::size_t whole_history, int kills) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  int killed = 0;
  for (int k = 0; k <= kills; ++k) {
    Program run(run_arguments(deck, results, fs::exists(results / "checkpoint.h5")));
    if (k < kills) {
      const auto until = std::size_t((k + share(random)) / kills * double(whole_history));
      while (run.runs() && read_bytes(results / "history.csv").size() < until) pause_for(0.002);
      pause_for(0.02 * share(random)); // somewhere in a step, a frame or a checkpoint
      killed += run.runs() ? 1 : 0, run.send(SIGKILL);
    }
    const Ended end = run.wait();
    EXPECT_TRUE(end.status == 0 || (k < kills && end.status == 128 + SIGKILL)) << end.status << end.output;
  }
  EXPECT_GE(killed, kills / 2) << "most kills came too late";
}

double largest_component(const CheckpointReader& checkpoint, const std::string& field) {
  VectorField values;
  checkpoint.get(field, values);
  const auto host = host_copy(values);
  double largest = 0;
  for (std::size_t i = 0; i < host.extent(0); ++i)
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(double(host(i, c))));
  return largest;
}

// Of the run in "whole", whose history has so many bytes.
void expect_kills_and_threads_change_nothing(const TemporaryFolder& folder, const std::string& deck,
                                             std::size_t whole, int kills) {
  run_with_kills(deck, folder / "killed", whole, kills);
  expect_equal(folder / "whole", folder / "killed");
  run_whole(deck, folder / "two threads", 2);
  expect_equal(folder / "whole", folder / "two threads");
}

} // namespace

TEST(Restart, killed_at_random_times) {
  const TemporaryFolder folder;
  const std::string deck = write_deck(folder, small_deck);
  const std::size_t whole = run_whole(deck, folder / "whole");
  const CheckpointReader checkpoint(folder / "whole" / "checkpoint.h5");
  EXPECT_GT(largest_component(checkpoint, "particles/friction_force"), 0);
  EXPECT_GT(largest_component(checkpoint, "hexes/velocity"), 0);
  run_with_kills(deck, folder / "killed", whole, 6);
  expect_equal(folder / "whole", folder / "killed");
}

// The options that carry more state: summed density, deleted hexes.
TEST(Restart, killed_with_other_methods) {
  const TemporaryFolder folder;
  const std::string deck = write_deck(
      folder, edit_small_deck({{"\"fixed\"\n[hexes]", "\"fixed\"\ndensity = \"summation\"\n[hexes]"},
                               {"\"stiffness\"", "\"viscous\"\ndelete_at_strain = 1e-6"}}));
  const std::size_t whole = run_whole(deck, folder / "whole");
  IndexField active;
  CheckpointReader(folder / "whole" / "checkpoint.h5").get("hexes/active", active);
  const auto left = host_copy(active);
  EXPECT_GT(std::count(left.data(), left.data() + left.extent(0), 0), 0) << "no hex was deleted";
  run_with_kills(deck, folder / "killed", whole, 3);
  expect_equal(folder / "whole", folder / "killed");
}

// And an evolving smoothing length, by which dt changes on the way, with the diffusion that changes the
// density.
TEST(Restart, killed_with_an_evolving_smoothing_length) {
  const TemporaryFolder folder;
  const std::string deck = write_deck(
      folder, edit_small_deck({{"\"fixed\"\n[hexes]", "\"evolving\"\npressure_diffusion = 0.003\n[hexes]"}}));
  const std::size_t whole = run_whole(deck, folder / "whole");
  run_with_kills(deck, folder / "killed", whole, 3);
  expect_equal(folder / "whole", folder / "killed");
}

// Lists, kernels and volumes of the initial positions, which a restart must find again; no heat flows there.
TEST(Restart, killed_in_the_initial_frame) {
  const TemporaryFolder folder;
  const std::string deck = write_deck(
      folder,
      edit_small_deck({{"conductivity = \"7.2 W/m/K\"\n", ""},
                       {"\"fixed\"\n[hexes]",
                        "\"fixed\"\nkernel_frame = \"initial\"\nhourglass_stiffness = 1.0\n[hexes]"}}));
  const std::size_t whole = run_whole(deck, folder / "whole");
  run_with_kills(deck, folder / "killed", whole, 3);
  expect_equal(folder / "whole", folder / "killed");
}

// The tool's cells, what is on its way to them, and the pace of it.
TEST(Restart, killed_while_the_tool_takes_heat) {
  const TemporaryFolder folder;
  const std::string deck = write_deck(
      folder,
      edit_small_deck({{"[[body]]", "[material.wc]\nlaw = \"rigid\"\ndensity = \"15000 kg/m3\"\n"
                                    "specific_heat = \"203 J/kg/K\"\nconductivity = \"46 W/m/K\"\n[[body]]"},
                       {"[tool]\n", "[tool]\nmaterial = \"wc\"\nheld_beyond = \"20 um\"\n"}}));
  const std::size_t whole = run_whole(deck, folder / "whole");
  ScalarField cells;
  CheckpointReader(folder / "whole" / "checkpoint.h5").get("tool/temperature", cells);
  const auto T = host_copy(cells);
  EXPECT_GT(*std::max_element(T.data(), T.data() + T.extent(0)), 300);
  const HistoryTable history = read_history(folder / "whole" / "history.csv");
  const double made = history.at("plastic_heat").back() + history.at("friction_work").back();
  EXPECT_GT(history.at("tool_heat").back(), 0.01 * made);
  EXPECT_LT(std::abs(history.at("heat_residual").back()), 1e-3 * made);
  expect_kills_and_threads_change_nothing(folder, deck, whole, 3);
}

TEST(Restart, killed_while_parts_are_frozen) {
  const TemporaryFolder folder;
  Edits edits = longer_sector;
  edits.push_back({"[run]", "[sleep]\ndistance = \"32 um\"\nspeed = 1.0\n[run]"});
  const std::string deck = write_deck(folder, edit_small_deck(edits));
  const std::size_t whole = run_whole(deck, folder / "whole");
  int active = 0;
  CheckpointReader(folder / "whole" / "checkpoint.h5").get("active", active);
  EXPECT_LT(active, 1200); // of 1440
  expect_kills_and_threads_change_nothing(folder, deck, whole, 3);
}

TEST(Restart, killed_while_chip_leaves) {
  const TemporaryFolder folder;
  const std::string deck = write_deck(
      folder, edit_small_deck({{"[tool]", loose_chip(372, -1.2) + "[tool]"},
                               {"[run]", "[sleep]\ndistance = \"32 um\"\n[retire]\ndistance = \"14 um\"\n"
                                         "[run]"}}));
  const std::size_t whole = run_whole(deck, folder / "whole");
  EXPECT_THAT(read_bytes(folder / "whole" / "summary.json"), HasSubstr("\"retired\""));
  expect_kills_and_threads_change_nothing(folder, deck, whole, 3);
}

// One body of hexes, of which more and more become particles ahead of the tooth.
TEST(Restart, killed_while_hexes_become_particles) {
  const TemporaryFolder folder;
  const auto second = small_deck.find("[[body]]", small_deck.find("[[body]]") + 1);
  std::string text = small_deck.substr(0, small_deck.find("[[body]]")) + small_deck.substr(second);
  for (const auto& [from, to] :
       Edits{{"inner_radius = \"415 um\"", "inner_radius = \"400 um\"\nprevious_tooth = true"},
             {"cells = [7, 2, 6]", "cells = [7, 2, 9]\nconvert_distance = \"8 um\""}})
    text.replace(text.find(from), from.size(), to);
  const std::string deck = write_deck(folder, text);
  const std::size_t whole = run_whole(deck, folder / "whole");
  const HistoryTable history = read_history(folder / "whole" / "history.csv");
  const auto& lost = history.at("tie_work");
  EXPECT_EQ(lost.front(), 0);
  EXPECT_GT(lost.back(), lost[lost.size() / 2]) << "no hex became particles on the way";
  expect_kills_and_threads_change_nothing(folder, deck, whole, 4);
}

TEST(Restart, threads_and_repetition_change_no_byte) {
  const TemporaryFolder folder;
  const std::string deck = write_deck(folder, small_deck);
  run_whole(deck, folder / "first"), run_whole(deck, folder / "second");
  expect_equal(folder / "first", folder / "second");
  run_whole(deck, folder / "two threads", 2);
  expect_equal(folder / "first", folder / "two threads");
}

TEST(Restart, interrupted_run_says_how_to_continue) {
  const TemporaryFolder folder;
  const std::string deck = write_deck(folder, small_deck);
  run_whole(deck, folder / "whole");
  const fs::path results = folder / "interrupted";
  Program run(run_arguments(deck, results));
  while (run.runs() && read_bytes(results / "history.csv").size() < 20000) pause_for(0.005);
  run.send(SIGINT);
  const Ended end = run.wait();
  EXPECT_EQ(end.status, 130) << end.output;
  EXPECT_THAT(end.output,
              HasSubstr("continue with: swarf run " + deck + " --output " + results.string() + " --resume"));
  EXPECT_THAT(read_bytes(results / "summary.json"), HasSubstr("\"ended\": \"interrupted\""));
  double time = 0;
  CheckpointReader(results / "checkpoint.h5").get("time", time);
  EXPECT_GT(time, 0);
  const Ended resumed = run_program(run_arguments(deck, results, true));
  EXPECT_EQ(resumed.status, 0) << resumed.output;
  expect_equal(folder / "whole", results);
}
