// Transport of fields to where particles are shifted. Theory: f(x + d) of linear fields is exact, of smooth
// ones second order; nothing goes beyond what neighbours have; sums over all are kept, and the energy is
// booked.
#include "support/materials.hpp"
#include "support/points.hpp"
#include "support/shifting_block.hpp"
#include "support/status.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>

namespace swarf::test {
namespace {

constexpr double epsilon = double(Kokkos::Experimental::epsilon_v<Real>);
constexpr double pi = 3.14159265358979323846;

struct Random {
  std::mt19937_64 engine{11};
  Real operator()(Real low, Real high) { return std::uniform_real_distribution<Real>(low, high)(engine); }
  Vector3 vector(Real size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
};

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
template <class Field, class Function> // value(position, column)
void set_field(const Particles& p, const Field& field, Function&& value) {
  const auto x = host_copy(p.position);
  const auto f = host_copy(field);
  for (int i = 0; i < p.stored; ++i)
    for (int c = 0; c < columns_of<Field>(); ++c) entry(f, i, c) = value(load_vector(x, i), c);
  Kokkos::deep_copy(field, f);
}

using Rows = std::vector<std::vector<double>>; // of each particle, by column
template <class Field>
Rows read(const Particles& p, const Field& field) {
  Rows rows;
  const auto f = host_copy(field);
  for (int i = 0; i < p.stored; ++i) {
    rows.emplace_back();
    for (int c = 0; c < columns_of<Field>(); ++c) rows.back().push_back(double(entry(f, i, c)));
  }
  return rows;
}

// A disordered block with its lists.
ParticleBlock disordered_block(int n, Real disorder = Real(0.2), Real spacing = unit) {
  ParticleBlock b = flowing_block(n, n, n, disorder, Real(0.5), spacing);
  build_lists(b);
  return b;
}

// Displacements up to a twentieth of a spacing, of those at least `layers` below the surface of a block of
// n^3; of `balanced` ones the sum is zero.
std::vector<Vector3> displacements(const ParticleBlock& b, int n, Real layers, bool balanced) {
  Random random;
  const auto x = host_copy(b.particles.position);
  std::vector<Vector3> d(std::size_t(b.particles.count), Vector3{0, 0, 0});
  int last = -1;
  for (int i = 0; i < b.particles.count; ++i) {
    const Real low = layers * unit, high = (Real(n) - layers) * unit;
    if (std::min({x(i, 0), x(i, 1), x(i, 2)}) < low || std::max({x(i, 0), x(i, 1), x(i, 2)}) > high) continue;
    if (balanced && last >= 0)
      d[std::size_t(i)] = Real(-1) * d[std::size_t(last)], last = -1;
    else
      d[std::size_t(i)] = random.vector(Real(0.028) * unit) + Vector3{balanced ? 0 : Real(0.01) * unit, 0, 0},
      last = i;
  }
  if (balanced && last >= 0) d[std::size_t(last)] = {0, 0, 0};
  return d;
}

Shifts transport(const ParticleBlock& b, const std::vector<Vector3>& d, Real mass_factor = 1) {
  const Shifts shifts = make_shifts(b, [&](int i) { return d[std::size_t(i)]; });
  transport_fields(b.particles, b.neighbors, {}, b.materials, shifts, mass_factor);
  return shifts;
}

// Visits the fields that the table marks.
template <class Visit>
void for_each_moved(const Particles& p, Visit&& visit) {
  for_each_field(p, [&](const char* name, const auto& field, auto facts) {
    if constexpr (facts.shifting != Shifting::stays) visit(std::string(name), field);
  });
}

Real linear(const Vector3& x, int column) {
  const Vector3 k{Real(300 - 70 * column), Real(100 + 50 * column), Real(-200 + 90 * column)}; // 1/m
  return 20 + Real(column) + dot(k, x);
}

double sum_of(const Rows& weight, const Rows& value, std::size_t column) {
  double sum = 0;
  for (std::size_t i = 0; i < value.size(); ++i) sum += weight[i][0] * value[i][column];
  return sum;
}

// All fields that move, with numbers without order: velocity, stress, hourglass +-1, the others 0 .. 1.
void set_random(const Particles& p) {
  Random random;
  for_each_moved(p, [&](const std::string&, const auto& field) {
    const bool directed = columns_of<std::decay_t<decltype(field)>>() > 1;
    set_field(p, field, [&](const Vector3&, int) { return random(directed ? Real(-1) : Real(0), 1); });
  });
  set_field(p, p.points.density, [&](const Vector3&, int) { return random(7000, 8000); });
  set_field(p, p.points.stress, [&](const Vector3&, int) { return random(Real(-1e9), Real(1e9)); });
}

} // namespace

// Every field of the table, every column. The sum of d is zero, so that no sum has to be kept.
TEST(TransportFields, IsExactForLinearFields) {
  constexpr int n = 10;
  const ParticleBlock b = disordered_block(n);
  for_each_moved(b.particles,
                 [&](const std::string&, const auto& field) { set_field(b.particles, field, linear); });
  const auto x = read(b.particles, b.particles.position);
  const std::vector<Vector3> d = displacements(b, n, 2, true);
  transport(b, d);
  int moved = 0;
  for (const Vector3& each : d) moved += norm(each) > 0;
  EXPECT_GT(moved, 200);
  const auto after = read(b.particles, b.particles.position);
  for (std::size_t i = 0; i < d.size(); ++i) {
    const Vector3 to{Real(x[i][0] + d[i].x), Real(x[i][1] + d[i].y), Real(x[i][2] + d[i].z)};
    EXPECT_EQ(after[i], (std::vector<double>{double(to.x), double(to.y), double(to.z)})) << i;
  }
  for_each_moved(b.particles, [&](const std::string& name, const auto& field) {
    const Rows f = read(b.particles, field);
    for (std::size_t i = 0; i < f.size(); ++i)
      for (std::size_t c = 0; c < f[i].size(); ++c) {
        const Vector3 at{Real(after[i][0]), Real(after[i][1]), Real(after[i][2])};
        ASSERT_NEAR(f[i][c], linear(at, int(c)), 1e5 * epsilon) << name << " " << c << " " << i;
      }
  });
}

// A sine along x in a disordered bar that is periodic in all directions; half the spacing, shifts with it: a
// quarter of the error. Fields whose sum is not kept.
TEST(TransportFields, IsSecondOrderForSmoothFields) {
  if (sizeof(Real) == 4) GTEST_SKIP() << "the error is one of round-off";
  constexpr int across = 6;
  double error[2];
  for (int half = 0; half < 2; ++half) {
    const int n = half ? 320 : 160;
    const double length = 160 * double(unit);
    const Real spacing = Real(length / n);
    const auto sine = [&](double x) { return 3 + std::sin(2 * pi * x / length); };
    GhostPlanes planes = periodic_along(0, Real(length));
    for (int axis : {1, 2})
      for (const GhostPlane& plane : periodic_along(axis, across * spacing)) planes.push_back(plane);
    ParticleBlock b = flowing_block(n, across, across, Real(0.2), 1, spacing);
    const Particles& p = b.particles;
    const Status status = make_status();
    wrap_periodic(p, planes, status);
    build_lists(b, planes);
    ASSERT_EQ(read_status(status), no_fault);
    set_field(p, p.points.stress, [&](const Vector3& x, int) { return Real(sine(double(x.x))); });
    const Rows before = read(p, p.position);
    Random random;
    const Shifts shifts = make_shifts(b, [&](int) { return random.vector(Real(0.05) * spacing); });
    transport_fields(p, b.neighbors, planes, b.materials, shifts, 1);
    const Rows x = read(p, p.position), f = read(p, p.points.stress);
    double sum2 = 0, left2 = 0;
    for (std::size_t i = 0; i < f.size(); ++i) {
      sum2 += std::pow(f[i][3] - sine(x[i][0]), 2);
      left2 += std::pow(sine(before[i][0]) - sine(x[i][0]), 2);
    }
    error[half] = std::sqrt(sum2 / double(f.size()));
    EXPECT_LT(std::sqrt(sum2 / left2), half ? 0.00125 : 0.0025); // of what is wrong when the values stay
  }
  EXPECT_NEAR(error[0] / error[1], 4, 0.4);
}

// Steps from 0 to 1, also at the surface, with shifts of up to half a spacing: each stays in 0 .. 1 of the
// scalars, which keep their sums, and of those without a sum.
TEST(TransportFields, MakesNoNewExtremes) {
  constexpr int n = 9;
  const ParticleBlock b = disordered_block(n);
  const Particles& p = b.particles;
  const MaterialPoints& points = p.points;
  const auto step = [&](const Vector3& x, int c) {
    return Real(x.x + Real(0.3) * x.y + Real(c) * x.z > (Real(6) + 4 * Real(c)) * unit ? 1 : 0);
  };
  set_field(p, points.equivalent_plastic_strain, step), set_field(p, points.temperature, step);
  set_field(p, points.damage, step), set_field(p, points.stress, step);
  set_field(p, points.density, [&](const Vector3& x, int c) { return 1 + step(x, c); });
  const Rows before = read(p, points.equivalent_plastic_strain);
  std::vector<Vector3> d = displacements(b, n, -1, false);
  for (Vector3& each : d) each = Real(10) * each;
  transport(b, d);
  const auto expect_within = [](const Rows& rows, double low, double high) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (const double value : rows[i]) {
        EXPECT_GE(value, low) << i;
        EXPECT_LE(value, high) << i;
      }
  };
  expect_within(read(p, points.equivalent_plastic_strain), 0, 1);
  expect_within(read(p, points.temperature), 0, 1), expect_within(read(p, points.damage), 0, 1);
  expect_within(read(p, points.stress), 0, 1), expect_within(read(p, points.density), 1, 2);
  int changed = 0;
  const Rows after = read(p, points.equivalent_plastic_strain);
  for (std::size_t i = 0; i < after.size(); ++i) changed += std::abs(after[i][0] - before[i][0]) > 0.01;
  EXPECT_GT(changed, 50);
}

// Fields without order, two materials of different heat, masses that differ, and a sum of m d that is not
// zero.
TEST(TransportFields, KeepsMomentumHeatAndPlasticStrain) {
  constexpr int n = 9;
  ParticleBlock b = disordered_block(n);
  const Particles& p = b.particles;
  Material other = elastic_steel();
  other.specific_heat = 900;
  b.materials = make_material_table({elastic_steel(), other});
  set_field(p, p.points.material, [](const Vector3& x, int) { return int(x.z > Real(4.5) * unit); });
  Random random;
  set_field(p, p.points.mass, [&](const Vector3&, int) { return random(Real(6e-6), Real(9e-6)); });
  set_random(p);
  const Rows mass = read(p, p.points.mass), material = read(p, p.points.material);
  Rows heat = mass;
  for (std::size_t i = 0; i < heat.size(); ++i) heat[i][0] *= material[i][0] > 0 ? 900 : 500;
  const std::map<std::string, const Rows*> weights = {
      {"velocity", &mass}, {"equivalent_plastic_strain", &mass}, {"temperature", &heat}};
  const auto read_all = [&] {
    std::map<std::string, Rows> all;
    for_each_moved(p, [&](const std::string& name, const auto& field) { all[name] = read(p, field); });
    return all;
  };
  auto before = read_all();
  transport(b, displacements(b, n, -1, false));
  auto after = read_all();
  for (const auto& [name, weight] : weights)
    for (std::size_t c = 0; c < before[name][0].size(); ++c) {
      double changes = 0;
      for (std::size_t i = 0; i < mass.size(); ++i)
        changes += (*weight)[i][0] * std::abs(after[name][i][c] - before[name][i][c]);
      const double gained = sum_of(*weight, after[name], c) - sum_of(*weight, before[name], c);
      double all = 0;
      for (std::size_t i = 0; i < mass.size(); ++i) all += (*weight)[i][0];
      EXPECT_GT(changes, 1e-3 * all) << name;
      EXPECT_NEAR(gained / all, 0, 100 * epsilon) << name << " " << c;
    }
  EXPECT_EQ(read(p, p.points.mass), mass);
}

// Of each particle, and in the sums that the energy balance takes. The elastic energy by Hooke's law in E and
// nu.
TEST(TransportFields, BooksTheEnergyThatGoes) {
  constexpr int n = 9;
  const ParticleBlock b = disordered_block(n);
  const Particles& p = b.particles;
  set_random(p);
  set_field(p, p.velocity, [random = Random()](const Vector3&, int) mutable { return random(-20, 20); });
  const double K = 1e11, G = 8e10, E = 9 * K * G / (3 * K + G), nu = E / (2 * G) - 1;
  const Real mass_factor = 4;
  const auto energies = [&] { // kinetic, elastic, shifting_work, internal_work of each
    const Rows v = read(p, p.velocity), s = read(p, p.points.stress), rho = read(p, p.points.density),
               m = read(p, p.points.mass), booked = read(p, p.shifting_work),
               internal = read(p, p.points.internal_work);
    Rows out;
    for (std::size_t i = 0; i < v.size(); ++i) {
      const auto& t = s[i];
      const double normal = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
      const double mixed = t[0] * t[1] + t[1] * t[2] + t[2] * t[0];
      const double shear = t[3] * t[3] + t[4] * t[4] + t[5] * t[5];
      const double density = (normal - 2 * nu * mixed) / (2 * E) + (1 + nu) / E * shear;
      const double v2 = v[i][0] * v[i][0] + v[i][1] * v[i][1] + v[i][2] * v[i][2];
      out.push_back({double(mass_factor) * m[i][0] * v2 / 2, density * m[i][0] / rho[i][0], booked[i][0],
                     internal[i][0]});
    }
    return out;
  };
  const Rows before = energies();
  const PointSums sums = sum_particles(p, mass_factor);
  transport(b, displacements(b, n, -1, false), mass_factor);
  const Rows after = energies();
  const PointSums then = sum_particles(p, mass_factor);
  double kinetic = 0, elastic = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const double scale = before[i][0] + before[i][1];
    EXPECT_NEAR((after[i][0] + after[i][1] + after[i][2] - scale) / scale, 0, 100 * epsilon) << i;
    EXPECT_NEAR((after[i][3] - (after[i][1] - before[i][1])) / scale, 0, 100 * epsilon) << i;
    kinetic += std::abs(after[i][0] - before[i][0]) / scale;
    elastic += std::abs(after[i][1] - before[i][1]) / scale;
  }
  EXPECT_GT(kinetic / double(after.size()), 1e-3);
  EXPECT_GT(elastic / double(after.size()), 1e-3);
  EXPECT_GT(then.shifting, 1e-3 * sums.kinetic); // mixing loses energy
  EXPECT_NEAR((then.kinetic + then.internal + then.shifting) / (sums.kinetic + sums.internal), 1,
              1000 * epsilon);
}

