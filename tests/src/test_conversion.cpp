// Hexes that become particles: what is carried over, and that the scene after it is one that can move.
#include "scene_decks.hpp"
#include "src/scene/convert_hexes.hpp"
#include "src/scene/hex_conversion.hpp"
#include "swarf/kernels.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>

using namespace swarf;
using namespace swarf::test;

namespace {
const double round_off = sizeof(Real) == 8 ? 1e-13 : 1e-5;
constexpr double edge = 10 * um;

// 9 x 6 x 6 hexes of 10 um; periodic along z if asked for.
Deck hex_block(int particles, bool periodic) {
  Deck deck = empty_deck();
  deck.bodies = {block("work", "hexes", {0, 0, 0}, {9 * edge, 6 * edge, 6 * edge}, edge)};
  deck.bodies[0].convert_strain = 1, deck.bodies[0].convert_particles = particles;
  if (periodic)
    for (const char* face : {"z_min", "z_max"})
      deck.bodies[0].faces.push_back({face, FaceKind::periodic, {}});
  return deck;
}

template <class Field>
void set_random(const Field& field, double low, double high, int seed) {
  const auto f = host_copy(field);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(low, high);
  for (std::size_t i = 0; i < f.extent(0); ++i)
    if constexpr (Field::rank == 1)
      f(i) = Real(any(random));
    else
      for (std::size_t c = 0; c < f.extent(1); ++c) f(i, c) = Real(any(random));
  Kokkos::deep_copy(field, f);
}

// Every node, hex and particle with a state of its own, as if it had moved.
void set_any_state(const Scene& scene, int seed) {
  const HexMesh& m = scene.hexes;
  for (const MaterialPoints& points : {m.points, scene.particles.points}) {
    set_random(points.stress, -1e9, 1e9, seed + 1), set_random(points.temperature, 300, 900, seed + 2);
    set_random(points.equivalent_plastic_strain, 0.1, 0.9, seed + 3);
    set_random(points.internal_work, 1e-9, 2e-9, seed + 4),
        set_random(points.plastic_work, 1e-10, 2e-10, seed + 5);
    set_random(points.density, 4400, 4500, seed + 6), set_random(points.damage, 0.1, 0.5, seed + 7);
  }
  set_random(m.velocity, -10, 10, seed + 8), set_random(scene.particles.velocity, -10, 10, seed + 9);
  const auto x = host_copy(m.position), shift = host_copy(m.position), v = host_copy(m.velocity);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-0.1 * edge, 0.1 * edge);
  for (int a = 0; a < m.nodes; ++a)
    for (int d = 0; d < 2; ++d) x(a, d) += Real(any(random)); // not along z: faces stay where they are
  for (std::size_t r = 0; r < m.coupled_nodes.extent(0); ++r) {
    const auto pairs = host_copy(m.coupled_nodes);
    for (int d = 0; d < 2; ++d) x(pairs(r, 1), d) = x(pairs(r, 0), d);
    for (int d = 0; d < 3; ++d) v(pairs(r, 1), d) = v(pairs(r, 0), d);
  }
  Kokkos::deep_copy(m.position, x), Kokkos::deep_copy(m.velocity, v);
  if (m.nodal_temperature.extent(0) == 0) return;
  set_random(m.nodal_temperature, 300, 900, seed + 10);
  const auto T = host_copy(m.nodal_temperature);
  const auto pairs = host_copy(m.coupled_nodes);
  for (std::size_t r = 0; r < pairs.extent(0); ++r) T(pairs(r, 1)) = T(pairs(r, 0));
  Kokkos::deep_copy(m.nodal_temperature, T);
}

// Rows of the block's hexes whose centre lies in the box, in units of the edge.
std::vector<int> hexes_in(const Scene& scene, const Triple& low, const Triple& high) {
  std::vector<int> found;
  const auto active = host_copy(scene.hexes.active);
  for (int e = 0; e < scene.hexes.points.count; ++e) {
    Point centre(0, 0, 0);
    for (int a = 0; a < 8; ++a)
      centre +=
          scene.conversion->node[std::size_t(scene.conversion->hex[std::size_t(e)][std::size_t(a)])] / 8;
    bool inside = active(e) == hex_active;
    for (int d = 0; d < 3; ++d) inside = inside && centre[d] > low[d] * edge && centre[d] < high[d] * edge;
    if (inside) found.push_back(e);
  }
  return found;
}

struct Totals {
  double mass = 0, material_mass = 0, volume = 0, internal = 0, plastic = 0, strain = 0, damage = 0, heat = 0;
  double kinetic = 0;
  Vector3 momentum{0, 0, 0}, angular{0, 0, 0}, first_moment{0, 0, 0};
  Symmetric3 stress{0, 0, 0, 0, 0, 0}; // integral over the volume
};

