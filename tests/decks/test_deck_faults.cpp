// Faults of decks: each must be refused, with a message that names file, line and key and says what to do.
#include "tests/decks/expect_unreadable.hpp"
#include <algorithm>
#include <cctype>

using namespace swarf;
using namespace swarf::test;

namespace {

const std::string no_line = "no line: the fault is of the whole deck";

struct DeckFault {
  std::string name;
  std::string from, to;               // edit of the good deck; an empty `from`: `to` is the whole deck
  std::string key;                    // that the message names; "" for what is not TOML
  std::vector<std::string> fragments; // of the message
  std::string at;                     // text on the line that the message names; "": the line of the edit
};

void PrintTo(const DeckFault& fault, std::ostream* out) { *out << fault.name; }

// ":LINE: " that the message must name, counted in the text of the deck.
std::string find_line(const DeckFault& fault, const std::string& text) {
  if (fault.at == no_line) return ": ";
  const auto at =
      fault.at.empty() ? (fault.from.empty() ? 0 : good_deck.find(fault.from)) : text.find(fault.at);
  if (at == std::string::npos) throw std::logic_error("the deck has no \"" + fault.at + "\"");
  std::string place(":");
  place += std::to_string(1 + std::count(text.begin(), text.begin() + long(at), '\n'));
  return place += ": ";
}

const std::string bulk_cells = "cells = [20, 2, 8]", zone_height = "height = \"10 um\"\nstart_angle";

DeckFault fault(const std::string& name, const std::string& from, const std::string& to,
                const std::string& key, const std::vector<std::string>& fragments,
                const std::string& at = "") {
  return {name, from, to, key, fragments, at};
}

const std::vector<DeckFault> faults = {
    // --- TOML
    fault("syntax", "n = 0.34", "n = = 0.34", "", {"this is not TOML"}),
    fault("bare_unit", "\"10000 rpm\"", "10000 rpm", "", {"this is not TOML", "text in quotes"}),
    fault("unclosed_text", "\"862 MPa\"", "\"862 MPa", "", {"this is not TOML"}),
    fault("key_twice", "C = 0.012", "n = 0.34", "", {"this is not TOML", "cannot redefine"}),
    fault("section_twice", "[run]", "[contact]\n[run]", "", {"this is not TOML", "contact"}),
    // --- keys and sections
    fault("unknown_key", "spacing =", "spaceing =", "body.spaceing",
          {"not a known key", "Did you mean \"spacing\"?"}),
    fault("unknown_key_unlike_any", "spacing =", "zzz =", "body.zzz", {"not a known key."}),
    fault("unknown_key_of_run", "mass_factor", "mass_scaling", "run.mass_scaling", {"not a known key"}),
    fault("unknown_key_on_top", "title =", "titel =", "titel",
          {"not a known key", "Did you mean \"title\"?"}),
    fault("unknown_section", "[run]", "[runs]", "runs", {"not a known section", "Did you mean \"run\"?"}),
    fault("material_without_name", "[material.ti64]", "[material]", "material", {"[material.NAME]"}),
    fault("body_in_single_brackets", "", "[body]\nname = \"b\"\n[run]\nend_time = \"1 s\"\n", "body",
          {"[[body]]"}),
    fault("tool_in_double_brackets", "[tool]", "[[tool]]", "tool", {"expected one section [tool]"}),
    fault("no_bodies", "", "[run]\nend_time = \"1 s\"\n", "body", {"has no body", "[[body]]"}, no_line),
    fault("empty_deck", "", "", "body", {"has no body"}, no_line),
    // --- units
    fault("missing_unit", "\"2.5 um\"", "2.5", "body.spacing",
          {"expected a length with a unit such as \"2.5 um\", got 2.5. In SI units, write spacing = \"2.5 "
           "m\"."}),
    fault("missing_unit_in_text", "\"2.5 um\"", "\"2.5\"", "body.spacing",
          {"has no unit", "In SI units, write \"2.5 m\"."}),
    fault("wrong_unit", "\"2.5 um\"", "\"2.5 s\"", "body.spacing", {"expected a length", "which is a time"}),
    fault("unknown_unit", "\"110 GPa\"", "\"110 kpsi\"", "material.ti64.youngs_modulus",
          {"no unit \"kpsi\""}),
    fault("unit_on_a_bare_number", "friction = 0.5", "friction = \"0.5 m\"", "contact.friction",
          {"expected a number without a unit such as 0.5, got \"0.5 m\""}),
    fault("celsius_by_C", "temperature = \"298.15 K\"", "temperature = \"25 C\"",
          "material.ti64.reference_temperature", {"write degC"}),
    fault("rotation_as_rate", "\"10000 rpm\"", "\"167 Hz\"", "tool.spindle_speed",
          {"expected a speed of rotation such as \"10000 rpm\"", "which is a rate or frequency"}),
    fault("unit_missing_in_array", "\"0 m/s\", \"0 m/s\", \"1 mm/s\"", "0, 0, 1", "body.faces.end.velocity",
          {"entry 1: expected a velocity with a unit", "In SI units, write \"0 m/s\"."}),
    // --- types and numbers
    fault("text_for_number", "n = 0.34", "n = \"high\"", "material.ti64.n",
          {"expected a number", "got \"high\""}),
    fault("number_for_text", "\"cut zone\"", "5", "body.name", {"expected text in quotes, got 5"}),
    fault("fraction_for_count", "rake =", "flutes = 2.5\nrake =", "tool.flutes",
          {"expected a whole number, got 2.5"}),
    fault("array_too_short", bulk_cells, "cells = [20, 2]", "body.cells",
          {"expected an array of 3 whole numbers"}),
    fault("table_for_number", "\"2.5 um\"", "{ x = 1 }", "body.spacing", {"expected a length"}),
    fault("nan", "n = 0.34", "n = nan", "material.ti64.n", {"expected a finite number"}),
    fault("infinity", "mass_factor = 1e4", "mass_factor = inf", "run.mass_factor",
          {"expected a finite number"}),
    fault("nan_with_unit", "\"110 GPa\"", "\"nan GPa\"", "material.ti64.youngs_modulus",
          {"not a finite number"}),
    fault("overflow", "\"110 GPa\"", "\"1e308 GPa\"", "material.ti64.youngs_modulus",
          {"out of the range of numbers"}),
    fault("count_overflow", bulk_cells, "cells = [99999999999, 2, 8]", "body.cells", {"1 to 1000000"}),
    fault("too_many_cells", bulk_cells, "cells = [1000000, 1000, 1000]", "body.cells",
          {"makes 1e+12 hexes", "Make the cells larger"}),
    fault("bool_as_text", "[contact]", "[particles]\ncorrection = \"yes\"\n[contact]", "particles.correction",
          {"expected true or false, got \"yes\""}, "correction ="),
    // --- bounds
    fault("negative_length", "\"2.5 um\"", "\"-2.5 um\"", "body.spacing",
          {"more than 0 m", "got \"-2.5 um\""}),
    fault("zero_length", "\"6 um\"", "\"-6 um\"", "tool.edge_radius", {"at least 0 m"}),
    fault("zero_radius", "inner_radius = \"400 um\"", "inner_radius = \"0 um\"", "body.inner_radius",
          {"more than 0 m"}),
    fault("incompressible", "0.33", "0.5", "material.ti64.poissons_ratio",
          {"more than -1 and less than 0.5, got 0.5"}),
    fault("negative_density", "\"4430 kg/m3\"", "\"-4430 kg/m3\"", "material.ti64.density",
          {"more than 0 kg/m3"}),
    fault("below_absolute_zero", "\"298.15 K\"", "\"-300 degC\"", "material.ti64.reference_temperature",
          {"more than 0 K"}),
    fault("zero_cells", bulk_cells, "cells = [20, 0, 8]", "body.cells",
          {"entry 2: expected a whole number, 1 to"}),
    fault("steep_helix", "rake =", "helix = \"80 deg\"\nrake =", "tool.helix",
          {"at most 70 deg, got \"80 deg\""}),
    fault("mass_factor_below_1", "1e4", "0.5", "run.mass_factor", {"at least 1"}),
    fault("accuracy_without_unit", "mass_factor = 1e4", "accuracy = 3", "run.accuracy",
          {"expected a percentage with a unit such as \"5 %\", got 3. Write accuracy = \"3 %\"."}),
    fault("accuracy_of_zero", "mass_factor = 1e4", "accuracy = \"0 %\"", "run.accuracy", {"more than 0 %"}),
    fault("accuracy_as_length", "mass_factor = 1e4", "accuracy = \"3 um\"", "run.accuracy",
          {"\"um\" is not a unit of this"}),
    fault("courant_above_1", "mass_factor = 1e4", "courant = 1.5", "run.courant", {"at most 1"}),
    fault("no_direction", "rake =", "feed_direction = [0, 0, 0]\nrake =", "tool.feed_direction",
          {"not all zero"}),
    // --- what belongs together
    fault("missing_key", "density = \"4430 kg/m3\"\n", "", "material.ti64.density",
          {"is missing. Expected a density"}, "[material"),
    fault("missing_specific_heat", "specific_heat = \"526.3 J/kg/K\"\n", "", "material.ti64.specific_heat",
          {"is missing"}, "[material"),
    fault("missing_friction", "friction = 0.5\n", "", "contact.friction", {"is missing"}, "[contact]"),
    fault("missing_contact", "[contact]\nfriction = 0.5\n", "", "contact",
          {"friction of the tool has no default"}, "[tool]"),
    fault("unknown_law", "\"johnson_cook\"", "\"jonson_cook\"", "material.ti64.law",
          {"Did you mean \"johnson_cook\"?"}),
    fault("unknown_shape", "\"ring\"", "\"torus\"", "body.shape",
          {"expected \"block\" or \"cylinder\"", "got \"torus\""}),
    fault("missing_shape", "shape = \"ring\"\n", "", "body.shape", {"is missing", "\"ring\""}, "[[body]]"),
    fault("title_is_a_number", "\"a mill and a ring\"", "5", "title", {"expected text in quotes, got 5"}),
    fault("unknown_tool", "\"end_mill\"", "\"drill\"", "tool.kind",
          {"\"end_mill\" or \"wedge\" or \"wall\" or \"stl\""}),
    fault("key_of_another_shape", "spacing = ", "radius = \"1 mm\"\nspacing = ", "body.radius",
          {"does not apply to shape = \"ring\". Remove it"}),
    fault("key_of_another_law", "B = ", "yield_stress = \"1 MPa\"\nB = ", "material.ti64.yield_stress",
          {"does not apply to law = \"johnson_cook\""}),
    fault("key_of_another_tool", "rake =", "inclination = \"1 deg\"\nrake =", "tool.inclination",
          {"does not apply to kind = \"end_mill\""}),
    fault("tie_of_hexes", bulk_cells, "tie = \"cut zone\"\n" + bulk_cells, "body.tie",
          {"does not apply to fill = \"hexes\""}),
    fault("melt_below_reference", "\"1878 K\"", "\"20 degC\"", "material.ti64.melt_temperature",
          {"more than reference_temperature"}),
    fault("spacing_and_cells", bulk_cells, bulk_cells + "\nspacing = \"5 um\"", "body.cells", {"not both"}),
    fault("neither_spacing_nor_cells", "spacing = \"2.5 um\"\n", "", "body.spacing",
          {"is missing", "by cells"}, "[[body]]"),
    fault("spacing_too_large", "\"2.5 um\"", "\"50 um\"", "body.spacing", {"not one cell fits"}),
    fault("radii_swapped", "\"400 um\"", "\"440 um\"", "body.inner_radius",
          {"less than outer_radius = 0.00043 m"}),
    fault("angles_swapped", "end_angle = \"20 deg\"", "end_angle = \"-20 deg\"", "body.end_angle",
          {"more than start_angle"}),
    fault("more_than_a_turn", "end_angle = \"20 deg\"", "end_angle = \"400 deg\"", "body.end_angle",
          {"whole turn"}),
    fault("unknown_face", "bottom = \"periodic\"", "botom = \"periodic\"", "body.faces.botom",
          {"no such face", "Did you mean \"bottom\"?"}),
    fault("face_of_another_shape", "outer = \"fixed\"", "x_min = \"fixed\"", "body.faces.x_min",
          {"this ring has no such face", "inner, outer, bottom, top, start, end"}),
    fault("unknown_face_kind", "\"fixed\"", "\"fix\"", "body.faces.outer",
          {"\"symmetric\"", "Did you mean \"fixed\"?"}),
    fault("periodic_alone", "top = \"periodic\"\n", "", "body.faces.bottom", {"Write top = \"periodic\" too"},
          "bottom ="),
    fault("periodic_and_curved", "\"fixed\"", "\"periodic\"", "body.faces.outer",
          {"curved face cannot be periodic"}),
    fault("symmetric_and_curved", "\"fixed\"", "\"symmetric\"", "body.faces.outer", {"must be plane"}),
    fault("rake_and_clearance", "\"0 deg\"\nclearance = \"10 deg\"", "\"50 deg\"\nclearance = \"45 deg\"",
          "tool.clearance", {"less than 90 deg"}, "clearance ="),
    fault("no_end", "end_immersion = \"95 deg\"\n", "", "run.end_time", {"when the run ends"}, "[run]"),
    fault("two_ends", "end_immersion =", "end_time = \"1 ms\"\nend_immersion =", "run.end_immersion",
          {"not both"}, "end_immersion"),
    fault("frames_twice", "frame_immersion =", "frame_time = \"1 ms\"\nframe_immersion =",
          "output.frame_immersion", {"not both"}, "frame_immersion"),
    fault("published_not_a_list", "published = [", "published = 5\nunused = [", "output.published",
          {"expected a list such as"}),
    fault("published_without_label", "label = \"simulated\", ", "", "output.published.label", {"is missing"}),
    // --- between sections
    fault("unknown_material", "material = \"ti64\"", "material = \"ti46\"", "body.material",
          {"no [material.ti46]", "Did you mean \"ti64\"?"}),
    fault("unknown_tie", "tie = \"bulk\"", "tie = \"bulge\"", "body.tie",
          {"not a body of this deck", "fill = \"hexes\""}),
    fault("tie_to_particles", "tie = \"bulk\"", "tie = \"cut zone\"", "body.tie", {"filled with particles"}),
    fault("body_twice", "\"bulk\"\nshape", "\"cut zone\"\nshape", "body.name",
          {"name of the body of line 15 already"}),
    fault("hotter_than_melt", zone_height, "temperature = \"2000 K\"\n" + zone_height, "body.temperature",
          {"less than the melt_temperature of ti64"}),
    fault("end_before_start", "\"95 deg\"", "\"60 deg\"", "run.end_immersion",
          {"more than tool.start_angle = 65 deg"}),
    fault("initial_frame_with_evolving_kernels", "[run]",
          "[particles]\nkernel_frame = \"initial\"\nsmoothing_length = \"evolving\"\n[run]",
          "particles.smoothing_length", {"does not go with kernel_frame", "use \"fixed\""},
          "smoothing_length"),
    fault("initial_frame_without_correction", "[run]",
          "[particles]\nkernel_frame = \"initial\"\ncorrection = false\n[run]", "particles.correction",
          {"would be strained"}, "correction ="),
    fault("retire_without_sleep", "[run]", "[retire]\ndistance = \"60 um\"\n[run]", "retire.distance",
          {"needs sleep.distance"}, "distance = \"60 um\""),
    fault("damage_missing", "[run]", "[hexes]\ndelete_failed = true\n[run]", "hexes.delete_failed",
          {"no material has damage"}, "delete_failed"),
};

class DeckFaults : public testing::TestWithParam<DeckFault> {};

} // namespace

