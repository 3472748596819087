// Every row of the table of particle fields does what it says, by rules that are written here once more.
#include "kernels/copy_to_ghosts.hpp"
#include "support/particle_block.hpp"
#include <array>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace swarf::test {
namespace {

constexpr int rows = 6, ghosts = 2;
constexpr Real untouched = 7;

template <class Field>
constexpr int columns_of() {
  if constexpr (Field::rank == 1)
    return 1;
  else
    return int(Field::static_extent(1));
}

template <class Host>
auto& entry(const Host& host, int i, int c) {
  if constexpr (Host::rank == 1)
    return host(i);
  else
    return host(i, c);
}

using RowsOf = std::map<std::string, std::vector<std::vector<Real>>>; // by field, row and column

RowsOf read(const Particles& p) {
  RowsOf out;
  for_each_field(p, [&](const char* name, const auto& field, auto) {
    const auto host = host_copy(field);
    auto& all = out[name];
    for (int i = 0; i < int(field.extent(0)); ++i) {
      all.emplace_back();
      for (int c = 0; c < columns_of<std::decay_t<decltype(field)>>(); ++c)
        all.back().push_back(Real(entry(host, i, c)));
    }
  });
  return out;
}

// All fields of all methods, no number of them twice; what has ghosts has room for them.
Particles filled_particles() {
  Particles p;
  p.count = p.points.count = p.listed = p.stored = p.total = p.whole = rows;
  int fields = 0;
  for_each_field(p, [&](const char* name, auto& field, auto facts) {
    using Field = std::decay_t<decltype(field)>;
    field = Field(name, rows + (facts.on_ghosts ? ghosts : 0));
    const auto host = host_copy(field);
    ++fields;
    for (int i = 0; i < int(field.extent(0)); ++i)
      for (int c = 0; c < columns_of<Field>(); ++c)
        entry(host, i, c) = typename Field::value_type(i < rows ? 100 * fields + 10 * i + c : untouched);
    Kokkos::deep_copy(field, host);
  });
  return p;
}

using Matrix = std::array<std::array<Real, 3>, 3>;

Matrix matrix_of(const Tensor3& R) { return {{{R.xx, R.xy, R.xz}, {R.yx, R.yy, R.yz}, {R.zx, R.zy, R.zz}}}; }

// sum_kl R_ik A_kl R_jl
Matrix turn(const Matrix& R, const Matrix& A) {
  Matrix out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 3; ++l) out[i][j] += R[i][k] * A[k][l] * R[j][l];
  return out;
}

std::vector<Real> turned(Frame frame, const std::vector<Real>& a, const Transform& map) {
  constexpr std::size_t place[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}};
  const Matrix R = matrix_of(map.R);
  std::vector<Real> out = a;
  const auto turn_vector = [&](std::size_t first, const Vector3& t) {
    const Real shift[3] = {t.x, t.y, t.z};
    for (std::size_t i = 0; i < 3; ++i) {
      out[first + i] = shift[i];
      for (std::size_t j = 0; j < 3; ++j) out[first + i] += R[i][j] * a[first + j];
    }
  };
  if (frame == Frame::point) turn_vector(0, map.t);
  if (frame == Frame::vector) turn_vector(0, {0, 0, 0});
  if (frame == Frame::scalar_and_vector) turn_vector(1, {0, 0, 0});
  if (frame != Frame::symmetric && frame != Frame::tensor) return out;
  Matrix A{};
  for (std::size_t c = 0; c < a.size(); ++c) {
    const std::size_t i = a.size() == 6 ? place[c][0] : c / 3, j = a.size() == 6 ? place[c][1] : c % 3;
    A[i][j] = a[c];
    if (a.size() == 6) A[j][i] = a[c];
  }
  if (frame == Frame::symmetric)
    for (const auto& [i, j] : place) A[i][j] = A[j][i] = (A[i][j] + A[j][i]) / 2;
  A = turn(R, A);
  for (std::size_t c = 0; c < a.size(); ++c)
    out[c] = a.size() == 6 ? A[place[c][0]][place[c][1]] : A[c / 3][c % 3];
  return out;
}

void expect_row(const std::vector<Real>& is, const std::vector<Real>& should_be, const std::string& name) {
  ASSERT_EQ(is.size(), should_be.size()) << name;
  for (std::size_t c = 0; c < is.size(); ++c)
    EXPECT_NEAR(is[c], should_be[c], 1e5 * Kokkos::Experimental::epsilon_v<Real>) << name << " " << c;
}

// About (1, 2, 2) / 3, by 0.7 (Rodrigues).
Transform oblique_map() {
  const Real x = Real(1) / 3, y = Real(2) / 3, z = y, c = std::cos(Real(0.7)), s = std::sin(Real(0.7));
  const Real m = 1 - c;
  return {{c + x * x * m, x * y * m - z * s, x * z * m + y * s, y * x * m + z * s, c + y * y * m,
           y * z * m - x * s, z * x * m - y * s, z * y * m + x * s, c + z * z * m},
          {2, -3, 5}};
}

