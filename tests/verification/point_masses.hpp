// Sums over everything that carries mass, particles and nodes alike, and what has torn.
#pragma once
#include "tests/verification/drive.hpp"
#include <algorithm>
#include <functional>
#include <numeric>

namespace swarf::test {

// Every key of the method at its shipped default, and titanium.
inline Deck default_deck() {
  Deck deck = shipped_defaults();
  deck.materials = {titanium()};
  return deck;
}

// Steps until `end`; look() only when the program would look: sums cost more than steps.
inline void advance(Simulation& simulation, double end, const std::function<void()>& look = {}) {
  while (simulation.time() < end) {
    simulation.step();
    if (simulation.steps_to_check() > 0) continue;
    simulation.check();
    if (look) look();
  }
}

// A particle or a node. Particles are sorted on the way: `name` stays, and counts from 0 over all of them.
struct PointMass {
  int name;
  double mass;
  Vector3 x, v, force;
};
inline std::vector<PointMass> point_masses(const Scene& scene) {
  std::vector<PointMass> all;
  const auto add = [&](const ScalarField& mass, const VectorField& position, const VectorField& velocity,
                       const VectorField& force, int rows, const IndexField& identity) {
    const auto m = host_copy(mass);
    const auto x = host_copy(position), v = host_copy(velocity), f = host_copy(force);
    const auto id = host_copy(identity); // without rows: nodes keep theirs
    const int first = int(all.size());
    for (int i = 0; i < rows; ++i)
      all.push_back({id.extent(0) > 0 ? id(i) : first + i, double(m(i)), load_vector(x, i), load_vector(v, i),
                     load_vector(f, i)});
  };
  const Particles& p = scene.particles;
  const HexMesh& h = scene.hexes;
  add(p.points.mass, p.position, p.velocity, p.force, p.count, p.identity);
  add(h.mass, h.position, h.velocity, h.force, h.nodes, IndexField());
  return all;
}

inline Vector3 angular_momentum(const Scene& scene) {
  Vector3 total{0, 0, 0};
  for (const PointMass& p : point_masses(scene)) total = total + Real(p.mass) * cross(p.x, p.v);
  return total;
}

// Parts of the particles that no pair nearer than `reach` joins: 1 where nothing has torn.
inline int count_parts(const Particles& p, double reach) {
  const auto x = host_copy(p.position);
  std::vector<int> part(std::size_t(p.count));
  std::iota(part.begin(), part.end(), 0);
  const auto root = [&](int i) {
    while (part[std::size_t(i)] != i) i = part[std::size_t(i)] = part[std::size_t(part[std::size_t(i)])];
    return i;
  };
  std::vector<int> order = part; // along x, so that only near pairs are looked at
  std::sort(order.begin(), order.end(), [&](int a, int b) { return x(a, 0) < x(b, 0); });
  int parts = p.count;
  for (std::size_t a = 0; a < order.size(); ++a)
    for (std::size_t b = a + 1; b < order.size(); ++b) {
      const Vector3 d = load_vector(x, order[b]) - load_vector(x, order[a]);
      if (double(d.x) > reach) break;
      if (double(norm(d)) > reach) continue;
      const int i = root(order[a]), j = root(order[b]);
      if (i != j) part[std::size_t(i)] = j, --parts;
    }
  return parts;
}

} // namespace swarf::test
