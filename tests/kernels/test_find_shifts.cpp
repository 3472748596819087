// Shifts of blocks of particles. Theory: an even lattice rests, also at its surface; disorder inside goes and
// the surface stays; a rigid motion of the block, a ghost in place of a particle or another number of
// threads changes nothing; no particle goes farther than it has flowed.
#include "support/bits.hpp"
#include "support/shifting_block.hpp"
#include "swarf/particles/shifting.hpp"
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <gtest/gtest.h>
#include <string>

namespace swarf::test {
namespace {

constexpr double epsilon = double(Kokkos::Experimental::epsilon_v<Real>);
constexpr Real plenty = 1000; // strain: the budget does not matter

// Of a block n x n x n: how many layers lie between a particle and the nearest face of each axis.
std::array<int, 3> depth_of(int identity, int n) {
  std::array<int, 3> depth{};
  for (int& d : depth) d = std::min(identity % n, n - 1 - identity % n), identity /= n;
  return depth;
}
int faces_at(int identity, int n) { // 0 inside, 1 on a face, 2 on an edge, 3 at a corner
  int faces = 0;
  for (const int d : depth_of(identity, n)) faces += d == 0;
  return faces;
}

double largest_difference(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, double(norm(a[i] - b[i])));
  return most;
}
double largest(const std::vector<Vector3>& a) {
  return largest_difference(a, std::vector<Vector3>(a.size(), Vector3{0, 0, 0}));
}

} // namespace

// Nothing on the surface moves, in or out or along it, by a thousandth of a spacing. At the first call the
// layer below does not know of the surface yet, and moves 0.0153 spacings; then 0.004 and less.
TEST(FindShifts, AnEvenBlockRestsAlsoAtItsSurface) {
  constexpr int n = 9;
  ParticleBlock b = flowing_block(n, n, n, 0, 1);
  const auto before = by_identity(b, b.particles.position);
  build_lists(b);
  for (int call = 0; call < 8; ++call) {
    const Shifts shifts = shift_once(b);
    ASSERT_EQ(shifts.clusters(), b.neighbors.clusters);
    const auto d = by_identity(b, shifts, shifts.displacement), out = by_identity(b, shifts, shifts.normal);
    for (int i = 0; i < n * n * n; ++i) {
      const int faces = faces_at(i, n);
      EXPECT_EQ(norm(out[std::size_t(i)]) > 0, faces > 0) << i;
      EXPECT_LE(norm(d[std::size_t(i)]) / unit, faces > 0 ? 1e-3 : call == 0 ? 0.0155 : 0.005) << i;
      EXPECT_NEAR(dot(d[std::size_t(i)], out[std::size_t(i)]) / unit, 0, 100 * epsilon) << i;
    }
    build_lists(b);
  }
  EXPECT_LT(largest_difference(by_identity(b, b.particles.position), before) / unit, 0.02);
}

// At faces, edges and corners of an even block the way out is that of symmetry.
TEST(FindShifts, NormalsPointOut) {
  constexpr int n = 9;
  ParticleBlock b = flowing_block(n, n, n, 0, 1);
  build_lists(b);
  const Shifts shifts = shift_once(b);
  const auto normal = by_identity(b, shifts, shifts.normal),
             kept = by_identity(b, b.particles.surface_normal);
  EXPECT_EQ(largest_difference(normal, kept), 0);
  for (const int layer : {0, n - 1}) {
    const Real sign = layer == 0 ? Real(-1) : Real(1), middle = n / 2;
    const auto at = [&](Real i, Real j, Real k) { return normal[std::size_t(i + n * (j + n * k))]; };
    const Real two = sign / std::sqrt(Real(2)), three = sign / std::sqrt(Real(3)), l = Real(layer);
    EXPECT_LT(norm(at(l, middle, middle) - Vector3{sign, 0, 0}), 100 * epsilon);
    EXPECT_LT(norm(at(middle, l, middle) - Vector3{0, sign, 0}), 100 * epsilon);
    EXPECT_LT(norm(at(middle, l, l) - Vector3{0, two, two}), 100 * epsilon);
    EXPECT_LT(norm(at(l, l, l) - Vector3{three, three, three}), 100 * epsilon);
  }
}