TEST(Fields, NoTwoRowsShareANameAndEachFitsItsColumns) {
  std::set<std::string> names;
  const auto look = [&](const char* name, const auto& field, auto facts) {
    using Field = std::decay_t<decltype(field)>;
    EXPECT_TRUE(names.insert(name).second) << name;
    const bool directed = facts.frame != Frame::scalar;
    if constexpr (Field::rank < 3) { // others are several vectors, or numbers
      const int columns = columns_of<Field>();
      const std::map<Frame, std::set<int>> fits = {{Frame::point, {3}},
                                                   {Frame::vector, {3}},
                                                   {Frame::symmetric, {6, 9}},
                                                   {Frame::tensor, {9}},
                                                   {Frame::scalar_and_vector, {4}}};
      EXPECT_TRUE(!directed || fits.at(facts.frame).contains(columns)) << name;
      EXPECT_TRUE(directed || (columns != 6 && columns != 9)) << name;
    }
    EXPECT_TRUE(facts.shifting == Shifting::stays || facts.life == Life::history) << name;
  };
  const Particles particles;
  const HexMesh hexes;
  for_each_field(particles, look);
  names.clear();
  for_each_field(hexes, look);
}

TEST(Fields, SortingMovesHistoryAndWhatFrozenRowsKeep) {
  for (const bool freezes : {true, false}) {
    Particles p = filled_particles();
    if (!freezes) p.damping = ScalarField();
    set_rows(p.position, rows, [](const Vector3& x) { return Vector3{-x.x, x.y, x.z}; });
    const RowsOf before = read(p);
    sort_particles(p, {{0, 0, 0}, 1});
    const RowsOf after = read(p);
    const Real first = before.at("identity")[0][0];
    int moved = 0;
    for (std::size_t i = 0; i < rows; ++i) {
      const std::size_t from = std::size_t((after.at("identity")[i][0] - first) / 10);
      moved += from != i;
      for_each_field(p, [&](const char* name, const auto& field, auto facts) {
        if (field.extent(0) == 0) return;
        const bool goes = facts.life == Life::history || (facts.life == Life::pair && freezes);
        EXPECT_EQ(after.at(name)[i], before.at(name)[goes ? from : i]) << name;
      });
    }
    EXPECT_GT(moved, 3);
  }
}

TEST(Fields, WhatIsKeptTurnsWhereAParticleWraps) {
  const Particles p = filled_particles();
  const GhostPlane plane{{1, 0, 0}, 0, oblique_map(), true, true};
  set_rows(p.position, 1, [](const Vector3&) { return Vector3{-1, 2, 4}; }); // the first is outside
  const RowsOf before = read(p);
  const Status status("status");
  wrap_periodic(p, {plane}, status);
  const RowsOf after = read(p);
  for_each_field(p, [&](const char* name, const auto&, auto facts) {
    const Frame frame = facts.life == Life::derived ? Frame::scalar : facts.frame;
    expect_row(after.at(name)[0], turned(frame, before.at(name)[0], plane.to_ghost), name);
    for (std::size_t i = 1; i < rows; ++i) EXPECT_EQ(after.at(name)[i], before.at(name)[i]) << name;
  });
}

template <Ghosts when>
void expect_ghosts() {
  const Particles p = filled_particles();
  const GhostPlanes planes = {{{1, 0, 0}, 0, oblique_map(), true, true}};
  Neighbors n;
  n.ghost_first = rows, n.ghosts = ghosts, n.planes = 1, n.ghost_start[1] = ghosts;
  n.ghost_source = IndexField("source", ghosts);
  const auto source = host_copy(n.ghost_source);
  source(0) = 3, source(1) = 1;
  Kokkos::deep_copy(n.ghost_source, source);
  const RowsOf before = read(p);
  copy_to_ghosts<when>("test", p, n, planes);
  const RowsOf after = read(p);
  int carried = 0;
  for_each_field(p, [&](const char* name, const auto&, auto facts) {
    for (std::size_t i = 0; i < before.at(name).size(); ++i) {
      if (i < rows || !facts.on_ghosts_at(when)) {
        EXPECT_EQ(after.at(name)[i], before.at(name)[i]) << name;
        continue;
      }
      const auto& from = before.at(name)[std::size_t(source(int(i) - rows))];
      expect_row(after.at(name)[i], turned(facts.frame, from, planes[0].to_ghost), name);
      ++carried;
    }
  });
  EXPECT_GE(carried, ghosts);
}

TEST(Fields, GhostsCarryWhatTheirRowsSay) {
  expect_ghosts<Ghosts::when_made>(), expect_ghosts<Ghosts::after_drift>();
  expect_ghosts<Ghosts::before_forces>(), expect_ghosts<Ghosts::in_diffuse_pressure>();
  expect_ghosts<Ghosts::in_conduct_heat>(), expect_ghosts<Ghosts::in_find_shifts>();
}

// Fields that a run does without get no rows from ghosts.
TEST(Fields, GhostsMakeRoomInWhatTheyCarry) {
  ParticleBlock b = particle_block(4, 4, 4, Real(1e-3));
  Particles& p = b.particles;
  const GhostPlanes planes = {{{1, 0, 0}, 0, {identity3(), {Real(4e-3), 0, 0}}, true, true}};
  make_ghosts(p, b.neighbors, planes);
  ASSERT_GT(p.total, p.stored);
  for_each_field(p, [&](const char* name, const auto& field, auto facts) {
    const int had = int(field.extent(0));
    const bool is_used = facts.method != Method::with_conduction;
    EXPECT_TRUE(is_used || had == 0) << name;
    EXPECT_EQ(had >= p.total, had > 0 && facts.on_ghosts) << name;
  });
}

} // namespace
} // namespace swarf::test
