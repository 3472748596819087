// Faults that show only when the scene is built: each must be refused, with a message that names file, line
// and key and says what to do.
#include "tests/decks/good_deck.hpp"
#include "tests/src/scene_decks.hpp"
#include <gtest/gtest.h>
#include <vector>

using namespace swarf;
using namespace swarf::test;

namespace {

std::string fault_of(const Deck& deck) {
  try {
    build_scene(deck);
  } catch (const DeckError& error) {
    return error.what();
  }
  return "no error";
}

// The message of the good deck, its slice periodic in the hexes too, after edits (pairs of from, to).
std::string fault_after(const std::vector<std::pair<std::string, std::string>>& edits) {
  std::string text =
      edit_deck("outer = \"fixed\"", "outer = \"fixed\"\nbottom = \"periodic\"\ntop = \"periodic\"");
  for (const auto& [from, to] : edits) text = edit_deck(from, to, text);
  const TemporaryFolder folder;
  return fault_of(read_deck(folder.write("faulty.toml", text)));
}

void expect_fault(const std::string& message, const std::vector<std::string>& fragments) {
  for (const std::string& fragment : fragments)
    EXPECT_NE(message.find(fragment), std::string::npos) << fragment << "\n" << message;
  EXPECT_TRUE(message.ends_with('.')) << message;
}

Deck deck_of(const std::vector<BodyDeck>& bodies) {
  Deck deck = empty_deck();
  deck.bodies = bodies;
  return deck;
}

} // namespace

TEST(SceneFaults, good_deck_builds) { EXPECT_EQ(fault_after({}), "no error"); }

TEST(SceneFaults, bodies_overlap) {
  expect_fault(fault_after({{"inner_radius = \"430 um\"", "inner_radius = \"429 um\""}}),
               {"faulty.toml:", "body.origin: \"cut zone\" overlaps body \"bulk\" of line", "Move one"});
  // By a tenth of a cell
  const auto cube = [](double x) { return block("b", "hexes", {x, 0, 0}, {1e-3, 1e-3, 1e-3}, 1e-4); };
  expect_fault(fault_of(deck_of({cube(0), cube(0.99e-3)})), {"test.toml:7: body.origin: \"b\" overlaps"});
  EXPECT_EQ(fault_of(deck_of({cube(0), cube(1e-3)})), "no error");
}

TEST(SceneFaults, small_body_in_a_coarse_one) {
  expect_fault(fault_of(deck_of({block("large", "particles", {0, 0, 0}, {1e-3, 1e-3, 1e-3}, 5e-4),
                                 block("small", "particles", {1e-5, 1e-5, 1e-5}, {1e-5, 1e-5, 1e-5}, 5e-6)})),
               {"\"small\" overlaps body \"large\""});
}

TEST(SceneFaults, tie_touches_no_hex) {
  expect_fault(fault_after({{"inner_radius = \"430 um\"", "inner_radius = \"440 um\""}}),
               {"faulty.toml:15: body.tie: \"cut zone\" does not touch \"bulk\": expected a common face"});
}

TEST(SceneFaults, tied_bodies_end_differently) {
  Deck deck = deck_of({block("zone", "particles", {0, 0, 0}, {1e-3, 1e-3, 1e-3}, 1e-4),
                       block("bulk", "hexes", {0, 0, -1e-3}, {1e-3, 1e-3, 1e-3}, 2e-4)});
  deck.bodies[0].tie = "bulk";
  deck.bodies[0].faces = {{"x_min", FaceKind::periodic, {}}, {"x_max", FaceKind::periodic, {}}};
  expect_fault(fault_of(deck),
               {"body.faces.x_min: \"zone\" is periodic, and face x_min of \"bulk\" in the same plane "
                "is free"});
}

TEST(SceneFaults, tool_inside_the_workpiece) {
  expect_fault(fault_after({{"diameter =", "position = [\"10 um\", \"0 um\", \"0 um\"]\ndiameter ="},
                            {"start_angle = \"65 deg\"", "start_angle = \"85 deg\""}}),
               {"faulty.toml:48: tool.position: the tool overlaps body \"", "um at the start, deepest at (",
                "expected none. Move the tool or the body apart, or choose a start_angle"});
}

TEST(SceneFaults, periodic_slice_thinner_than_the_reach) {
  expect_fault(
      fault_after({{"height = \"10 um\"", "height = \"5 um\""}}),
      {"body.faces.bottom: \"cut zone\" is 5e-06 m from the opposite periodic face: expected at least"});
}

TEST(SceneFaults, too_many_cells_for_the_machine) {
  BodyDeck sphere = body("s", "sphere", "particles");
  sphere.outer_radius = 1, sphere.spacing = 1e-4;
  const std::string many = fault_of(deck_of({sphere}));
  expect_fault(many, {"test.toml:7: body.spacing: \"s\" makes 4.189e+12 particles, which need",
                      "GiB of this machine"});
  sphere.spacing = 1e-300; // counts that no integer holds
  expect_fault(fault_of(deck_of({sphere})), {"body.spacing: \"s\" makes", "Make the cells larger"});
}

