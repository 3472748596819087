// Two cubes of hexes, one pressed a little into the other.
#pragma once
#include "bench/support/bench.hpp"
#include "tests/support/two_blocks.hpp"

namespace swarf::bench {

inline test::TwoBlocks make_two_cubes(int64_t size) {
  const int n = cube_edge(size / 2);
  test::TwoBlocks b = test::two_blocks(n, n, Real(1), -1e-3);
  find_body_contact(b.contact, b.mesh, b.particles, b.groups);
  return b;
}
inline const test::TwoBlocks& two_cubes(int64_t size) { return cached(size, make_two_cubes); }

} // namespace swarf::bench