TEST_P(DeckFaults, is_refused_with_its_message) {
  const DeckFault& wrong = GetParam();
  const std::string text = wrong.from.empty() ? wrong.to : edit_deck(wrong.from, wrong.to);
  const std::string message = fault_of_reading(text);
  const std::string place =
      "deck.toml" + find_line(wrong, text) + (wrong.key.empty() ? "" : wrong.key + ": ");
  EXPECT_NE(message.find(place), std::string::npos) << place << "\n" << message;
  for (const std::string& fragment : wrong.fragments)
    EXPECT_NE(message.find(fragment), std::string::npos) << fragment << "\n" << message;
  EXPECT_TRUE(message.ends_with('.') || message.ends_with('?')) << message;
}

INSTANTIATE_TEST_SUITE_P(deck, DeckFaults, testing::ValuesIn(faults),
                         [](const auto& test) { return test.param.name; });

namespace {

// Replaces the tool, and ends the run by time so that nothing needs a spindle.
std::string with_tool(const std::string& tool) {
  const std::string text =
      good_deck.substr(0, good_deck.find("[tool]")) + "[tool]\n" + tool + "[contact]\nfriction = 0.2\n";
  return text + "[run]\nend_time = \"1 ms\"\n";
}

const std::string wedge =
    "kind = \"wedge\"\nrake = \"15 deg\"\nclearance = \"2 deg\"\nedge_radius = \"20 um\"\n"
    "width = \"1 mm\"\nheight = \"1 mm\"\nvelocity = [\"1 m/s\", \"0 m/s\", \"0 m/s\"]\n";

} // namespace