TEST(SceneFaults, body_smaller_than_a_cell) {
  expect_fault(fault_of(deck_of({block("b", "particles", {0, 0, 0}, {1e-3, 1e-3, 1e-5}, 1e-4)})),
               {"body.spacing: \"b\" holds not one cell: expected at most", "1e-05 m"});
}

TEST(SceneFaults, no_body) {
  expect_fault(fault_of(deck_of({})), {"test.toml: body: expected at least one"});
}

TEST(SceneFaults, hexes_cannot_fill_it) {
  BodyDeck sphere = body("s", "sphere", "hexes");
  sphere.outer_radius = 1e-3, sphere.spacing = 1e-4;
  expect_fault(fault_of(deck_of({sphere})), {"body.inner_radius: \"s\" is solid, which hexes cannot fill"});
  BodyDeck bar = body("c", "cylinder", "hexes");
  bar.radius = bar.height = 1e-3, bar.cells = {2, 2, 2};
  expect_fault(fault_of(deck_of({bar})),
               {"body.cells: \"c\" expected at least 3 hexes across the cylinder, got 2"});
  expect_fault(fault_of(deck_of({ring("r", "hexes", 1e-3, 2e-3, 1e-3, {2, 2, 2})})),
               {"body.cells: \"r\" expected at least 3 hexes around the ring, got 2"});
}

TEST(SceneFaults, particles_behind_a_mirror) {
  BodyDeck first = block("a", "particles", {0, 0, 0}, {1e-3, 1e-3, 1e-3}, 1e-4);
  first.faces = {{"x_min", FaceKind::symmetric, {}}};
  expect_fault(fault_of(deck_of({first, block("b", "particles", {-2e-3, 0, 0}, {1e-3, 1e-3, 1e-3}, 1e-4)})),
               {"body.origin: \"b\" has particles behind a periodic or symmetric plane, at (-0.00195,"});
}

TEST(SceneFaults, periodic_sector_too_large_or_unequal) {
  BodyDeck sector = ring("r", "particles", 1e-3, 2e-3, 1e-3, {20, 4, 4});
  sector.end_angle = 200 * degree,
  sector.faces = {{"start", FaceKind::periodic, {}}, {"end", FaceKind::periodic, {}}};
  expect_fault(fault_of(deck_of({sector})),
               {"body.faces.start: \"r\" bounds a sector of more than 180 deg: expected at most that"});
  Deck deck = deck_of({ring("h", "hexes", 400 * um, 450 * um, 50 * um, {20, 4, 4})});
  deck.tool = paper_mill();
  deck.bodies[0].end_angle = 60 * degree, deck.bodies[0].previous_tooth = true;
  deck.bodies[0].faces = sector.faces;
  expect_fault(fault_of(deck),
               {"body.faces.start: \"h\" is not the image of the end face", "previous_tooth"});
}

TEST(SceneFaults, previous_tooth_cuts_through_the_ring) {
  Deck deck = deck_of({ring("r", "particles", 380 * um, 395 * um, 50 * um, {20, 4, 4})});
  deck.bodies[0].previous_tooth = true;
  expect_fault(fault_of(deck), {"body.previous_tooth: \"r\" needs a tool of kind \"end_mill\""});
  deck.tool = paper_mill();
  expect_fault(fault_of(deck),
               {"body.previous_tooth: \"r\" has an outer_radius of 0.000395 m: expected more than"});
}

TEST(SceneFaults, too_many_planes_and_holds) {
  Deck deck = empty_deck();
  for (int n = 0; n < 5; ++n) { // nested mirrors, each 1 mm farther out
    BodyDeck b = block("b", "particles", {0, 3e-3 * n, 0}, {1e-3, 1e-3, 1e-3}, 1e-4);
    b.origin[0] = 1e-3 * n, b.faces = {{"x_min", FaceKind::symmetric, {}}};
    deck.bodies.push_back(b);
  }
  std::swap(deck.bodies[0], deck.bodies[4]);
  expect_fault(fault_of(deck), {"body.faces.x_min: \"b\" is one face too many: expected at most 4 pairs"});
  deck = empty_deck();
  for (int n = 0; n < 33; ++n) {
    deck.bodies.push_back(block("b", "hexes", {0, 3e-3 * n, 0}, {1e-3, 1e-3, 1e-3}, 1e-3));
    deck.bodies.back().faces = {{"x_min", FaceKind::velocity, {double(n), 0, 0}}};
  }
  expect_fault(fault_of(deck), {"body.faces.x_min: \"b\" is the 29th different hold: expected at most 28"});
}
