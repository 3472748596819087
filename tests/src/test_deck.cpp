// The deck reader: values, defaults, the resolved deck, the reference page, the shipped decks.
#include "src/deck/deck.hpp"
#include "src/deck/section.hpp"
#include "tests/decks/good_deck.hpp"
#include <gtest/gtest.h>
#include <numbers>

using namespace swarf;
using namespace swarf::test;

namespace {

constexpr double degree = std::numbers::pi / 180;

// Equal but for the file's name and the lines for messages.
void expect_same(Deck a, Deck b) {
  a.file = b.file;
  ASSERT_EQ(a.bodies.size(), b.bodies.size());
  for (std::size_t i = 0; i < a.bodies.size(); ++i) a.bodies[i].line = b.bodies[i].line;
  a.run.accuracy_line = b.run.accuracy_line;
  if (a.windows && b.windows) a.windows->line = b.windows->line;
  EXPECT_TRUE(a == b);
}

void expect_round_trip(const Deck& deck) {
  const std::string text = resolved_deck(deck);
  SCOPED_TRACE(text);
  const Deck back = read_text(text);
  expect_same(deck, back);
  EXPECT_EQ(resolved_deck(back), text);
}

} // namespace

TEST(deck, values_arrive_in_si) {
  const Deck deck = read_text(good_deck);
  EXPECT_EQ(deck.title, "a mill and a ring");
  ASSERT_EQ(deck.materials.size(), 1u);
  const MaterialDeck& ti64 = deck.materials[0];
  EXPECT_EQ(ti64.name, "ti64");
  EXPECT_EQ(ti64.A, 862e6);
  EXPECT_EQ(ti64.C, 0.012);
  EXPECT_EQ(ti64.melt_temperature, 1878);
  EXPECT_FALSE(ti64.damage);
  ASSERT_EQ(deck.bodies.size(), 2u);
  const BodyDeck &zone = deck.bodies[0], &bulk = deck.bodies[1];
  EXPECT_EQ(zone.line, 15);
  EXPECT_EQ(zone.inner_radius, 400e-6);
  EXPECT_DOUBLE_EQ(zone.start_angle, -10 * degree);
  EXPECT_EQ(*zone.spacing, 2.5e-6);
  EXPECT_EQ(zone.tie, "bulk");
  EXPECT_EQ(*bulk.cells, (std::array<int, 3>{20, 2, 8}));
  ASSERT_EQ(bulk.faces.size(), 2u); // in the order of the deck
  EXPECT_EQ(bulk.faces[0].face, "outer");
  EXPECT_EQ(bulk.faces[0].kind, FaceKind::fixed);
  EXPECT_EQ(bulk.faces[1].face, "end");
  EXPECT_EQ(bulk.faces[1].velocity, (Triple{0, 0, 1e-3}));
  ASSERT_TRUE(deck.tool);
  EXPECT_DOUBLE_EQ(deck.tool->spindle_speed, 10000 * 2 * std::numbers::pi / 60);
  EXPECT_EQ(deck.contact.friction, 0.5);
  EXPECT_DOUBLE_EQ(*deck.run.end_immersion, 95 * degree);
  EXPECT_EQ(deck.run.mass_factor, 1e4);
  EXPECT_EQ(deck.output.picture_immersion.size(), 2u);
  ASSERT_EQ(deck.output.published.size(), 2u);
  EXPECT_EQ(deck.output.published[1].label, "measured");
  EXPECT_EQ(deck.output.published[1].force, 10.5);
}

TEST(deck, defaults_are_filled_in) {
  const Deck deck = read_text(good_deck);
  EXPECT_EQ(deck.materials[0].reference_rate, 1);
  EXPECT_EQ(deck.materials[0].taylor_quinney, 0.9);
  EXPECT_DOUBLE_EQ(deck.bodies[0].temperature, 298.15);
  EXPECT_EQ(deck.tool->flutes, 2);
  EXPECT_EQ(deck.tool->feed_direction, (Triple{1, 0, 0}));
  EXPECT_FALSE(deck.contact.heat_to_workpiece); // half, unless the tool has a material
  EXPECT_TRUE(deck.tool->material.empty());
  EXPECT_EQ(deck.particles.smoothing_length, SmoothingLength::fixed);
  EXPECT_TRUE(deck.particles.correction);
  EXPECT_EQ(deck.hexes.hourglass, HourglassMethod::stiffness);
  EXPECT_EQ(deck.output.picture_field, PictureField::temperature);
  EXPECT_EQ(deck.output.history_steps, 10);
  EXPECT_FALSE(deck.run.end_time);
}