TEST(DeckFaultsOfTools, a_wedge_is_as_good_as_a_mill) {
  EXPECT_EQ(fault_of_reading(with_tool(wedge)), "no error");
}

TEST(DeckFaultsOfTools, stl_file_is_missing) {
  expect_unreadable(with_tool("kind = \"stl\"\nfile = \"none.stl\"\n"),
                    {"deck.toml:46: tool.file: there is no file /", "none.stl", "relative to the deck"});
}

TEST(DeckFaultsOfTools, stl_file_is_a_folder) {
  expect_unreadable(with_tool("kind = \"stl\"\nfile = \".\"\n"), {"46: tool.file: there is no file"});
}

TEST(DeckFaultsOfTools, immersion_without_a_spindle) {
  expect_unreadable(edit_deck("end_time = \"1 ms\"", "end_immersion = \"9 deg\"", with_tool(wedge)),
                    {"55: run.end_immersion: needs a tool with a spindle_speed. Use end_time."});
  expect_unreadable(with_tool(wedge) + "[output]\nframe_immersion = \"1 deg\"\n",
                    {"57: output.frame_immersion: needs a tool with a spindle_speed. Use frame_time."});
  expect_unreadable(with_tool(wedge) + "[output]\npicture_immersion = [\"1 deg\"]\n",
                    {"57: output.picture_immersion: needs a tool with a spindle_speed. Use picture_time."});
}