// A jump of all fields from one material to another is not seen; a linear field of one is not bent by it.
TEST(TransportFields, OtherMaterialsDoNotCount) {
  constexpr int n = 9;
  ParticleBlock b = disordered_block(n);
  const Particles& p = b.particles;
  b.materials = make_material_table({elastic_steel(), elastic_steel()});
  const auto second = [](const Vector3& x) { return x.z > Real(4.5) * unit; };
  set_field(p, p.points.material, [&](const Vector3& x, int) { return int(second(x)); });
  for_each_moved(p, [&](const std::string&, const auto& field) {
    set_field(p, field, [&](const Vector3& x, int c) { return Real(second(x) ? 900 + c : 300 - c); });
  });
  const auto read_all = [&] {
    std::map<std::string, Rows> all;
    for_each_moved(p, [&](const std::string& name, const auto& field) { all[name] = read(p, field); });
    return all;
  };
  const auto before = read_all();
  const std::vector<Vector3> d = displacements(b, n, -1, false);
  transport(b, d);
  EXPECT_EQ(read_all(), before);
  set_field(p, p.points.material, [](const Vector3&, int) { return 0; });
  transport(b, d);
  EXPECT_NE(read_all(), before);
}

// All is turned: places, shifts, velocities, stresses. Smooth fields, whose changes are not cut off: cuts are
// by column. The sum of m d is not zero, so that momentum has to be kept.
TEST(TransportFields, TurnsWithTheBlock) {
  constexpr int n = 10;
  const Tensor3 R = oblique_rotation();
  std::vector<Vector3> velocity[2], hourglass[2];
  std::vector<Symmetric3> stress[2];
  std::vector<double> temperature[2];
  std::vector<Vector3> d; // by identity
  for (int turned = 0; turned < 2; ++turned) {
    ParticleBlock b = flowing_block(n, n, n, Real(0.2), Real(0.5));
    const Particles& p = b.particles;
    if (d.empty()) d = displacements(b, n, 2, false);
    set_field(p, p.velocity, linear), set_field(p, p.hourglass_displacement, linear);
    set_field(p, p.points.stress, linear);
    set_field(p, p.points.temperature, linear);
    if (turned) {
      for (const VectorField& field : {p.position, p.velocity, p.hourglass_displacement})
        set_rows(field, p.count, [&](const Vector3& v) { return multiply(R, v); });
      const auto s = host_copy(p.points.stress);
      for (int i = 0; i < p.count; ++i) store_symmetric(s, i, rotate(R, load_symmetric(s, i)));
      Kokkos::deep_copy(p.points.stress, s);
    }
    build_lists(b);
    const auto identity = host_copy(p.identity);
    const Shifts shifts = make_shifts(b, [&](int i) {
      const Vector3 by = d[std::size_t(identity(i))];
      return turned ? multiply(R, by) : by;
    });
    transport_fields(p, b.neighbors, {}, b.materials, shifts, 1);
    velocity[turned] = by_identity(b, p.velocity);
    hourglass[turned] = by_identity(b, p.hourglass_displacement);
    stress[turned].resize(d.size()), temperature[turned].resize(d.size());
    const auto s = host_copy(p.points.stress);
    const auto T = host_copy(p.points.temperature);
    for (int i = 0; i < p.count; ++i) {
      stress[turned][std::size_t(identity(i))] = load_symmetric(s, i);
      temperature[turned][std::size_t(identity(i))] = double(T(i));
    }
  }
  for (std::size_t i = 0; i < d.size(); ++i) {
    const double tolerance = 1e5 * epsilon;
    ASSERT_LT(norm(multiply(R, velocity[0][i]) - velocity[1][i]), tolerance) << i;
    ASSERT_LT(norm(multiply(R, hourglass[0][i]) - hourglass[1][i]), tolerance) << i;
    const Symmetric3 difference = rotate(R, stress[0][i]) + Real(-1) * stress[1][i];
    ASSERT_LT(std::sqrt(double(contract(difference, difference))), tolerance) << i;
    ASSERT_NEAR(temperature[0][i], temperature[1][i], tolerance) << i;
  }
}

