// A cube of hexes with eight tied particles in each, warm.
#pragma once
#include "bench/support/bench.hpp"
#include "bench/support/hex_cube.hpp"
#include "tests/support/tied_block.hpp"

namespace swarf::bench {

struct TiedCube : test::TiedBlock {
  MaterialTable materials;

  double count() const { return tie.count; }
  double nodes() const { return double(hexes.nodes) / tie.count; }        // per tied particle
  double hosts() const { return double(hexes.points.count) / tie.count; } // per tied particle
};

inline TiedCube make_tied_cube(int64_t size) {
  const int n = cube_edge(size / 8);
  TiedCube c{test::make_tied_block({n, n, n}, 8 * n * n * n), test::make_material_table({test::ti64()})};
  add_heat(c.hexes);
  c.particles.heat = ScalarField("heat", c.particles.stored);
  project_tie(c.tie, c.particles, c.hexes);
  return c;
}

inline const TiedCube& tied_cube(int64_t size) { return cached(size, make_tied_cube); }

} // namespace swarf::bench