TEST(DeckFaultsOfTools, previous_tooth_without_a_mill) {
  expect_unreadable(edit_deck("tie = ", "previous_tooth = true\ntie = ", with_tool(wedge)),
                    {"26: body.previous_tooth: needs a tool of kind \"end_mill\"."});
}

TEST(DeckFaultsOfTools, wedge_stands_still_or_is_lower_than_its_edge) {
  expect_unreadable(edit_deck("\"1 m/s\"", "\"0 m/s\"", with_tool(wedge)),
                    {"tool.velocity: a wedge must move"});
  expect_unreadable(edit_deck("height = \"1 mm\"", "height = \"10 um\"", with_tool(wedge)),
                    {"tool.height: expected more"});
}

TEST(DeckFaultsOfTools, mill_has_too_large_edge_or_runout) {
  expect_unreadable(edit_deck("\"6 um\"", "\"500 um\""),
                    {"49: tool.edge_radius: expected less than the mill's radius"});
  expect_unreadable(edit_deck("rake =", "runout = \"1 mm\"\nrake ="),
                    {"47: tool.runout: expected less than"});
}

TEST(DeckFaultsOfTools, contact_without_a_tool) {
  std::string text = with_tool("");
  text = edit_deck("[tool]\n", "", text);
  expect_unreadable(text, {"44: contact: there is no [tool] to touch"});
}

