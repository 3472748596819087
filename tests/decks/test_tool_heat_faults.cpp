// Faults of decks whose tool conducts, each refused with what to do.
#include "tests/decks/good_deck.hpp"
#include <gtest/gtest.h>
#include <vector>

using namespace swarf;
using namespace swarf::test;

namespace {

std::string fault_of(const std::string& text) {
  try {
    read_text(text);
  } catch (const DeckError& error) {
    return error.what();
  }
  return "no error";
}

void expect_fault(const std::string& text, const std::vector<std::string>& fragments) {
  const std::string message = fault_of(text);
  for (const std::string& fragment : fragments)
    EXPECT_NE(message.find(fragment), std::string::npos) << fragment << "\n" << message;
}

} // namespace

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
  EXPECT_EQ(fault_of(with_tool(wc, conducting)), "no error");
  expect_fault(with_tool(wc, good_deck), {"body.material: [material.ti64] has no conductivity"});
  expect_fault(with_tool("material = \"wcc\"", conducting),
               {"tool.material: there is no [material.wcc]", "Did you mean \"wc\"?"});
  expect_fault(with_tool("material = \"ti64\"", conducting), {"tool.material: [material.ti64] deforms"});
  expect_fault(
      with_tool(wc, edit_deck("friction = 0.5", "friction = 0.5\nheat_to_workpiece = 0.5", conducting)),
      {"contact.heat_to_workpiece: the tool has a material", "Leave this key out"});
  expect_fault(edit_deck("friction = 0.5", "friction = 0.5\nconductance = \"1e6 W/m2/K\"", conducting),
               {"contact.conductance: the tool has no material"});
  expect_fault(edit_deck("[tool]", "[tool]\nheld_beyond = \"50 um\"", conducting),
               {"tool.held_beyond: the tool has no material"});
  expect_fault(edit_deck("fill = \"particles\"\nmaterial = \"ti64\"",
                         "fill = \"particles\"\nmaterial = \"wc\"", with_tool(wc, conducting)),
               {"body.material: [material.wc] has law = \"rigid\""});
  expect_fault(edit_deck("law = \"rigid\"", "law = \"rigid\"\nyoungs_modulus = \"600 GPa\"",
                         with_tool(wc, conducting)),
               {"material.wc.youngs_modulus: does not apply to law = \"rigid\""});
}

// Keys that need a material, or each other.
TEST(DeckFaultsOfToolHeat, handed_on_temperatures_wear_and_lifting_off) {
  const auto with = [&](const std::string& keys) {
    return edit_deck("[tool]", "[tool]\n" + keys, good_deck);
  };
  expect_fault(with("temperature_from = \"results/before\""),
               {"tool.temperature_from: the tool has no material", "Give tool.material"});
  expect_fault(with("heat_time = \"1 ms\""), {"tool.heat_time: the tool has no material"});
  expect_fault(with("wear_A = \"1e-14 1/Pa\"\nwear_B = \"1000 K\""),
               {"tool.wear_A: the tool has no material"});
  expect_fault(with("wear_B = \"1000 K\""),
               {"tool.wear_B: wear needs both of its constants", "Give the other"});
  expect_fault(with("wear_A = \"1e-14 Pa\"\nwear_B = \"1000 K\""), {"tool.wear_A", "1/Pa"});
  expect_fault(with("idle_time = \"1 ms\""), {"tool.idle_time: there is no run before this one"});
  expect_fault(with("lift_time = \"1 us\""), {"tool.lift_time: the tool would stop in the cut"});
  expect_fault(with("lift_velocity = [\"0 m/s\", \"1 m/s\", \"0 m/s\"]"),
               {"tool.lift_velocity: nothing says when"});
}