TEST(deck, cylinder_cells_are_across_across_axial) {
  const Deck deck = read_text(R"([material.copper]
law = "linear_hardening"
density = "8930 kg/m3"
youngs_modulus = "117 GPa"
poissons_ratio = 0.35
yield_stress = "400 MPa"
hardening_modulus = "100 MPa"
[[body]]
name = "bar"
shape = "cylinder"
fill = "hexes"
material = "copper"
radius = "3.2 mm"
height = "32.4 mm"
cells = [16, 81]
[run]
end_time = "80 us"
)");
  EXPECT_EQ(*deck.bodies[0].cells, (std::array<int, 3>{16, 16, 81}));
  EXPECT_FALSE(deck.tool);
  expect_round_trip(deck);
}

TEST(deck, resolved_deck_reads_back_the_same) { expect_round_trip(read_text(good_deck)); }

TEST(deck, resolved_deck_keeps_every_bit_of_every_kind_of_value) {
  Deck deck = read_text(good_deck);
  deck.title = "a \"quoted\" title, \\ and µ";
  deck.materials[0].name = "Ti-6Al-4V (annealed)";
  deck.materials[0].damage = {-0.09, 0.25, -1.0 / 3, 0.014, 3.87};
  for (BodyDeck& body : deck.bodies) {
    body.material = deck.materials[0].name;
    body.origin = {1.0 / 3e4, -2.0 / 7e4, -0.0};
    body.temperature = 300 + 1.0 / 3;
  }
  deck.tool->runout = 1e-6 / 3;
  deck.tool->feed_direction = {1.0 / 3, -2.0 / 3, 0};
  deck.contact.shear_limit = 1e9 / 3;
  deck.particles.correction = false;
  deck.particles.viscosity_linear = 0.1 + 0.2;
  deck.hexes.delete_at_strain = 2.0 / 3;
  deck.run.gravity = {0, 0, -9.80665};
  deck.run.accuracy = 10.0 / 3;
  deck.output.picture_immersion = {};
  deck.output.checkpoint_time = 1e-5 / 7;
  expect_round_trip(deck);
}

TEST(deck, tools_and_sphere_read_back_the_same) {
  TemporaryFolder folder;
  folder.write("tool.stl", "solid\nendsolid\n");
  const std::string head = R"([material.m]
law = "elastic"
density = "1 g/cm3"
youngs_modulus = "1 MPa"
poissons_ratio = 0.3
[[body]]
name = "ball"
shape = "sphere"
fill = "particles"
material = "m"
outer_radius = "4 mm"
inner_radius = "3 mm"
spacing = "0.2 mm"
[run]
end_time = "1 ms"
[contact]
friction = 0
[tool]
)";
  for (const std::string tool :
       {"kind = \"wall\"\nsize = \"3 mm\"", "kind = \"stl\"\nfile = \"tool.stl\"\nspindle_speed = \"1 rpm\"",
        "kind = \"wedge\"\nrake = \"15 deg\"\nclearance = \"2 deg\"\nedge_radius = \"20 um\"\nwidth = \"1 "
        "mm\"\n"
        "height = \"1 mm\"\nvelocity = [\"30 m/min\", \"0 m/s\", \"0 m/s\"]"}) {
    const Deck deck = read_deck(folder.write("deck.toml", head + tool));
    expect_round_trip(deck); // read from another folder: the STL file is found by its absolute name
  }
}

// There is no other default than that of the row: a section made in code has what a deck without the key has.
template <class Section>
void expect_row_defaults(const Keys<Section>& keys, const Section& made) {
  for (const auto& key : keys) {
    if (!applies(keys, key, made) || decides(keys, key.name)) continue; // the constructor is told these
    Section alone = made;
    clear_fields(keys, alone);
    const std::string nothing = write_field(key, alone);
    if (has_default(key)) fill_default(key, alone);
    EXPECT_EQ(write_field(key, made), has_default(key) ? write_field(key, alone) : nothing) << key.name;
  }
}

