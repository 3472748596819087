// Runs a deck made in memory, and looks at its particles or nodes in an order that sorting does not change.
#pragma once
#include "src/simulation/simulation.hpp"
#include "tests/src/scene_decks.hpp"
#include "tests/support/temporary_folder.hpp"
#include <fstream>

namespace swarf::test {

// Every key of the method at its shipped default. Materials, bodies, tool and end are the case's own.
inline Deck shipped_defaults() {
  Deck deck;
  deck.file = "deck.toml", deck.run.end_time = 1;
  MaterialDeck elastic(Law::elastic);
  elastic.name.assign(1, 'a'); // GCC 12 warns of = "a" without a cause
  elastic.density = 1000, elastic.youngs_modulus = 1e9, elastic.poissons_ratio = 0.3;
  deck.materials = {elastic};
  return deck;
}

// What stabilises particles, as a test varies it.
struct Stabiliser {
  double stiffness = 0;

  // Without a stiffness of 1 soft material tears in tension, and its shreds outrun the looks at the highest
  // mode: at the default Courant number such a run ends as unstable.
  void apply(Deck& deck) const {
    deck.particles.hourglass_stiffness = stiffness;
    if (stiffness < 1) deck.run.courant = 0.3;
  }
  std::string text() const {
    char text[64];
    std::snprintf(text, sizeof text, ", hourglass stiffness %g", stiffness);
    return text;
  }
};

// The same without any damping.
inline Deck undamped() {
  Deck deck = shipped_defaults();
  deck.particles.viscosity_linear = deck.particles.viscosity_quadratic = 0;
  deck.particles.pressure_diffusion = 0;
  deck.hexes.viscosity_linear = deck.hexes.viscosity_quadratic = 0;
  return deck;
}

inline MaterialDeck elastic_material(double density, double E, double nu) {
  MaterialDeck m = shipped_defaults().materials[0];
  m.name = "Ti", m.density = density, m.youngs_modulus = E,
  m.poissons_ratio = nu; // the name that block() uses
  return m;
}

inline void hold(BodyDeck& body, const std::string& kind, const std::vector<const char*>& faces) {
  for (const char* face : faces) body.faces.emplace_back(face, value_of_word<FaceKind>(kind));
}

struct PointState {
  Triple x{}, v{};
};

// Particles in the order of their identity, or the nodes of a scene without particles.
inline std::vector<PointState> snapshot(const Scene& scene) {
  const bool particles = scene.particles.whole > 0;
  std::vector<int> rows = particle_rows(scene.particles);
  if (!particles)
    for (int a = 0; a < scene.hexes.nodes; ++a) rows.push_back(a);
  const auto x = host_copy(particles ? scene.particles.position : scene.hexes.position);
  const auto v = host_copy(particles ? scene.particles.velocity : scene.hexes.velocity);
  const auto identity = host_copy(scene.particles.identity);
  std::vector<PointState> all(rows.size(), PointState{});
  for (int i : rows)
    for (int d = 0; d < 3; ++d) {
      PointState& p = all[std::size_t(particles ? identity(i) : i)];
      p.x[d] = double(x(i, d)), p.v[d] = double(v(i, d));
    }
  return all;
}

// Before start(): the velocity of every particle and node as a function of its position.
template <class Function>
void set_velocity(const Scene& scene, Function&& function) {
  const auto set = [&](const VectorField& position, const VectorField& velocity) {
    const auto x = host_copy(position), v = host_copy(velocity);
    for (std::size_t i = 0; i < v.extent(0); ++i) {
      const Triple u = function(Triple{double(x(i, 0)), double(x(i, 1)), double(x(i, 2))});
      for (int d = 0; d < 3; ++d) v(i, d) = Real(u[d]);
    }
    Kokkos::deep_copy(velocity, v);
  };
  set(scene.particles.position, scene.particles.velocity), set(scene.hexes.position, scene.hexes.velocity);
}

// Steps to the end time; observe() after each step.
template <class Observe>
void run_until(Simulation& simulation, double end, Observe&& observe) {
  while (simulation.time() < end) {
    simulation.step();
    if (simulation.steps_to_check() <= 0) simulation.check();
    observe();
  }
}

} // namespace swarf::test