void add_points(Totals& t, const MaterialPoints& p, double specific_heat) {
  const auto mass = host_copy(p.mass), rho = host_copy(p.density),
             eps = host_copy(p.equivalent_plastic_strain), T = host_copy(p.temperature),
             D = host_copy(p.damage), U = host_copy(p.internal_work), W = host_copy(p.plastic_work);
  const auto s = host_copy(p.stress);
  for (int i = 0; i < p.count; ++i) {
    const double m = double(mass(i)), V = m / double(rho(i));
    t.material_mass += m, t.volume += V, t.internal += double(U(i)), t.plastic += double(W(i));
    t.strain += m * double(eps(i)), t.damage += m * double(D(i)), t.heat += m * specific_heat * double(T(i));
    t.stress = t.stress + Real(V) * load_symmetric(s, i);
  }
}

void add_motion(Totals& t, const VectorField& position, const VectorField& velocity, const ScalarField& mass,
                int rows) {
  const auto x = host_copy(position), v = host_copy(velocity);
  const auto m = host_copy(mass);
  for (int i = 0; i < rows; ++i) {
    const Vector3 p = m(i) * load_vector(v, i);
    t.mass += double(m(i)), t.momentum = t.momentum + p;
    t.angular = t.angular + cross(load_vector(x, i), p);
    t.first_moment = t.first_moment + m(i) * load_vector(x, i);
    t.kinetic += 0.5 * double(dot(p, load_vector(v, i)));
  }
}

Totals totals_of(const Scene& scene) {
  const double c = titanium().specific_heat.value;
  Totals t;
  add_points(t, scene.particles.points, c), add_points(t, scene.hexes.points, c);
  add_motion(t, scene.particles.position, scene.particles.velocity, scene.particles.points.mass,
             scene.particles.count);
  add_motion(t, scene.hexes.position, scene.hexes.velocity, scene.hexes.mass, scene.hexes.nodes);
  return t;
}

// Where the nodes hold the heat: theirs, and what hexes and tied particles have got since (gather_heat.cpp).
double heat_of_conducting(const Scene& scene) {
  const double c = titanium().specific_heat.value;
  const HexMesh& m = scene.hexes;
  const Particles& p = scene.particles;
  const auto node_T = host_copy(m.nodal_temperature), node_mass = host_copy(m.mass);
  const auto T = host_copy(m.points.temperature), mass = host_copy(m.points.mass);
  const auto corner = host_copy(m.connectivity);
  double heat = 0;
  for (int a = 0; a < m.nodes; ++a) heat += double(node_mass(a) * node_T(a)) * c;
  for (int e = 0; e < m.points.count; ++e) {
    double mean = 0;
    for (int a = 0; a < 8; ++a) mean += double(node_T(corner(e, a))) / 8;
    heat += double(mass(e)) * c * (double(T(e)) - mean);
  }
  const auto T_i = host_copy(p.points.temperature), m_i = host_copy(p.points.mass);
  const auto host = host_copy(scene.tie.host);
  const auto shape = host_copy(scene.tie.shape);
  for (int i = 0; i < p.count; ++i) heat += double(m_i(i) * T_i(i)) * c;
  for (int k = 0; k < p.tied; ++k) {
    double at = 0;
    for (int a = 0; a < 8; ++a) at += double(shape(k, a) * node_T(corner(host(k), a)));
    heat += double(m_i(p.count + k)) * c * (double(T_i(p.count + k)) - at);
  }
  return heat;
}

void expect_kept(const Totals& before, const Totals& after, bool periodic) {
  EXPECT_NEAR(after.mass / before.mass, 1, round_off);
  EXPECT_NEAR(after.material_mass / before.material_mass, 1, round_off);
  EXPECT_NEAR(after.volume / before.volume, 1, round_off);
  EXPECT_NEAR(after.internal / before.internal, 1, round_off);
  EXPECT_NEAR(after.plastic / before.plastic, 1, round_off);
  EXPECT_NEAR(after.strain / before.strain, 1, round_off);
  EXPECT_NEAR(after.damage / before.damage, 1, round_off);
  const double momentum = before.mass * 10, length = 50 * um; // sizes of the terms
  EXPECT_LT(double(norm(after.momentum - before.momentum)) / momentum, round_off);
  Vector3 shift = after.first_moment - before.first_moment;
  if (periodic) shift.z = 0; // where a centre of mass lies is a matter of what counts as first
  EXPECT_LT(double(norm(shift)) / (before.mass * length), round_off);
  const Symmetric3 d = after.stress + Real(-1) * before.stress;
  EXPECT_LT(double(std::sqrt(contract(d, d))) / (1e9 * before.volume), round_off);
}

} // namespace

