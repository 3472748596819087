// A deck without a fault, which tests of faults edit, and its way to read_deck.
#pragma once
#include "src/deck/deck.hpp"
#include "tests/support/temporary_folder.hpp"
#include <stdexcept>
#include <string>

namespace swarf::test {

// Lines are counted by the tests: the first one is line 1.
inline const std::string good_deck = R"(title = "a mill and a ring"
[material.ti64]
law = "johnson_cook"
density = "4430 kg/m3"
youngs_modulus = "110 GPa"
poissons_ratio = 0.33
specific_heat = "526.3 J/kg/K"
A = "862 MPa"
B = "331 MPa"
n = 0.34
C = 0.012
m = 0.8
reference_temperature = "298.15 K"
melt_temperature = "1878 K"
[[body]]
name = "cut zone"
shape = "ring"
fill = "particles"
material = "ti64"
inner_radius = "400 um"
outer_radius = "430 um"
height = "10 um"
start_angle = "-10 deg"
end_angle = "20 deg"
spacing = "2.5 um"
tie = "bulk"
[body.faces]
bottom = "periodic"
top = "periodic"
[[body]]
name = "bulk"
shape = "ring"
fill = "hexes"
material = "ti64"
inner_radius = "430 um"
outer_radius = "500 um"
height = "10 um"
start_angle = "-10 deg"
end_angle = "20 deg"
cells = [20, 2, 8]
[body.faces]
outer = "fixed"
end = { velocity = ["0 m/s", "0 m/s", "1 mm/s"] }
[tool]
kind = "end_mill"
diameter = "800 um"
rake = "0 deg"
clearance = "10 deg"
edge_radius = "6 um"
length = "20 um"
spindle_speed = "10000 rpm"
feed_per_tooth = "10 um"
start_angle = "65 deg"
[contact]
friction = 0.5
[run]
end_immersion = "95 deg"
mass_factor = 1e4
[output]
frame_immersion = "5 deg"
picture_immersion = ["70 deg", "80 deg"]
published = [
  { label = "simulated", force = "10.1 N" },
  { label = "measured", force = "10.5 N" },
]
)";

// The good deck with `from` (which it must hold) replaced by `to`.
inline std::string edit_deck(const std::string& from, const std::string& to,
                             const std::string& deck = good_deck) {
  const auto at = deck.find(from);
  if (at == std::string::npos) throw std::logic_error("the good deck has no \"" + from + "\"");
  std::string text = deck;
  return text.replace(at, from.size(), to);
}

inline Deck read_text(const std::string& text) {
  return read_deck(TemporaryFolder().write("deck.toml", text));
}

} // namespace swarf::test