// Stresses on the yield surface, of many directions, strains and temperatures: what is mixed may be beyond
// it, and the next update brings it back. Johnson-Cook without the rate: (A + B eps^n) (1 - T*^m).
TEST(TransportFields, LeavesAStateThatTheMaterialBringsBack) {
  constexpr int n = 9;
  ParticleBlock b = disordered_block(n);
  const Particles& p = b.particles;
  Material mat = ti64();
  mat.johnson_cook.C = 0, mat.taylor_quinney = 0;
  b.materials = make_material_table({mat});
  const auto flow = [&](double strain, double T) {
    const double hot = std::max(0.0, (T - 298.15) / (1878 - 298.15));
    return (862e6 + 331e6 * std::pow(strain, 0.34)) * (1 - std::pow(hot, 0.8));
  };
  Random random;
  const auto strain = host_copy(p.points.equivalent_plastic_strain), T = host_copy(p.points.temperature);
  const auto stress = host_copy(p.points.stress);
  for (int i = 0; i < p.count; ++i) {
    strain(i) = i % 3 ? random(0, 2) : Real(0), T(i) = random(300, 1500);
    const Vector3 normal = random.vector(1), shear = random.vector(1);
    const Symmetric3 s{normal.x, normal.y, normal.z, shear.x, shear.y, shear.z};
    store_symmetric(stress, i, Real(flow(strain(i), T(i)) / von_mises(s)) * s);
  }
  Kokkos::deep_copy(p.points.equivalent_plastic_strain, strain), Kokkos::deep_copy(p.points.temperature, T);
  Kokkos::deep_copy(p.points.stress, stress), Kokkos::deep_copy(p.points.density, mat.density);
  transport(b, displacements(b, n, -1, false));
  const auto over = [&](int i) { // von Mises stress over flow stress
    return double(von_mises(load_symmetric(host_copy(p.points.stress), i))) /
           flow(double(host_copy(p.points.equivalent_plastic_strain)(i)),
                double(host_copy(p.points.temperature)(i)));
  };
  int beyond = 0;
  for (int i = 0; i < p.count; ++i) beyond += over(i) > 1.001;
  EXPECT_GT(beyond, 10);
  Kokkos::deep_copy(p.points.velocity_gradient, Real(0));
  const Status status = make_status();
  update_stress(p.points, b.materials, Real(1e-9), status);
  EXPECT_EQ(read_status(status), no_fault);
  for (int i = 0; i < p.count; ++i) EXPECT_LE(over(i), 1 + (sizeof(Real) == 8 ? 1e-9 : 1e-4)) << i;
}