// In stages, so that tied particles become free and others come to be tied; each with any state everywhere.
TEST(Conversion, CarriesMassMomentumEnergyAndStateOver) {
  for (const int particles : {1, 2, 3})
    for (const bool periodic : {false, true}) {
      if (periodic && particles == 1) continue; // six hexes are as thick as a kernel reaches: seen elsewhere
      const Deck deck = hex_block(particles, periodic);
      Scene scene = build_scene(deck);
      const std::vector<std::pair<Triple, Triple>> stages = {
          {{0, 3, 0}, {3, 6, 2}}, {{2, 2, 1}, {5, 6, 4}}, {{0, 0, 0}, {9, 6, 6}}};
      for (std::size_t stage = 0; stage < stages.size(); ++stage) {
        set_any_state(scene, 100 * int(stage) + particles);
        project_tie(scene.tie, scene.particles, scene.hexes);
        const Totals before = totals_of(scene);
        convert_hexes(deck, scene, hexes_in(scene, stages[stage].first, stages[stage].second));
        const Totals after = totals_of(scene);
        expect_kept(before, after, periodic);
        EXPECT_NEAR(after.heat / before.heat, 1, round_off);
        std::printf(
            "%d^3 %s stage %zu: %d particles, %d tied; kinetic energy %.3f, angular momentum off by %.2g\n",
            particles, periodic ? "periodic" : "free", stage, scene.particles.count, scene.particles.tied,
            after.kinetic / before.kinetic,
            double(norm(after.angular - before.angular)) / (before.mass * 10 * 50 * um));
        EXPECT_LE(after.kinetic, before.kinetic * (1 + round_off));
        EXPECT_GT(scene.particles.count, 0);
      }
      EXPECT_EQ(scene.particles.count, 9 * 6 * 6 * particles * particles * particles);
      EXPECT_EQ(scene.particles.tied, 0);
    }
}

TEST(Conversion, CarriesTheHeatOfTheNodesOver) {
  Deck deck = hex_block(2, true);
  deck.materials[0].conductivity = 7;
  Scene scene = build_scene(deck);
  for (const auto& [low, high] : {std::pair<Triple, Triple>{{0, 3, 0}, {3, 6, 2}}, {{2, 2, 1}, {5, 6, 4}}}) {
    set_any_state(scene, 7);
    const double before = heat_of_conducting(scene);
    convert_hexes(deck, scene, hexes_in(scene, low, high));
    EXPECT_NEAR(heat_of_conducting(scene) / before, 1, round_off);
  }
}

// A rigid motion stays one: particles move as the hexes did.
TEST(Conversion, KeepsARigidMotion) {
  const Deck deck = hex_block(2, false);
  Scene scene = build_scene(deck);
  const auto x = host_copy(scene.hexes.position), v = host_copy(scene.hexes.velocity);
  const Vector3 spin{1e5, -2e5, 3e5};
  for (int a = 0; a < scene.hexes.nodes; ++a) store_vector(v, a, cross(spin, load_vector(x, a)));
  Kokkos::deep_copy(scene.hexes.velocity, v);
  const Totals before = totals_of(scene);
  convert_hexes(deck, scene, hexes_in(scene, {0, 0, 0}, {4, 6, 6}));
  const auto x_i = host_copy(scene.particles.position), v_i = host_copy(scene.particles.velocity);
  for (int i = 0; i < scene.particles.count; ++i)
    EXPECT_LT(double(norm(load_vector(v_i, i) - cross(spin, load_vector(x_i, i)))), 100 * round_off);
  const Totals after = totals_of(scene);
  std::printf("rigid rotation of 9 x 6 x 6 hexes, 4 x 6 x 6 of them converted: angular momentum %.4f, "
              "kinetic energy %.4f\n",
              double(norm(after.angular) / norm(before.angular)), after.kinetic / before.kinetic);
  // Lumped at its nodes a hex has the spin of M edge^2 / 4 about its centre, as particles a quarter of it; of
  // the body's own about the scene's origin, at a corner, that is little.
  EXPECT_NEAR(double(norm(after.angular) / norm(before.angular)), 1, 0.01);
}

namespace {

constexpr double spacing = 10 * um;

// Sorted by place: what a particle or tied particle weighs, and where it is.
using Place = std::array<long, 3>;
std::map<Place, double> masses_by_place(const Scene& scene, int first, int last) {
  const auto x = host_copy(scene.particles.position);
  const auto mass = host_copy(scene.particles.points.mass);
  std::map<Place, double> found;
  for (int i = first; i < last; ++i) {
    Place at;
    for (int d = 0; d < 3; ++d) at[std::size_t(d)] = std::lround(8 * double(x(i, d)) / spacing);
    found[at] = double(mass(i));
  }
  return found;
}

void expect_equal(const std::map<Place, double>& a, const std::map<Place, double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [place, mass] : a) {
    ASSERT_TRUE(b.contains(place)) << place[0] << " " << place[1] << " " << place[2];
    EXPECT_NEAR(b.at(place) / mass, 1, 10 * round_off);
  }
}