TEST(FindShifts, WhatHasNotFlowedIsNotLookedAt) {
  ParticleBlock b = flowing_block(6, 6, 6, Real(0.2), Real(0.5));
  Kokkos::deep_copy(b.particles.shifted_strain, Real(0.5));
  build_lists(b);
  EXPECT_EQ(find_shifts(b.particles, b.neighbors, {}, b.method).clusters(), 0);
  // Of one particle that has: its cluster, and only itself moves.
  const int row = 77;
  const auto strain = host_copy(b.particles.points.equivalent_plastic_strain);
  strain(row) = Real(0.6);
  Kokkos::deep_copy(b.particles.points.equivalent_plastic_strain, strain);
  const Shifts shifts = find_shifts(b.particles, b.neighbors, {}, b.method);
  ASSERT_EQ(shifts.clusters(), 1);
  const auto d = by_identity(b, shifts, shifts.displacement);
  const std::size_t moved = std::size_t(host_copy(b.particles.identity)(row));
  for (std::size_t i = 0; i < d.size(); ++i) EXPECT_EQ(norm(d[i]) > 0, i == moved) << i;
}

// Distances of neighbours inside become even within a few calls; the faces stay where they are.
TEST(FindShifts, ADisorderedBlockBecomesEvenAndKeepsItsSurface) {
  constexpr int n = 12;
  ParticleBlock b = flowing_block(n, n, n, Real(0.2), plenty);
  struct Measured {
    double nearest = 0;                   // 5th percentile inside, spacings
    std::array<double, 6> plane{}, box{}; // of the faces, spacings
  };
  const auto measure = [&] {
    const auto x = by_identity(b, b.particles.position);
    Measured m;
    std::vector<double> nearest;
    m.box = {99, 99, 99, 0, 0, 0};
    for (int i = 0; i < n * n * n; ++i) {
      const Vector3 x_i = x[std::size_t(i)];
      const double at[3] = {x_i.x / unit, x_i.y / unit, x_i.z / unit};
      const std::array<int, 3> depth = depth_of(i, n), index = {i % n, i / n % n, i / n / n};
      for (std::size_t a = 0; a < 3; ++a) {
        m.box[a] = std::min(m.box[a], at[a]), m.box[a + 3] = std::max(m.box[a + 3], at[a]);
        if (index[a] == 0) m.plane[a] += at[a] / (n * n);
        if (index[a] == n - 1) m.plane[a + 3] += at[a] / (n * n);
      }
      if (*std::min_element(depth.begin(), depth.end()) < 2) continue;
      double least = 99;
      for (const Vector3& x_j : x)
        if (const double r = norm(x_i - x_j) / unit; r > 0) least = std::min(least, r);
      nearest.push_back(least);
    }
    std::sort(nearest.begin(), nearest.end());
    m.nearest = nearest[nearest.size() / 20];
    return m;
  };
  const Measured before = measure();
  EXPECT_LT(before.nearest, 0.7);
  build_lists(b);
  for (int call = 0; call < 20; ++call) shift_once(b), build_lists(b);
  const Measured after = measure();
  EXPECT_GE(after.nearest, 0.9);
  for (std::size_t a = 0; a < 6; ++a) {
    EXPECT_NEAR(after.plane[a], before.plane[a], 0.02) << a;
    EXPECT_NEAR(after.box[a], before.box[a], 0.03) << a;
  }
}