// The fields that move are these, and no other is touched but what the shift itself sets.
TEST(TransportFields, MovesWhatTheTableMarksAndNothingElse) {
  constexpr int n = 7;
  const ParticleBlock b = disordered_block(n);
  const Particles& p = b.particles;
  Random random;
  for_each_field(p, [&](const char* name, const auto& field, auto) {
    using Field = std::decay_t<decltype(field)>;
    if constexpr (Field::rank < 3)
      if (field.extent(0) > 0 && name != std::string("position") && name != std::string("material"))
        set_field(p, field, [&](const Vector3&, int) {
          return
              typename Field::value_type(std::is_integral_v<typename Field::value_type> ? 1 : random(1, 2));
        });
  });
  set_field(p, p.points.stress, [&](const Vector3&, int) { return random(Real(1e6), Real(2e6)); });
  Kokkos::deep_copy(p.inverse_support, Real(0.5) / (Real(1.2) * unit));
  Kokkos::deep_copy(p.volume, unit * unit * unit);
  const std::vector<Vector3> d = displacements(b, n, -1, false);
  const Shifts shifts = make_shifts(b, [&](int i) { return d[std::size_t(i)]; });
  const auto read_all = [&] {
    std::map<std::string, Rows> all;
    for_each_field(p, [&](const char* name, const auto& field, auto) {
      if (field.extent(0) > 0) all[name] = read(p, field);
    });
    return all;
  };
  const auto before = read_all();
  transport_fields(p, b.neighbors, {}, b.materials, shifts, 1);
  const auto after = read_all();
  const std::set<std::string> moved = {"position",
                                       "velocity",
                                       "density",
                                       "stress",
                                       "equivalent_plastic_strain",
                                       "temperature",
                                       "damage",
                                       "internal_work",
                                       "hourglass_displacement",
                                       "surface_normal",
                                       "shifted_strain",
                                       "shifting_work"};
  std::set<std::string> changed;
  for (const auto& [name, rows] : before)
    if (rows != after.at(name)) changed.insert(name);
  EXPECT_EQ(changed, moved);
  std::set<std::string> marked = {"position", "internal_work", "surface_normal", "shifted_strain",
                                  "shifting_work"};
  for_each_moved(p, [&](const std::string& name, const auto&) { marked.insert(name); });
  EXPECT_EQ(marked, moved);
  // What a shift takes of the budget: its length in spacings over those per strain, apart from the strain
  // that is moved.
  const auto& strain = after.at("equivalent_plastic_strain");
  for (std::size_t i = 0; i < d.size(); ++i) {
    const double left_before =
        before.at("equivalent_plastic_strain")[i][0] - before.at("shifted_strain")[i][0];
    const double left = strain[i][0] - after.at("shifted_strain")[i][0];
    EXPECT_NEAR(left_before - left, norm(d[i]) / unit / 2, 100 * epsilon) << i;
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(after.at("surface_normal")[i][c], 0);
  }
}

