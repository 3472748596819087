// Tables over temperature, thermal expansion and faces that heat goes through: what a deck may say, that the
// resolved deck says it again, and what is refused.
#include "tests/decks/expect_unreadable.hpp"

using namespace swarf;
using namespace swarf::test;

namespace {

std::string with(const std::string& keys) { return edit_deck("n = 0.34", "n = 0.34\n" + keys, good_deck); }
const std::string conducts = "conductivity = \"7.2 W/m/K\"";

// On the first body, in the place of all its faces.
std::string with_faces(const std::string& faces, const std::string& deck) {
  const std::size_t at = deck.find("[body.faces]\n") + 13, end = deck.find("\n[", at);
  return deck.substr(0, at) + faces + deck.substr(end);
}

} // namespace

TEST(DeckOfHeat, TablesAreReadAndWrittenAgain) {
  const Deck deck = read_text(with("conductivity = [[\"300 K\", \"6.6 W/m/K\"], [\"1000 K\", \"17 W/m/K\"]]\n"
                                   "thermal_expansion = \"8.7e-6 1/K\""));
  const OverTemperature& k = deck.materials[0].conductivity;
  ASSERT_EQ(k.points.size(), 2u);
  EXPECT_EQ(k.points[1], (std::array<double, 2>{1000, 17}));
  EXPECT_EQ(k.least(), 6.6);
  EXPECT_EQ(k.greatest(), 17);
  EXPECT_EQ(deck.materials[0].thermal_expansion, 8.7e-6);
  Deck again = read_text(resolved_deck(deck));
  EXPECT_EQ(again.materials, deck.materials);
}

TEST(DeckOfHeat, TablesThatMeanNothingAreRefused) {
  expect_unreadable(
      with("conductivity = [[\"300 K\", \"6.6 W/m/K\"]]"),
      {"material.ti64.conductivity: expected a thermal conductivity, or a table", "2 to 16 points"});
  expect_unreadable(with("conductivity = [[\"300 K\", \"6 W/m/K\"], [\"300 K\", \"7 W/m/K\"]]"),
                    {"entry 2: expected a temperature above the one before, 300 K"});
  expect_unreadable(with("conductivity = [[\"300 K\", \"6 W/m/K\"], [\"400 K\", \"0 W/m/K\"]]"),
                    {"entry 2: expected more than 0 W/m/K in a table"});
  expect_unreadable(with("conductivity = [[\"300 K\", \"6 W/m/K\"], [400, \"7 W/m/K\"]]"),
                    {"entry 2: expected a temperature with a unit", "\"400 K\""});
  expect_unreadable(with("conductivity = [[\"300 K\", \"6 W/m/K\"], \"7 W/m/K\"]"),
                    {"entry 2: expected a pair such as [\"300 K\""});
  expect_unreadable(with("thermal_expansion = \"-1e-6 1/K\""), {"material.ti64.thermal_expansion: expected"});
}

TEST(DeckOfHeat, FacesWithATemperatureAreReadAndWrittenAgain) {
  const std::string faces = "outer = { fixed = true, temperature = \"300 K\" }\n"
                            "top = { temperature = \"25 degC\", film = \"1e4 W/m2/K\" }\n";
  const Deck deck = read_text(with_faces(faces, with(conducts)));
  const std::vector<FaceDeck>& read = deck.bodies[0].faces;
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].kind, FaceKind::fixed);
  EXPECT_EQ(*read[0].temperature, 300);
  EXPECT_FALSE(read[0].film);
  EXPECT_EQ(read[1].kind, FaceKind::free);
  EXPECT_EQ(*read[1].film, 1e4);
  EXPECT_EQ(read_text(resolved_deck(deck)).bodies[0].faces, read);
}

TEST(DeckOfHeat, FacesThatMeanNothingAreRefused) {
  const std::string good = with(conducts);
  expect_unreadable(with_faces("top = { temperature = \"300 K\" }\n", good_deck),
                    {"body.faces.top: lets heat through, but [material.ti64] has no conductivity"});
  expect_unreadable(with_faces("top = { film = \"1e4 W/m2/K\" }\n", good),
                    {"body.faces.top: has a film, but not the temperature"});
  expect_unreadable(with_faces("top = {}\n", good), {"body.faces.top: holds nothing"});
  expect_unreadable(
      with_faces("top = { fixed = true, velocity = [\"0 m/s\", \"0 m/s\", \"1 m/s\"] }\n", good),
      {"body.faces.top: is fixed and has a velocity"});
  expect_unreadable(with_faces("top = { temperature = 300 }\n", good),
                    {"body.faces.top.temperature: expected"});
}