// d and n of the block turned are the turned d and n; twice, for the second call sees the normals of the
// first.
TEST(FindShifts, TurnsWithTheBlock) {
  const Tensor3 R = oblique_rotation();
  ParticleBlock blocks[2];
  for (int turned = 0; turned < 2; ++turned) {
    blocks[turned] = flowing_block(8, 7, 6, Real(0.2), plenty);
    if (turned)
      set_rows(blocks[turned].particles.position, blocks[turned].particles.count,
               [&](const Vector3& x) { return multiply(R, x); });
    build_lists(blocks[turned]);
  }
  for (int call = 0; call < 2; ++call) {
    std::vector<Vector3> d[2], normal[2];
    for (int turned = 0; turned < 2; ++turned) {
      const Shifts shifts = shift_once(blocks[turned]);
      d[turned] = by_identity(blocks[turned], shifts, shifts.displacement);
      normal[turned] = by_identity(blocks[turned], shifts, shifts.normal);
    }
    int at_surface = 0;
    for (std::size_t i = 0; i < d[0].size(); ++i) {
      d[0][i] = multiply(R, d[0][i]), normal[0][i] = multiply(R, normal[0][i]);
      at_surface += norm(normal[0][i]) > 0;
    }
    EXPECT_GT(largest(d[1]), 0.04 * unit);
    EXPECT_LT(largest_difference(d[0], d[1]) / unit, 1e4 * epsilon);
    EXPECT_LT(largest_difference(normal[0], normal[1]), 1e4 * epsilon);
    EXPECT_GT(at_surface, 8 * 7 * 2);
  }
}

// What a face holds, is frozen or is tied stays with all it has; it is a neighbour all the same.
TEST(FindShifts, WhatIsHeldOrTiedStays) {
  ParticleBlock b = flowing_block(8, 7, 6, Real(0.2), plenty);
  Particles& p = b.particles;
  const int tied = 64;
  p.count -= tied, p.tied = tied, p.whole -= tied;
  build_lists(b);
  const auto constraints = host_copy(p.constraints);
  for (int i = 0; i < p.count; ++i) constraints(i) = i % 5 == 0 ? 2u : i % 5 == 1 ? held_bit : 0u;
  Kokkos::deep_copy(p.constraints, constraints);
  set_rows(p.velocity, p.stored, [&, i = 0](const Vector3&) mutable {
    return Vector3{Real(++i % 7), Real(i % 11), Real(i % 13)};
  });
  const auto x = by_identity(b, p.position), v = by_identity(b, p.velocity);
  const Shifts shifts = shift_once(b);
  const auto x_after = by_identity(b, p.position), v_after = by_identity(b, p.velocity);
  const auto first = host_copy(b.neighbors.first), size = host_copy(b.neighbors.size);
  int with_one_that_moves = 0; // all, unless a cluster is a single particle
  for (int c = 0; c < b.neighbors.clusters; ++c) {
    bool moves = false;
    for (int i = first(c); i < first(c) + size(c); ++i) moves = moves || i % 5 >= 2;
    with_one_that_moves += moves;
  }
  EXPECT_EQ(shifts.clusters(), with_one_that_moves);
  const auto identity = host_copy(p.identity);
  for (int i = 0; i < p.stored; ++i) {
    const bool stays = i >= p.count || i % 5 < 2;
    const std::size_t k = std::size_t(identity(i));
    EXPECT_EQ(norm(x[k] - x_after[k]) > 0, !stays) << i;
    EXPECT_EQ(norm(v[k] - v_after[k]) > 0, !stays) << i;
  }
}

// The normal force of the tool is what is left of its force without friction; where none is now, friction
// that is remembered says nothing.
TEST(FindShifts, MovesAlongTheToolThatTouches) {
  const Vector3 pressed{3, -2, 6}, friction{0, 3, 1};
  ParticleBlock b = flowing_block(8, 7, 6, Real(0.2), plenty);
  const Particles& p = b.particles;
  build_lists(b);
  const auto found = [&] { return find_shifts(p, b.neighbors, {}, b.method); };
  const Shifts before = found();
  const auto touches = [](int i) { return i % 3 == 0; };
  const auto contact = host_copy(p.contact_force), remembered = host_copy(p.friction_force);
  for (int i = 0; i < p.count; ++i) {
    store_vector(remembered, i, friction);
    if (touches(i)) store_vector(contact, i, pressed + friction);
  }
  Kokkos::deep_copy(p.friction_force, remembered), Kokkos::deep_copy(p.contact_force, contact);
  const Shifts after = found();
  const auto identity = host_copy(p.identity);
  const auto d_before = by_identity(b, before, before.displacement);
  const auto d = by_identity(b, after, after.displacement), normal = by_identity(b, after, after.normal);
  for (int i = 0; i < p.count; ++i) {
    const std::size_t k = std::size_t(identity(i));
    if (touches(i)) {
      EXPECT_LT(norm(normal[k] + Real(1) / 7 * pressed), 100 * epsilon);
      EXPECT_NEAR(dot(d[k], pressed) / (7 * unit), 0, 100 * epsilon);
      EXPECT_GT(norm(d[k]), 0);
    } else {
      EXPECT_EQ(norm(d[k] - d_before[k]), 0);
    }
  }
}

