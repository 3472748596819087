// Contact of bodies in whole runs: killed and resumed, and on two threads, the bytes are the same; what may
// not meet costs nothing; friction heats both sides.
#include "src/output/write_hdf5.hpp"
#include "tests/support/run_program.hpp"
#include "tests/verification/point_masses.hpp"
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;
namespace fs = std::filesystem;

namespace {

// A block slides over another, both at rest along z but for a press of 20 m/s.
std::string sliding(const std::string& first, const std::string& second, const std::string& more) {
  const auto body = [](const std::string& name, const std::string& fill, const std::string& keys) {
    return "[[body]]\nname = \"" + name + "\"\nshape = \"block\"\nfill = \"" + fill +
           "\"\nmaterial = \"steel\"\n" + keys;
  };
  return "[material.steel]\nlaw = \"linear_hardening\"\ndensity = \"7800 kg/m3\"\nyoungs_modulus = \"200 "
         "GPa\"\n"
         "poissons_ratio = 0.3\nyield_stress = \"400 MPa\"\nhardening_modulus = \"1 GPa\"\n" +
         body(
             "anvil", first,
             "origin = [\"0 um\", \"0 um\", \"-4 um\"]\nsize = [\"8 um\", \"8 um\", \"4 um\"]\nspacing = \"1 "
             "um\"\n[body.faces]\nz_min = \"fixed\"\n") +
         body("slider", second,
              "origin = [\"1.3 um\", \"2.2 um\", \"0.05 um\"]\nsize = [\"4 um\", \"4 um\", \"3.2 "
              "um\"]\nspacing = "
              "\"0.8 um\"\nvelocity = [\"50 m/s\", \"10 m/s\", \"-20 m/s\"]\n") +
         "[contact]\nfriction = 0.4\nbetween_bodies = \"hexes\"\n[run]\nend_time = \"20 ns\"\n[output]\n"
         "history_steps = 10\nframe_time = \"5 ns\"\n" +
         more;
}

std::string state_of(const fs::path& results) { return read_bytes(results / "checkpoint.h5"); }

} // namespace

TEST(BodyContact, threads_and_a_restart_change_nothing) {
  for (const auto& [first, second] : {std::pair("hexes", "hexes"), {"hexes", "particles"}}) {
    const TemporaryFolder folder;
    const std::string deck = write_deck(folder, sliding(first, second, ""));
    const auto run = [&](const std::string& name, std::vector<std::string> more, const char* threads = "1") {
      std::vector<std::string> arguments{"run",       deck,    "--output",     (folder / name).string(),
                                         "--threads", threads, "--no-pictures"};
      arguments.insert(arguments.end(), more.begin(), more.end());
      const Ended end = run_program(arguments);
      EXPECT_EQ(end.status, 0) << end.output;
    };
    run("whole", {}), run("two", {}, "2");
    for (int k = 1; k < 6; ++k)
      run("parts", {"--stop-after", std::to_string(37 * k), k > 1 ? "--resume" : "--overwrite"});
    run("parts", {"--resume"});
    EXPECT_EQ(state_of(folder / "whole"), state_of(folder / "two")) << first << " and " << second;
    EXPECT_EQ(state_of(folder / "whole"), state_of(folder / "parts")) << first << " and " << second;
  }
}

// J, of all points above 25 degrees, of one body.
double heat_of(const Simulation& simulation, const Deck& deck, int which) {
  const Scene& scene = simulation.scene();
  const double c = deck.materials[0].specific_heat.value, T0 = deck.bodies[0].temperature;
  double heat = 0;
  const auto add = [&](const MaterialPoints& points, const IndexField& bodies) {
    const auto m = host_copy(points.mass), T = host_copy(points.temperature);
    const auto body = host_copy(bodies);
    for (int i = 0; i < points.count; ++i)
      if (body(i) == which) heat += double(m(i)) * c * (double(T(i)) - T0);
  };
  add(scene.particles.points, scene.particles.body), add(scene.hexes.points, scene.hex_body);
  return heat;
}

TEST(BodyContact, friction_heats_both_sides_by_halves) {
  for (const auto& [first, second] : {std::pair("hexes", "hexes"), {"hexes", "particles"}}) {
    const TemporaryFolder folder;
    Deck deck = read_deck(write_deck(folder, sliding(first, second, "")));
    deck.materials[0].yield_stress = 1e15, deck.materials[0].taylor_quinney = 0;
    Simulation simulation(deck);
    simulation.start();
    advance(simulation, 20e-9);
    simulation.check();
    const double work = simulation.take_sample().frictional, a = heat_of(simulation, deck, 0),
                 b = heat_of(simulation, deck, 1);
    EXPECT_GT(work, 0.01 * simulation.initial_kinetic());
    EXPECT_NEAR((a + b) / work, 1, 1e-6) << first << " and " << second;
    EXPECT_NEAR(a / work, 0.5, 0.05) << "but for what was stored in springs when points parted";
  }
}

TEST(BodyContact, bodies_that_cannot_meet_have_no_fields_of_it) {
  const TemporaryFolder folder;
  const auto scene_of = [&](const std::string& who, const char* first) {
    std::string text = sliding(first, "particles", "");
    const std::string key = "between_bodies = ";
    text.replace(text.find(key) + key.size(), 7, who);
    return build_scene(read_deck(write_deck(folder, text)));
  };
  for (const Scene& scene : {scene_of("\"none\"", "hexes"), scene_of("\"hexes\"", "particles")}) {
    EXPECT_EQ(scene.contact_groups.count, 0);
    EXPECT_EQ(scene.particles.body_friction.extent(0), 0u);
    EXPECT_EQ(scene.hexes.body_contact_energy.extent(0), 0u);
  }
  EXPECT_GT(scene_of("\"hexes\"", "hexes").contact_groups.count, 0);
}