Deck with_sides(Deck deck) {
  for (BodyDeck& b : deck.bodies)
    for (const char* face : {"x_min", "x_max", "y_min", "y_max"})
      b.faces.push_back({face, FaceKind::periodic, {}});
  return deck;
}

} // namespace

// A layer of hexes that has become particles is the layer of particles of a deck that is built with one: the
// same places, masses, tied particles and nodes; hexes' shares as far as that deck's midpoints integrate
// them.
TEST(Conversion, MakesTheSceneThatADeckWithABandOfParticlesBuilds) {
  const double wide = 8 * spacing;
  Deck band = empty_deck(), whole = empty_deck();
  band.bodies = {block("zone", "particles", {0, 0, 0}, {wide, wide, 6 * spacing}, spacing),
                 block("bulk", "hexes", {0, 0, -8 * spacing}, {wide, wide, 8 * spacing}, 2 * spacing)};
  band.bodies[0].tie = "bulk";
  whole.bodies = {block("bulk", "hexes", {0, 0, -8 * spacing}, {wide, wide, 14 * spacing}, 2 * spacing)};
  whole.bodies[0].convert_strain = 1;
  band = with_sides(band), whole = with_sides(whole);
  const Scene built = build_scene(band);
  Scene converted = build_scene(whole);
  std::vector<int> upper;
  for (int e = 0; e < converted.hexes.points.count; ++e)
    if (converted.conversion->place(e, 0).z() > 0) upper.push_back(e);
  convert_hexes(whole, converted, upper);
  project_tie(built.tie, built.particles, built.hexes);
  project_tie(converted.tie, converted.particles, converted.hexes);

  const Particles &a = built.particles, &b = converted.particles;
  ASSERT_EQ(a.count, b.count);
  ASSERT_EQ(a.tied, b.tied);
  expect_equal(masses_by_place(built, 0, a.count), masses_by_place(converted, 0, b.count));
  expect_equal(masses_by_place(built, a.count, a.count + a.tied),
               masses_by_place(converted, b.count, b.count + b.tied));
  const auto inverse_support = host_copy(b.inverse_support), gap = host_copy(b.contact_gap),
             area = host_copy(b.contact_area);
  EXPECT_NEAR(inverse_support(0) / host_copy(a.inverse_support)(0), 1, 10 * round_off);
  EXPECT_NEAR(gap(0) / host_copy(a.contact_gap)(0), 1, 10 * round_off);
  EXPECT_NEAR(area(0) / host_copy(a.contact_area)(0), 1, 10 * round_off);
  EXPECT_EQ(area(b.count), 0);
  // Hexes and nodes below z = 0, by place.
  const auto of_hexes = [](const Scene& scene, const ScalarField& field) {
    std::map<Place, double> found;
    const auto x = host_copy(scene.hexes.position);
    const auto corner = host_copy(scene.hexes.connectivity);
    const auto value = host_copy(field), share = host_copy(scene.hexes.share);
    for (int e = 0; e < scene.hexes.points.count; ++e) {
      Place at;
      for (int d = 0; d < 3; ++d) at[std::size_t(d)] = std::lround(8 * double(x(corner(e, 0), d)) / spacing);
      if (share(e) > 0) found[at] = double(value(e));
    }
    return found;
  };
  const auto share = of_hexes(built, built.hexes.share);
  const auto converted_share = of_hexes(converted, converted.hexes.share);
  ASSERT_EQ(share.size(), converted_share.size());
  for (const auto& [place, value] : share) EXPECT_NEAR(converted_share.at(place), value, 2e-3);
  const auto of_nodes = [](const Scene& scene, const ScalarField& field) {
    std::map<Place, double> found;
    const auto x = host_copy(scene.hexes.position);
    const auto value = host_copy(field), mass = host_copy(scene.hexes.mass);
    for (int n = 0; n < scene.hexes.nodes; ++n) {
      Place at;
      for (int d = 0; d < 3; ++d) at[std::size_t(d)] = std::lround(8 * double(x(n, d)) / spacing);
      if (mass(n) > 0) found[at] = double(value(n));
    }
    return found;
  };
  expect_equal(of_nodes(built, built.hexes.mass), of_nodes(converted, converted.hexes.mass));
  const auto area_of = of_nodes(built, built.hexes.contact_area);
  for (const auto& [place, value] : of_nodes(converted, converted.hexes.contact_area))
    EXPECT_NEAR(value, area_of.at(place), round_off * 100 * um * um);
}