TEST(deck, a_section_made_in_code_has_the_defaults_of_the_rows) {
  for (std::size_t k = 0; k < words<Law>().size(); ++k)
    expect_row_defaults(material_keys(), MaterialDeck(Law(int(k))));
  for (std::size_t k = 0; k < words<BodyShape>().size(); ++k)
    for (const Fill fill : {Fill::particles, Fill::hexes})
      expect_row_defaults(body_keys(), BodyDeck(BodyShape(int(k)), fill));
  for (std::size_t k = 0; k < words<ToolKind>().size(); ++k)
    expect_row_defaults(tool_keys(), ToolDeck(ToolKind(int(k))));
  const Deck deck;
  expect_row_defaults(top_keys(), deck), expect_row_defaults(contact_keys(), deck.contact);
  expect_row_defaults(particles_keys(), deck.particles), expect_row_defaults(hexes_keys(), deck.hexes);
  expect_row_defaults(sleep_keys(), deck.sleep), expect_row_defaults(retire_keys(), deck.retire);
  expect_row_defaults(run_keys(), deck.run), expect_row_defaults(output_keys(), deck.output);
  expect_row_defaults(windows_keys(), WindowsDeck()), expect_row_defaults(face_keys(), FaceDeck("x_min"));
  expect_row_defaults(mechanistic_keys(), MechanisticDeck());
  EXPECT_EQ(deck.particles.viscosity_linear, 0.3); // two of them as docs/guide and the reference page say
  EXPECT_EQ(ToolDeck(ToolKind::end_mill).core_ratio, 0.6);
  EXPECT_EQ(ToolDeck(ToolKind::wall).core_ratio, 0); // does not apply
}

// What a deck leaves out is what code leaves out.
TEST(deck, a_deck_without_a_section_reads_as_one_made_in_code) {
  const Deck read = read_text(good_deck), made;
  EXPECT_EQ(read.particles, made.particles);
  EXPECT_EQ(read.hexes, made.hexes);
  EXPECT_EQ(read.sleep, made.sleep);
}

TEST(words, name_their_values_and_no_others) {
  EXPECT_EQ(value_of_word<ToolKind>("wedge"), ToolKind::wedge);
  EXPECT_EQ(word_of(Law::zerilli_armstrong), "zerilli_armstrong");
  EXPECT_THROW(value_of_word<Fill>("sand"), std::out_of_range);
  EXPECT_EQ(words<FaceKind>().size(), std::size_t(FaceKind::velocity) + 1);
  EXPECT_EQ(words<Law>().size(), std::size_t(Law::rigid) + 1);
  EXPECT_EQ(words<PictureField>().size(), std::size_t(PictureField::velocity) + 1);
}

TEST(deck, every_key_has_help_and_stands_in_the_reference) {
  const std::string page = key_reference();
  const auto check = [&](const auto& keys) {
    for (const auto& key : keys) {
      EXPECT_GT(key.help.size(), 0u) << key.name;
      EXPECT_NE(page.find("| `" + key.name + "` | "), std::string::npos) << key.name;
    }
  };
  check(top_keys()), check(material_keys()), check(body_keys()), check(face_keys()), check(tool_keys());
  check(contact_keys()), check(particles_keys()), check(hexes_keys()), check(run_keys()),
      check(output_keys());
  check(published_keys());
}

TEST(deck, shipped_decks_read_and_resolve) {
  int decks = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SWARF_SOURCE_DIR "/inputs")) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path().string());
    ++decks;
    const Deck deck = read_deck(entry.path().string());
    EXPECT_NE(deck.title, "untitled");
    expect_round_trip(deck);
  }
  EXPECT_GE(decks, 5);
}

TEST(deck, the_paper_s_scene_has_its_counts) { // Demiral & Mamedov 2022: 370 689 particles, 123 840 elements
  const Deck deck = read_deck(SWARF_SOURCE_DIR "/inputs/micro_milling.toml");
  int particles = 0, hexes = 0;
  for (const BodyDeck& body : deck.bodies) {
    const auto& [around, axial, radial] = *body.cells;
    (body.fill == Fill::hexes ? hexes : particles) += around * axial * radial;
  }
  EXPECT_EQ(particles, 370689);
  EXPECT_EQ(hexes, 123840);
}