// A slice that is periodic along z against the middle of three in a row; the second call sees normals of
// ghosts.
TEST(FindShifts, APeriodicSliceIsTheMiddleOfMany) {
  constexpr int layers = 7, count = 6 * 5 * layers;
  const Real length = layers * unit;
  const GhostPlanes planes = periodic_along(2, length);
  ParticleBlock slice = flowing_block(6, 5, layers, Real(0.2), plenty),
                row = flowing_block(6, 5, 3 * layers, 0, plenty);
  const Status status("status");
  Kokkos::deep_copy(status, no_fault);
  wrap_periodic(slice.particles, planes, status);
  const auto x = by_identity(slice, slice.particles.position);
  set_rows(row.particles.position, 3 * count, [&, i = 0](const Vector3&) mutable {
    const Vector3 moved = x[std::size_t(i % count)] + Real(i / count - 1) * Vector3{0, 0, length};
    return ++i, moved;
  });
  build_lists(slice, planes), build_lists(row);
  for (int call = 0; call < 2; ++call) {
    const Shifts in_slice = shift_once(slice, planes), in_row = shift_once(row);
    const auto d = by_identity(slice, in_slice, in_slice.displacement),
               d_row = by_identity(row, in_row, in_row.displacement);
    const auto normal = by_identity(slice, in_slice, in_slice.normal),
               normal_row = by_identity(row, in_row, in_row.normal);
    EXPECT_GT(largest(d), 0.04 * unit);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_LT(norm(d[i] - d_row[count + i]) / unit, 1e4 * epsilon) << i;
      EXPECT_LT(norm(normal[i] - normal_row[count + i]), 1e4 * epsilon) << i;
    }
  }
}

namespace {

constexpr Tensor3 left{0, -1, 0, 1, 0, 0, 0, 0, 1}, right{0, 1, 0, -1, 0, 0, 0, 0, 1}; // by 90 degrees
const GhostPlanes quarter = {{{1, 0, 0}, 0, {right, {0, 0, 0}}, true, true},
                             {{0, 1, 0}, 0, {left, {0, 0, 0}}, true, true}};

// Disordered particles of a quarter of a ring, mean radii 6 .. 9 spacings, 5 layers.
std::vector<Vector3> quarter_of_ring() {
  std::vector<Vector3> x;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<Real> shift(Real(-0.2), Real(0.2));
  for (int layer = 0; layer < 5; ++layer)
    for (int r = 6; r < 10; ++r) {
      const int n = int(std::lround(1.57 * r));
      for (int k = 0; k < n; ++k) {
        const Real radius = (r + shift(random)) * unit;
        const Real angle = Real(1.5707963267948966) * (k + Real(0.5) + shift(random)) / n;
        x.push_back({radius * std::cos(angle), radius * std::sin(angle), (layer + shift(random)) * unit});
      }
    }
  return x;
}

// The quarter `copies` times, each turned by a right angle from the last.
ParticleBlock ring(int copies, const GhostPlanes& planes) {
  const std::vector<Vector3> x = quarter_of_ring();
  ParticleBlock b = flowing_block(int(x.size()) * copies, 1, 1, 0, plenty);
  set_rows(b.particles.position, b.particles.count, [&, i = std::size_t(0)](const Vector3&) mutable {
    Vector3 at = x[i % x.size()];
    for (std::size_t k = 0; k < i / x.size(); ++k) at = multiply(left, at);
    return ++i, at;
  });
  build_lists(b, planes);
  return b;
}

} // namespace