TEST(DeckFaultsOfBodies, whole_ring_has_no_start) {
  std::string text = edit_deck("start_angle = \"-10 deg\"\nend_angle = \"20 deg\"\nspacing", "spacing");
  text = edit_deck("bottom = \"periodic\"", "start = \"fixed\"\nbottom = \"periodic\"", text);
  expect_unreadable(text,
                    {"26: body.faces.start: this ring has no such face. It has inner, outer, bottom, top."});
}

TEST(DeckFaultsOfMethods, initial_frame_conducts_no_heat) {
  const std::string cold = "[particles]\nkernel_frame = \"initial\"\n[run]";
  EXPECT_EQ(fault_of_reading(edit_deck("[run]", cold)), "no error");
  const std::string heated = edit_deck("n = 0.34", "n = 0.34\nconductivity = \"7 W/m/K\"");
  expect_unreadable(edit_deck("[run]", cold, heated),
                    {"particles.kernel_frame: \"initial\" conducts no heat"});
}

TEST(DeckFaultsOfMethods, a_smoothing_length_that_follows_its_own_sum) {
  const auto with = [](const std::string& keys) {
    return edit_deck("[run]", "[particles]\nsmoothing_length = \"evolving\"\n" + keys + "[run]");
  };
  EXPECT_EQ(fault_of_reading(with("")), "no error");
  expect_unreadable(with("density = \"summation\"\n"),
                    {"particles.smoothing_length: \"evolving\" does not go with density = \"summation\"",
                     "Use density = \"continuity\""});
}

