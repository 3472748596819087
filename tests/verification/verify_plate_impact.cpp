// Plate impact of Ti-6Al-4V, uniaxial strain: elastic shock, elastic precursor and plastic shock of an
// ideally plastic solid. Half of a symmetric impact: the plate's face is driven at half the impact velocity.
#include "tests/verification/case.hpp"
#include "tests/verification/drive.hpp"
#include <algorithm>

using namespace swarf;
using namespace swarf::test;

namespace {

constexpr double density = 4430, E = 110e9, nu = 0.33, yield = 862e6; // Ti-6Al-4V of Demiral & Mamedov (2022)
constexpr double K = E / (3 * (1 - 2 * nu)), G = E / (2 * (1 + nu));
const double elastic_speed = std::sqrt((K + 4 * G / 3) / density), plastic_speed = std::sqrt(K / density);
constexpr double elastic_limit = yield * (1 - nu) / (1 - 2 * nu); // of the axial stress in uniaxial strain
constexpr double length = 1e-3;
const std::string theory =
    "Rankine & Hugoniot, ideal plasticity in uniaxial strain: c_e^2 = (K + 4 G/3)/rho, "
    "c_p^2 = K/rho, sigma_HEL = Y (1 - nu)/(1 - 2 nu)";

// A slice of a plate: no lateral strain. Free at z = length, driven at z = 0.
Deck plate(const Deck& method, const std::string& fill, int cells, double face_speed) {
  Deck deck = method;
  deck.materials = {elastic_material(density, E, nu)};
  MaterialDeck& m = deck.materials[0];
  m.law = Law::linear_hardening, m.yield_stress = yield, m.hardening_modulus = 0, m.taylor_quinney = 0;
  const bool particles = fill == "particles";
  const double spacing = length / cells, side = particles ? 3 * spacing : spacing;
  deck.bodies = {block("plate", fill, {0, 0, 0}, {side, side, length}, spacing)};
  hold(deck.bodies[0], particles ? "periodic" : "symmetric", {"x_min", "x_max", "y_min", "y_max"});
  deck.bodies[0].faces.push_back({"z_min", FaceKind::velocity, {0, 0, face_speed}});
  return deck;
}

struct Profile {
  std::vector<double> z, stress; // place in the undeformed plate, m; axial compression, Pa
};

// Layers do not pass each other, so their order gives the place.
Profile profile_of(const Scene& scene) {
  const bool particles = scene.particles.count > 0;
  const MaterialPoints& points = particles ? scene.particles.points : scene.hexes.points;
  const int n = particles ? scene.particles.count : points.count;
  const auto stress = host_copy(points.stress);
  const auto x = host_copy(particles ? scene.particles.position : scene.hexes.position);
  const auto corners = host_copy(scene.hexes.connectivity);
  std::vector<std::pair<double, double>> all;
  for (int i = 0; i < n; ++i)
    all.emplace_back(double(particles ? x(i, 2) : x(corners(i, 0), 2)),
                     -double(load_symmetric(stress, i).zz));
  std::sort(all.begin(), all.end());
  const int layer = particles ? 9 : 1; // particles that lie side by side
  Profile p;
  for (int k = 0; k < n / layer; ++k) {
    double sum = 0;
    for (int i = 0; i < layer; ++i) sum += all[std::size_t(k * layer + i)].second;
    p.z.push_back((k + 0.5) * layer / n * length), p.stress.push_back(sum / layer);
  }
  return p;
}

// The same shocks with finite strain, as this hypoelastic solid has it: sigma = - M ln lambda, undeformed
// density; speeds in the undeformed plate.
struct Shocks {
  double stress[2], speed[2]; // first the elastic one
};
Shocks finite_shocks(double u) {
  const double M = K + 4 * G / 3;
  const auto compress = [](double modulus, double base, double from, double to) {
    return base + modulus * std::log(from / to);
  };
  // Stretch behind a shock that adds the velocity du.
  const auto behind = [&](double modulus, double from, double du) {
    double low = 0.5 * from, high = from;
    for (int k = 0; k < 200; ++k) {
      const double to = 0.5 * (low + high), rise = compress(modulus, 0, from, to);
      (rise * (from - to) / density > du * du ? low : high) = to;
    }
    return 0.5 * (low + high);
  };
  const double at_limit = std::exp(-elastic_limit / M);
  const double u_limit = std::sqrt(elastic_limit * (1 - at_limit) / density);
  const double first = u < u_limit ? behind(M, 1, u) : at_limit;
  Shocks s{};
  s.stress[0] = s.stress[1] = compress(M, 0, 1, first);
  s.speed[0] = std::sqrt(s.stress[0] / (density * (1 - first)));
  if (u < u_limit) return s;
  const double second = behind(K, first, u - u_limit);
  s.stress[1] = compress(K, s.stress[0], first, second);
  s.speed[1] = std::sqrt((s.stress[1] - s.stress[0]) / (density * (first - second)));
  return s;
}

double exact_stress(const Shocks& s, double z, double t) {
  return z < s.speed[1] * t ? s.stress[1] : z < s.speed[0] * t ? s.stress[0] : 0;
}

Profile impact(const Deck& method, const std::string& fill, int cells, double u, double until) {
  Simulation simulation(plate(method, fill, cells, u));
  simulation.start();
  run_until(simulation, until, [] {});
  return profile_of(simulation.scene());
}

double mean_between(const Profile& p, double from, double to) {
  double sum = 0;
  int n = 0;
  for (std::size_t k = 0; k < p.z.size(); ++k)
    if (p.z[k] > from && p.z[k] < to) sum += p.stress[k], ++n;
  return sum / n;
}

Series series_of(const std::string& label, const Profile& p) {
  Series s{label, {}, {}};
  for (std::size_t k = 0; k < p.z.size(); ++k) s.x.push_back(1e3 * p.z[k]), s.y.push_back(1e-6 * p.stress[k]);
  return s;
}

Series exact_series(const Shocks& shocks, double t) {
  Series s{"exact, finite strain", {}, {}, true};
  for (int k = 0; k <= 2000; ++k)
    s.x.push_back(k / 2000.0), s.y.push_back(1e-6 * exact_stress(shocks, k / 2000.0 * length, t));
  return s;
}

const double time_of_profile = 0.7 * length / elastic_speed;

// Runs three resolutions, asserts the order of the profile in L1, returns the finest.
Profile converge(const std::string& fill, const std::array<int, 3>& cells, double u, double order,
                 const std::string& source) {
  const Shocks shocks = finite_shocks(u);
  std::array<double, 3> size{}, error{};
  Profile p;
  for (std::size_t k = 0; k < 3; ++k) {
    p = impact(shipped_defaults(), fill, cells[k], u, time_of_profile);
    size[k] = 1.0 / cells[k];
    for (std::size_t i = 0; i < p.z.size(); ++i)
      error[k] += std::abs(p.stress[i] - exact_stress(shocks, p.z[i], time_of_profile)) / shocks.stress[1] /
                  double(p.z.size());
  }
  char run[96];
  std::snprintf(run, sizeof run, "%g m/s, %d, %d, %d along, shipped defaults", 2 * u, cells[0], cells[1],
                cells[2]);
  report_order("7 plate impact, " + fill, "profile of the stress, L1", run, size, error, order, 0.1, source);
  return p;
}

} // namespace

