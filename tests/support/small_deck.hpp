// A small milling scene with all that a restart must carry: particles tied to hexes, periodic faces,
// friction.
#pragma once
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace swarf::test {

// 560 particles and 84 hexes; the tooth enters after a third of its 600 steps.
inline const std::string small_deck = R"(title = "a small cut"
[material.ti64]
law = "johnson_cook"
density = "4430 kg/m3"
youngs_modulus = "110 GPa"
poissons_ratio = 0.33
specific_heat = "526.3 J/kg/K"
conductivity = "7.2 W/m/K"
A = "862 MPa"
B = "331 MPa"
n = 0.34
C = 0.012
m = 0.8
reference_temperature = "25 degC"
melt_temperature = "1878 K"
damage = [-0.09, 0.25, -0.5, 0.014, 3.87]
[[body]]
name = "cut zone"
shape = "ring"
fill = "particles"
material = "ti64"
inner_radius = "400 um"
outer_radius = "415 um"
height = "10 um"
start_angle = "-1 deg"
end_angle = "4 deg"
cells = [14, 4, 10]
previous_tooth = true
tie = "bulk"
[body.faces]
bottom = "periodic"
top = "periodic"
[[body]]
name = "bulk"
shape = "ring"
fill = "hexes"
material = "ti64"
inner_radius = "415 um"
outer_radius = "445 um"
height = "10 um"
start_angle = "-1 deg"
end_angle = "4 deg"
cells = [7, 2, 6]
[body.faces]
outer = "fixed"
start = "fixed"
bottom = "periodic"
top = "periodic"
[tool]
kind = "end_mill"
diameter = "800 um"
rake = "0 deg"
clearance = "10 deg"
edge_radius = "6 um"
length = "30 um"
position = ["0 um", "0 um", "-10 um"]
spindle_speed = "10000 rpm"
feed_per_tooth = "10 um"
start_angle = "84.8 deg"
[contact]
friction = 0.5
[particles]
smoothing_length = "fixed"
[hexes]
hourglass = "stiffness"
[run]
end_immersion = "86.5 deg"
mass_factor = 1e5
courant = 0.3
[output]
history_steps = 10
frame_immersion = "0.5 deg"
checkpoint_time = "1.5 us"
)";

using Edits = std::vector<std::pair<std::string, std::string>>;

// A longer sector, so that there is something to freeze.
inline const Edits longer_sector = {{"start_angle = \"-1 deg\"\nend_angle = \"4 deg\"\ncells = [14,",
                                     "start_angle = \"-9 deg\"\nend_angle = \"4 deg\"\ncells = [36,"},
                                    {"start_angle = \"-1 deg\"\nend_angle = \"4 deg\"\ncells = [7,",
                                     "start_angle = \"-9 deg\"\nend_angle = \"4 deg\"\ncells = [19,"}};

// The small deck with each `from`, which it must hold, replaced by `to`.
inline std::string edit_small_deck(const Edits& edits) {
  std::string text = small_deck;
  for (const auto& [from, to] : edits) {
    const auto at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("the small deck has no \"" + from + "\"");
    text.replace(at, from.size(), to);
  }
  return text;
}

// A piece of 3 x 3 x 2 particles in front of the tooth, `x` um from the axis, that flies along x; m/s.
inline std::string loose_chip(double x, double velocity) {
  return "[[body]]\nname = \"chip\"\nshape = \"block\"\nfill = \"particles\"\nmaterial = \"ti64\"\n"
         "origin = [\"" +
         std::to_string(x) +
         " um\", \"-4 um\", \"2.5 um\"]\nsize = [\"7.5 um\", \"7.5 um\", \"5 um\"]\n"
         "spacing = \"2.5 um\"\nvelocity = [\"" +
         std::to_string(velocity) + " m/s\", \"0 m/s\", \"0 m/s\"]\n";
}

} // namespace swarf::test
