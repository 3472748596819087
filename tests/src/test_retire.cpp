// Chip that retires in a whole run: the force of the rest, what it takes along, and what is said of one that
// comes back. The chip is a loose piece in front of the tooth of the small deck, 2.5 um a particle.
#include "src/files/results.hpp"
#include "src/output/history.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/small_deck.hpp"
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;
using testing::HasSubstr;
using testing::Not;

namespace {

const std::string all_active = "[sleep]\ndistance = \"1 mm\"\nramp = 0.1\n",
                  retires = "[retire]\ndistance = \"14 um\"\n";
constexpr int pieces = 18; // particles of the loose piece
constexpr double v = 1.2;  // m/s, its speed

// The small cut with a loose piece that flies away from the bore, or back to it.
std::string deck_with_chip(double x, double velocity, const std::string& sections,
                           const std::string& method = "") {
  Edits edits;
  edits.push_back({"[particles]\n", "[particles]\n" + method});
  edits.push_back({"[tool]", loose_chip(x, velocity) + "[tool]"});
  edits.push_back({"[run]", sections + "[run]"});
  return edit_small_deck(edits);
}

struct Outcome {
  HistoryTable history;
  std::string summary, output;

  double number(const std::string& key) const {
    const auto at = summary.find("\"" + key + "\": ");
    return at == std::string::npos ? NAN : std::stod(summary.substr(at + key.size() + 4));
  }
};

Outcome run(const TemporaryFolder& folder, const std::string& name, const std::string& text) {
  const std::string deck = write_deck(folder, text, name + ".toml");
  const Ended end = run_program(run_arguments(deck, folder / name));
  EXPECT_EQ(end.status, 0) << end.output;
  return {read_history(folder / name / "history.csv"), read_bytes(folder / name / "summary.json"),
          end.output};
}

} // namespace

// It leaves when it has flown 14 um: the order of sums changes, and the step, which follows the highest mode
// of all particles, by what the noise in that mode is (4e-5); the residual, 1.3e-3 of the work, by 1.5e-6.
// Without shifting, which makes more of round-off.
TEST(Retire, leaves_the_rest_as_it_was_and_takes_its_own_along) {
  const TemporaryFolder folder;
  const std::string method = "shifting = false\n";
  const Outcome with = run(folder, "with", deck_with_chip(372, -v, all_active, method)),
                without = run(folder, "without", deck_with_chip(372, -v, all_active + retires, method));
  for (const char* column : {"external_work", "plastic_work", "max_temperature", "kinetic_energy"})
    EXPECT_NEAR(without.history.at(column).back() / with.history.at(column).back(), 1, 2e-4) << column;
  EXPECT_NEAR(without.history.at("energy_residual").back() / with.history.at("external_work").back(),
              with.history.at("energy_residual").back() / with.history.at("external_work").back(), 5e-6);
  const double mass = pieces * 4430 * std::pow(2.5e-6, 3), inertia = 1e5 * mass;
  EXPECT_NEAR(without.number("mass") / mass, 1, 1e-9);
  EXPECT_NEAR(without.number("momentum_x") / (-inertia * v), 1, 1e-6);
  EXPECT_EQ(without.number("met_since"), 0);
  EXPECT_THAT(without.output, Not(HasSubstr("came back")));
}

TEST(Retire, says_how_many_came_back) {
  const TemporaryFolder folder;
  const Outcome back = run(folder, "back", deck_with_chip(345, 1.6, all_active + retires));
  EXPECT_GT(back.number("met_since"), 0);
  EXPECT_THAT(back.output, HasSubstr("particles that left came back to the tool or the work"));
}

// Where nothing is so far away, no bit changes.
TEST(Retire, changes_nothing_where_nothing_leaves) {
  const TemporaryFolder folder;
  const std::string off = write_deck(folder, deck_with_chip(372, -v, all_active), "off.toml"),
                    far = write_deck(folder,
                                     deck_with_chip(372, -v, all_active + "[retire]\ndistance = \"1 mm\"\n"),
                                     "far.toml");
  for (const auto& deck : {off, far})
    EXPECT_EQ(run_program(run_arguments(deck, deck + "_results")).status, 0);
  EXPECT_EQ(read_bytes(off + "_results/history.csv"), read_bytes(far + "_results/history.csv"));
}