TEST(DeckFaultsOfMethods, hexes_that_become_particles) {
  const auto bulk = [](const std::string& keys, const std::string& deck = good_deck) {
    return edit_deck("cells = [20, 2, 8]", "cells = [20, 2, 8]\n" + keys, deck);
  };
  const std::string free = edit_deck("tie = \"bulk\"\n", ""), near = "convert_distance = \"20 um\"";
  EXPECT_EQ(fault_of_reading(bulk(near, free)), "no error");
  expect_unreadable(bulk(near), {"26: body.tie: does not go with hexes that become particles"});
  expect_unreadable(
      bulk("convert_particles = 3", free),
      {"body.convert_particles: nothing says when hexes become particles. Give convert_distance"});
  expect_unreadable(edit_deck("spacing = \"2.5 um\"", "spacing = \"2.5 um\"\n" + near),
                    {"26: body.convert_distance: does not apply to fill = \"particles\". Remove it"});
  const std::string no_tool = free.substr(0, free.find("[tool]")) + "[run]\nend_time = \"1 ms\"\n";
  expect_unreadable(bulk(near, no_tool), {"body.convert_distance: there is no [tool] to come near"});
  for (const auto& [section, key] :
       {std::pair<const char*, const char*>{"particles", "kernel_frame = \"initial\""},
        {"particles", "density = \"summation\""},
        {"sleep", "distance = \"60 um\""},
        {"hexes", "delete_at_strain = 2.0"}}) {
    const std::string name(key, std::string(key).find(' '));
    expect_unreadable(
        edit_deck("[run]", std::string("[") + section + "]\n" + key + "\n[run]", bulk(near, free)),
        {std::string(section) + "." + name + ": does not go with hexes that become particles"});
  }
}

TEST(DeckFaultsOfFiles, deck_is_missing_or_a_folder) {
  TemporaryFolder folder;
  const auto read = [](const std::string& file) -> std::string {
    try {
      read_deck(file);
    } catch (const DeckError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_NE(read("no_such.toml").find("no_such.toml: cannot read the deck: No such file"), std::string::npos);
  EXPECT_NE(read(folder.path.string()).find("this is a folder"), std::string::npos);
  EXPECT_NE(read(folder.write("binary.toml", std::string("\x01\xff\x00\x80", 4))).find("not TOML"),
            std::string::npos);
}

TEST(DeckFaultsTogether, all_faults_of_a_deck_come_at_once_in_its_order) {
  std::string text = edit_deck("\"4430 kg/m3\"", "4430");
  text = edit_deck("\"2.5 um\"", "\"-1 um\"", text);
  text = edit_deck("friction = 0.5", "friction = -1", text);
  const std::string message = fault_of_reading(text);
  const auto density = message.find(":4: material.ti64.density"), spacing = message.find(":25: body.spacing"),
             friction = message.find(":55: contact.friction");
  ASSERT_NE(friction, std::string::npos) << message;
  EXPECT_LT(density, spacing);
  EXPECT_LT(spacing, friction);
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 2);
}