TEST(FindShifts, ASectorIsAQuarterOfARing) {
  const ParticleBlock sector = ring(1, quarter), whole = ring(4, {});
  ASSERT_GT(sector.neighbors.ghosts, 50);
  for (int call = 0; call < 2; ++call) {
    const Shifts in_sector = shift_once(sector, quarter), in_whole = shift_once(whole);
    const auto d = by_identity(sector, in_sector, in_sector.displacement),
               d_whole = by_identity(whole, in_whole, in_whole.displacement);
    const auto normal = by_identity(sector, in_sector, in_sector.normal),
               normal_whole = by_identity(whole, in_whole, in_whole.normal);
    EXPECT_GT(largest(d), 0.04 * unit);
    for (std::size_t i = 0; i < d.size(); ++i) {
      EXPECT_LT(norm(d[i] - d_whole[i]) / unit, 1e4 * epsilon) << i;
      EXPECT_LT(norm(normal[i] - normal_whole[i]), 1e4 * epsilon) << i;
    }
  }
}

// Strain that differs from particle to particle, and is transported.
TEST(FindShifts, NoParticleGoesFartherThanItHasFlowed) {
  ParticleBlock b = flowing_block(8, 8, 8, Real(0.2), 0);
  const auto strain = host_copy(b.particles.points.equivalent_plastic_strain);
  std::vector<double> may(std::size_t(b.particles.count)), gone(may.size(), 0);
  std::mt19937_64 random(3);
  for (std::size_t i = 0; i < may.size(); ++i) {
    strain(int(i)) = Real(0.05) * std::uniform_real_distribution<Real>(0, 1)(random);
    may[i] = double(shift_per_strain) * double(strain(int(i)));
  }
  Kokkos::deep_copy(b.particles.points.equivalent_plastic_strain, strain);
  build_lists(b);
  for (int call = 0; call < 30; ++call) {
    const Shifts shifts = shift_once(b);
    const auto d = by_identity(b, shifts, shifts.displacement);
    for (std::size_t i = 0; i < d.size(); ++i) gone[i] += norm(d[i]) / unit;
    build_lists(b);
  }
  int spent = 0;
  for (std::size_t i = 0; i < gone.size(); ++i) {
    EXPECT_LE(gone[i], may[i] * (1 + 1000 * epsilon)) << i;
    spent += gone[i] > 0.99 * may[i];
  }
  EXPECT_GT(spent, 100);
}

// Ten calls printed as bits, by this program run with other numbers of threads.
TEST(FindShifts, PrintsItsBits) {
  ParticleBlock b = flowing_block(16, 16, 16, Real(0.2), Real(0.2)); // more than a block of a sum
  std::mt19937_64 random(3);
  set_rows(b.particles.velocity, b.particles.count, [&](const Vector3&) {
    std::uniform_real_distribution<Real> u(-1, 1);
    return Vector3{u(random), u(random), u(random)};
  });
  build_lists(b);
  for (int call = 0; call < 10; ++call) shift_once(b), build_lists(b);
  unsigned long long bits = 1469598103934665603ULL; // FNV-1a
  for (const VectorField& field : {b.particles.position, b.particles.velocity, b.particles.surface_normal}) {
    const auto value = host_copy(field);
    for (int i = 0; i < b.particles.count; ++i)
      for (int d = 0; d < 3; ++d) {
        unsigned char bytes[sizeof(Real)];
        std::memcpy(bytes, &value(i, d), sizeof bytes);
        for (const unsigned char byte : bytes) bits = (bits ^ byte) * 1099511628211ULL;
      }
  }
  std::printf("bits %016llx\n", bits);
}

TEST(FindShifts, SameBitsOnOneAndTwoThreads) {
  const std::string one = bits_with_threads("FindShifts.PrintsItsBits", 1);
  ASSERT_GT(one.size(), 16u);
  EXPECT_EQ(one, bits_with_threads("FindShifts.PrintsItsBits", 2));
}

} // namespace swarf::test