// Without what a run does not have, the others move as before.
TEST(TransportFields, DoesWithoutFieldsThatARunLeavesOut) {
  constexpr int n = 7;
  Rows stress[2];
  for (int without = 0; without < 2; ++without) {
    ParticleBlock b = disordered_block(n);
    set_random(b.particles);
    if (without) b.particles.hourglass_displacement = VectorField();
    transport(b, displacements(b, n, -1, false));
    stress[without] = read(b.particles, b.particles.points.stress);
  }
  EXPECT_EQ(stress[0], stress[1]);
}

// Values of ghosts come in their own frame: a periodic quarter of a ring and the whole ring, whose fields
// turn with it. Velocities along the axis: the momentum across it of a quarter is no sum that anything keeps.
TEST(TransportFields, ASectorIsAQuarterOfARing) {
  const Tensor3 left{0, -1, 0, 1, 0, 0, 0, 0, 1}, right{0, 1, 0, -1, 0, 0, 0, 0, 1}; // by 90 degrees
  const GhostPlanes quarter = {{{1, 0, 0}, 0, {right, {0, 0, 0}}, true, true},
                               {{0, 1, 0}, 0, {left, {0, 0, 0}}, true, true}};
  constexpr int layers = 5, inner = 6, outer = 10;
  std::vector<Vector3> x, d;
  Random random;
  for (int layer = 0; layer < layers; ++layer)
    for (int r = inner; r < outer; ++r)
      for (int k = 0, count = int(std::lround(1.57 * r)); k < count; ++k) {
        const double radius = r + random(Real(-0.2), Real(0.2));
        const double angle = pi / 2 * (k + 0.5 + random(Real(-0.2), Real(0.2))) / count;
        x.push_back({Real(radius * std::cos(angle)) * unit, Real(radius * std::sin(angle)) * unit,
                     (Real(layer) + random(Real(-0.2), Real(0.2))) * unit});
        d.push_back(random.vector(Real(0.028) * unit));
      }
  const std::size_t each = x.size();
  std::vector<Symmetric3> stress[2];
  std::vector<Vector3> velocity[2], hourglass[2];
  for (const int copies : {1, 4}) {
    const std::size_t which = copies == 4;
    ParticleBlock b = flowing_block(int(each) * copies, 1, 1, 0, Real(0.5));
    const Particles& p = b.particles;
    const auto position = host_copy(p.position), v = host_copy(p.velocity),
               u = host_copy(p.hourglass_displacement);
    const auto s = host_copy(p.points.stress);
    std::vector<Vector3> turned_d;
    for (int copy = 0, i = 0; copy < copies; ++copy) {
      Random same;
      for (std::size_t k = 0; k < each; ++k, ++i) {
        Vector3 at = x[k], by = d[k], along = same.vector(1);
        Symmetric3 tension{same(-1, 1), same(-1, 1), same(-1, 1), same(-1, 1), same(-1, 1), same(-1, 1)};
        for (int turn = 0; turn < copy; ++turn) {
          at = multiply(left, at), by = multiply(left, by), along = multiply(left, along);
          tension = rotate(left, tension);
        }
        store_vector(position, i, at), store_vector(u, i, along);
        store_vector(v, i, {0, 0, along.z}), store_symmetric(s, i, tension);
        turned_d.push_back(by);
      }
    }
    Kokkos::deep_copy(p.position, position), Kokkos::deep_copy(p.velocity, v);
    Kokkos::deep_copy(p.hourglass_displacement, u), Kokkos::deep_copy(p.points.stress, s);
    const GhostPlanes planes = copies == 1 ? quarter : GhostPlanes{};
    build_lists(b, planes);
    const auto identity = host_copy(p.identity);
    const Shifts shifts = make_shifts(b, [&](int i) { return turned_d[std::size_t(identity(i))]; });
    transport_fields(p, b.neighbors, planes, b.materials, shifts, 1);
    velocity[which] = by_identity(b, p.velocity), hourglass[which] = by_identity(b, p.hourglass_displacement);
    stress[which].resize(each * std::size_t(copies));
    const auto after = host_copy(p.points.stress);
    for (int i = 0; i < p.count; ++i) stress[which][std::size_t(identity(i))] = load_symmetric(after, i);
  }
  for (std::size_t i = 0; i < each; ++i) {
    EXPECT_LT(norm(velocity[0][i] - velocity[1][i]), 1e4 * epsilon) << i;
    EXPECT_LT(norm(hourglass[0][i] - hourglass[1][i]), 1e4 * epsilon) << i;
    const Symmetric3 difference = stress[0][i] + Real(-1) * stress[1][i];
    EXPECT_LT(std::sqrt(double(contract(difference, difference))), 1e4 * epsilon) << i;
  }
}

} // namespace swarf::test
