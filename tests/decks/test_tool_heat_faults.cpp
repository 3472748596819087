// Faults of decks whose tool conducts, each refused with what to do.
#include "tests/decks/expect_unreadable.hpp"

using namespace swarf;
using namespace swarf::test;

// A tool that conducts: its material is rigid, the bodies' is not and conducts, and friction heat divides by
// itself.
TEST(DeckFaultsOfToolHeat, materials_and_keys_fit_together) {
  const std::string carbide = "[material.wc]\nlaw = \"rigid\"\ndensity = \"15000 kg/m3\"\n"
                              "specific_heat = \"203 J/kg/K\"\nconductivity = \"46 W/m/K\"\n";
  const auto with_tool = [&](const std::string& keys, const std::string& text) {
    return edit_deck("[tool]", "[tool]\n" + keys, edit_deck("[[body]]", carbide + "[[body]]", text));
  };
  const std::string conducting = edit_deck("n = 0.34", "n = 0.34\nconductivity = \"7.2 W/m/K\"", good_deck);
  const std::string wc = "material = \"wc\"";
  EXPECT_EQ(fault_of_reading(with_tool(wc, conducting)), "no error");
  expect_unreadable(with_tool(wc, good_deck), {"body.material: [material.ti64] has no conductivity"});
  expect_unreadable(with_tool("material = \"wcc\"", conducting),
                    {"tool.material: there is no [material.wcc]", "Did you mean \"wc\"?"});
  expect_unreadable(with_tool("material = \"ti64\"", conducting), {"tool.material: [material.ti64] deforms"});
  expect_unreadable(
      with_tool(wc, edit_deck("friction = 0.5", "friction = 0.5\nheat_to_workpiece = 0.5", conducting)),
      {"contact.heat_to_workpiece: the tool has a material", "Leave this key out"});
  expect_unreadable(edit_deck("friction = 0.5", "friction = 0.5\nconductance = \"1e6 W/m2/K\"", conducting),
                    {"contact.conductance: the tool has no material"});
  expect_unreadable(edit_deck("[tool]", "[tool]\nheld_beyond = \"50 um\"", conducting),
                    {"tool.held_beyond: the tool has no material"});
  expect_unreadable(edit_deck("fill = \"particles\"\nmaterial = \"ti64\"",
                              "fill = \"particles\"\nmaterial = \"wc\"", with_tool(wc, conducting)),
                    {"body.material: [material.wc] has law = \"rigid\""});
  expect_unreadable(edit_deck("law = \"rigid\"", "law = \"rigid\"\nyoungs_modulus = \"600 GPa\"",
                              with_tool(wc, conducting)),
                    {"material.wc.youngs_modulus: does not apply to law = \"rigid\""});
}

// Keys that need a material, or each other.
TEST(DeckFaultsOfToolHeat, handed_on_temperatures_wear_and_lifting_off) {
  const auto with = [&](const std::string& keys) {
    return edit_deck("[tool]", "[tool]\n" + keys, good_deck);
  };
  expect_unreadable(with("temperature_from = \"results/before\""),
                    {"tool.temperature_from: the tool has no material", "Give tool.material"});
  expect_unreadable(with("heat_time = \"1 ms\""), {"tool.heat_time: the tool has no material"});
  expect_unreadable(with("wear_A = \"1e-14 1/Pa\"\nwear_B = \"1000 K\""),
                    {"tool.wear_A: the tool has no material"});
  expect_unreadable(with("wear_B = \"1000 K\""),
                    {"tool.wear_B: wear needs both of its constants", "Give the other"});
  expect_unreadable(with("wear_A = \"1e-14 Pa\"\nwear_B = \"1000 K\""), {"tool.wear_A", "1/Pa"});
  expect_unreadable(with("idle_time = \"1 ms\""), {"tool.idle_time: there is no run before this one"});
  expect_unreadable(with("lift_time = \"1 us\""), {"tool.lift_time: the tool would stop in the cut"});
  expect_unreadable(with("lift_velocity = [\"0 m/s\", \"1 m/s\", \"0 m/s\"]"),
                    {"tool.lift_velocity: nothing says when"});
}