// 10 m/s of impact, 5 m/s of the face. The strain of 0.08 % makes the linear reference uncertain by as much.
TEST(PlateImpact, Elastic) {
  const double u = 5, t = time_of_profile, front = elastic_speed * t, exact = density * elastic_speed * u;
  Curve curve{"plate_impact_elastic",
              "Symmetric impact at 10 m/s, Ti-6Al-4V",
              "place in the plate, mm",
              "axial compression, MPa",
              {}};
  for (const std::string fill : {"particles", "hexes"}) {
    const Profile p =
        converge(fill, {50, 100, 200}, u, 2.0 / 3,
                 "Banks, Aslam & Rider 2008, J. Comput. Phys. 227: methods of order p have order "
                 "p/(p + 1) in L1 at a linear jump");
    const double ours = mean_between(p, 0.2 * front, 0.8 * front);
    report({"7 plate impact, " + fill, "elastic shock, mean stress of the plateau",
            "10 m/s, 200 along, shipped defaults", 1e-6 * exact, "MPa", theory, 1e-6 * ours,
            relative_error(ours, exact), 2e-3});
    curve.series.push_back(series_of(fill, p));
  }
  curve.series.push_back(exact_series(finite_shocks(u), t));
  write_curve(curve);
}

// 200 m/s of impact. Strains of 2 % and a bulk modulus that does not stiffen: the finite strain makes the
// plastic part, a third of the stress, uncertain by 1 %. The elastic limit follows from the yield condition
// alone.
TEST(PlateImpact, ElasticPlastic) {
  const double u = 100, t = time_of_profile;
  const double front = elastic_speed * t, second = plastic_speed * t, gap = front - second;
  const double exact =
      elastic_limit + density * plastic_speed * (u - elastic_limit / (density * elastic_speed));
  Curve curve{"plate_impact_plastic",
              "Symmetric impact at 200 m/s, Ti-6Al-4V, ideally plastic",
              "place in the plate, mm",
              "axial compression, MPa",
              {}};
  for (const std::string fill : {"particles", "hexes"}) {
    // The precursor is a linear jump; the plastic shock steepens itself, which is better.
    const Profile p = converge(fill, {100, 200, 400}, u, 2.0 / 3, theory + ", with finite strain");
    const std::string name = "7 plate impact, " + fill, run = "200 m/s, 400 along, shipped defaults";
    const double plateau = mean_between(p, 0.2 * second, 0.8 * second);
    const double precursor = mean_between(p, second + 0.35 * gap, second + 0.65 * gap);
    report({name, "elastic precursor", run, 1e-6 * elastic_limit, "MPa", theory, 1e-6 * precursor,
            relative_error(precursor, elastic_limit), 0.01, false,
            fill == "particles" ? "the plastic shock of particles is so wide that its toe fills the "
                                  "precursor: 3.5 % with 200 along"
                                : ""});
    report({name, "plateau behind the plastic shock", run, 1e-6 * exact, "MPa", theory, 1e-6 * plateau,
            relative_error(plateau, exact), 0.01});
    curve.series.push_back(series_of(fill, p));
  }
  curve.series.push_back(exact_series(finite_shocks(u), t));
  write_curve(curve);
}
