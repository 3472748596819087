// A metal strip in plane strain between two faces that move apart: it stretches evenly and then necks.
#pragma once
#include "tests/verification/even_order.hpp"

namespace swarf::test::plastic_strip {

inline constexpr double dx = 10 * um, yield_stress = 1e9;
inline constexpr double necks = 1.2e9, stays_even = 2e9; // hardening: the force is largest at 32 % and 76 %
inline constexpr int deep = 3;

struct Pull {
  int along, across; // cells
  double share;      // of the length, at the end
  double hardening;  // Pa
  double speed;      // m/s, of each end
  double length() const { return along * dx; }
  double time_of(double pulled) const { return pulled * length() / (2 * speed); }
};

// Elastic constants, density, keys of the method and mass factor of the cutting decks.
inline Deck strip(const Pull& pull, const std::string& fill) {
  Deck deck = read_deck(std::string(SWARF_SOURCE_DIR) + "/inputs/orthogonal_cutting.toml");
  MaterialDeck& mat = deck.materials[0];
  mat.law = Law::linear_hardening, mat.yield_stress = yield_stress, mat.hardening_modulus = pull.hardening;
  mat.taylor_quinney = 0, mat.conductivity = 0;
  const double height = pull.across * dx;
  deck.bodies = {
      block("strip", fill, {-pull.length() / 2, -height / 2, 0}, {pull.length(), height, deep * dx}, dx)};
  BodyDeck& body = deck.bodies[0];
  body.material = mat.name;
  body.faces = {{"x_min", FaceKind::velocity, {-pull.speed, 0, 0}},
                {"x_max", FaceKind::velocity, {pull.speed, 0, 0}}};
  hold(body, "periodic", {"z_min", "z_max"});
  deck.tool.reset();
  deck.output.force_scale = 1;
  deck.run.end_time = pull.time_of(pull.share);
  return deck;
}

// Starts as it will flow, or waves of the start would make it yield.
inline void start_evenly(const Scene& scene, const Pull& pull) {
  const double rate = 2 * pull.speed / pull.length();
  set_velocity(scene, [&](const Triple& x) { return Triple{rate * x[0], -rate * x[1], 0}; });
}

// Force / first section at the logarithmic strain of the length: sigma = 2/sqrt(3) (Y + H e_p) in plane
// strain, e_p = 2/sqrt(3) (strain - elastic part), the section that of a volume that grows by sigma / 2K.
// Even until the force is largest (Considere): at a strain of 1 - sqrt(3) Y / 2H.
inline double engineering_stress(const MaterialDeck& mat, double strain) {
  const double G = mat.youngs_modulus.value / (2 * (1 + mat.poissons_ratio)),
               K = mat.youngs_modulus.value / (3 * (1 - 2 * mat.poissons_ratio));
  const double c = 2 / std::sqrt(3.0), soft = 1 / (4 * G) + 1 / (6 * K), H = mat.hardening_modulus;
  const double sigma = c * (yield_stress + H * c * strain) / (1 + c * c * H * soft);
  return sigma * std::exp(sigma / (2 * K) - strain);
}

// Mean stress between two pulls (shares of the length), from the work done meanwhile.
class ForceBetween {
 public:
  ForceBetween(double from, double to, const Pull& of)
      : pull(of), begin(pull.time_of(from)), end(pull.time_of(to)) {}
  void look(double time, double work) {
    if (time < begin || time > end) return;
    if (!(first_time > 0)) first_time = time, first_work = work;
    last_time = time, last_work = work;
  }
  double stress() const {
    const double section = pull.across * dx * deep * dx;
    return (last_work - first_work) / (2 * pull.speed * (last_time - first_time) * section);
  }
  // The exact one in the middle of the same time. Particles: driven is the row half a cell inside.
  double exact(const MaterialDeck& mat, const std::string& fill) const {
    const double held = pull.length() - (fill == "particles" ? dx : 0);
    return engineering_stress(mat, std::log(1 + pull.speed * (first_time + last_time) / held));
  }

 private:
  Pull pull;
  double begin, end, first_time = 0, first_work = 0, last_time = 0, last_work = 0;
};

inline EvenOrder order(const Scene& scene) {
  return SliceOrder(positions(scene.particles), {dx, 0, deep * dx, 0, 0, {}}).measure();
}

// What is farther apart than the kernel reaches is apart.
inline constexpr double reach = 2.4 * dx;

} // namespace swarf::test::plastic_strip
