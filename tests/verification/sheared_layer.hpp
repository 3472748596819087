// Metal in even shear between two plates that also press it. Law, keys of the method and mass factor are
// those of the cutting decks, but isothermal: softening would gather the shear in a band.
#pragma once
#include "tests/verification/even_order.hpp"
#include <random>

namespace swarf::test::sheared_layer {

inline constexpr double dx = 10 * um, squeeze = 0.015;

struct Shape {
  int along, high, deep;
  double speed, gamma; // m/s, of one plate against the other; shear at the end
  double height() const { return high * dx; }
  double end() const { return gamma * height() / speed; }
};

inline Deck sheared(const Shape& l, const std::string& fill = "particles") {
  Deck deck = read_deck(std::string(SWARF_SOURCE_DIR) + "/inputs/orthogonal_cutting.toml");
  MaterialDeck& mat = deck.materials[0];
  mat.taylor_quinney = 0, mat.conductivity = 0;
  const double press = squeeze * l.height() / l.end();
  deck.bodies = {block("layer", fill, {0, 0, 0}, {l.along * dx, l.height(), l.deep * dx}, dx)};
  BodyDeck& layer = deck.bodies[0];
  layer.material = mat.name, layer.temperature = mat.reference_temperature;
  layer.faces = {{"y_min", FaceKind::velocity, {-l.speed / 2, press / 2, 0}},
                 {"y_max", FaceKind::velocity, {l.speed / 2, -press / 2, 0}}};
  hold(layer, "periodic", {"x_min", "x_max", "z_min", "z_max"});
  deck.tool.reset();
  deck.output.force_scale = 1;
  deck.run.end_time = l.end();
  return deck;
}

inline void start_evenly(const Scene& scene, const Shape& l) {
  const double rate = l.speed / l.height();
  set_velocity(scene, [&](const Triple& x) { return Triple{rate * (x[1] - l.height() / 2), 0, 0}; });
}

// Puts particles off their lattice by at most `share` of the spacing; the plates' keep their places.
inline void disturb(const Scene& scene, double share) {
  const auto x = host_copy(scene.particles.position);
  const auto held = host_copy(scene.particles.constraints);
  std::minstd_rand random(1);
  for (int i = 0; i < scene.particles.count; ++i)
    for (int d = 0; d < 3; ++d) {
      const double unit = 2.0 * double(random() - 1) / double(std::minstd_rand::modulus - 2) - 1;
      if (held(i) == 0) x(i, d) += Real(share * dx * unit);
    }
  Kokkos::deep_copy(scene.particles.position, x);
}

inline constexpr double yield_stress = 1e9, hardening = 0.2e9;

// Hardening, so that the shear stays even.
inline void harden(MaterialDeck& mat) {
  mat.law = Law::linear_hardening, mat.yield_stress = yield_stress, mat.hardening_modulus = hardening;
}

// The part of the layer that is farther than three rows from both plates.
class Middle {
 public:
  Middle(const Shape& of, const MaterialDeck& mat)
      : l(of), shear_modulus(mat.youngs_modulus.value / (2 * (1 + mat.poissons_ratio))) {}

  // Shear from the velocities on the way, stress over the last tenth.
  void look(const Scene& scene, double time) {
    const bool particles = scene.particles.count > 0;
    const auto x = host_copy(particles ? scene.particles.position : scene.hexes.position);
    const auto v = host_copy(particles ? scene.particles.velocity : scene.hexes.velocity);
    const int rows = particles ? scene.particles.count : scene.hexes.nodes;
    double n = 0, y = 0, u = 0, yy = 0, yu = 0;
    for (int i = 0; i < rows; ++i) {
      if (!within(double(x(i, 1)))) continue;
      n += 1, y += double(x(i, 1)), u += double(v(i, 0));
      yy += double(x(i, 1) * x(i, 1)), yu += double(x(i, 1) * v(i, 0));
    }
    const double slope = (yu - y * u / n) / (yy - y * y / n);
    gamma += (last > 0 ? 0.5 * (rate + slope) : slope) * (time - last);
    rate = slope, last = time;
    if (time < 0.9 * l.end()) return;
    const auto s = host_copy(points_of(scene).stress);
    double sum = 0, count = 0;
    for (const int e : rows_within(scene)) sum += double(s(e, 3)), count += 1;
    stress_sum += sum / count, gamma_sum += gamma, looks += 1;
  }

  void finish(const Scene& scene) {
    const auto e = host_copy(points_of(scene).equivalent_plastic_strain);
    double sum = 0, square = 0, n = 0;
    for (const int i : rows_within(scene)) sum += double(e(i)), square += double(e(i) * e(i)), n += 1;
    strain = sum / n, spread = std::sqrt(std::max(0.0, square / n - strain * strain)) / strain;
    stress = stress_sum / looks, stress_gamma = gamma_sum / looks;
  }

  double gamma = 0;  // that the velocities have made
  double strain = 0; // plastic, mean
  double spread = 0; // its standard deviation / mean
  double stress = 0; // shear stress, mean over the last tenth, Pa
  double exact_strain() const { return strain_at(gamma); }
  double exact_stress() const {
    return (yield_stress + hardening * strain_at(stress_gamma)) / std::sqrt(3.0);
  }

 private:
  Shape l;
  double shear_modulus;
  double rate = 0, last = 0, stress_sum = 0, gamma_sum = 0, stress_gamma = 0, looks = 0;

  bool within(double y) const { return y > 3 * dx && y < l.height() - 3 * dx; }
  static const MaterialPoints& points_of(const Scene& scene) {
    return scene.particles.count > 0 ? scene.particles.points : scene.hexes.points;
  }
  std::vector<int> rows_within(const Scene& scene) const {
    std::vector<int> rows;
    if (scene.particles.count > 0) {
      const auto x = host_copy(scene.particles.position);
      for (int i = 0; i < scene.particles.count; ++i)
        if (within(double(x(i, 1)))) rows.push_back(i);
    } else {
      const auto x = host_copy(scene.hexes.position);
      const auto node = host_copy(scene.hexes.connectivity);
      for (int e = 0; e < scene.hexes.points.count; ++e) {
        double y = 0;
        for (int k = 0; k < 8; ++k) y += double(x(node(e, k), 1)) / 8;
        if (within(y)) rows.push_back(e);
      }
    }
    return rows;
  }
  // gamma = sqrt(3) e_p + tau / G, tau = (Y + H e_p) / sqrt(3).
  double strain_at(double shear) const {
    const double root = std::sqrt(3.0);
    return (shear - yield_stress / (root * shear_modulus)) / (root + hardening / (root * shear_modulus));
  }
};

inline EvenOrder order(const Scene& scene, const Shape& l) {
  return SliceOrder(positions(scene.particles), {dx, 0, l.deep * dx, 0, l.along * dx, {}}).measure();
}

} // namespace swarf::test::sheared_layer
