// One step of a power iteration: w <- a over its length, a = -f / m of the forces that the motion w has
// brought. Repeated, it turns w into the mode of the highest frequency. A hundredth of noise is added, from
// which modes grow that w has nothing of, and which begins it. Returns |a| / |w|, which grows to the square
// of the frequency, and w.C w / w.m w of the viscosity; 0 at the beginning. Reads force, mass, viscous_work
// of w over 1 s; reads and writes highest_mode, rows [0, count); 0 in the others.
#include "block_sum.hpp"
#include "swarf/kernels.hpp"

namespace swarf {
namespace {

constexpr Real noise = Real(0.01);

struct ModeSums {
  Real before = 0, after = 0;   // squares of the lengths
  Real energy = 0, viscous = 0; // w.m w, w.C w
  SWARF_FN void add(const ModeSums& o) {
    before += o.before, after += o.after, energy += o.energy, viscous += o.viscous;
  }
};

// -1 to 1, of each key another: a multiplicative hash (Knuth, vol. 3, 6.4), twice.
SWARF_FN Real noise_of(unsigned key) {
  key = (key ^ key >> 16) * 0x45d9f3bu;
  key = (key ^ key >> 16) * 0x45d9f3bu;
  return Real(2) * Real(key ^ key >> 16) / Real(4294967295.0) - Real(1);
}

SWARF_FN Vector3 acceleration(const Particles& p, int i, const Oscillators& of) {
  const Vector3 a = (Real(-1) / (of.mass_factor * p.points.mass(i))) * load_vector(p.force, i);
  return p.contact_energy(i) > Real(0) ? a + of.contact * load_vector(p.highest_mode, i) : a;
}

} // namespace

ModeRates advance_mode(const Particles& p, const Oscillators& of, long seed) {
  const ModeSums sums = block_sum<ModeSums>(
      "mode_sums", p.count, KOKKOS_LAMBDA(int i, ModeSums& sum) {
        const Vector3 w = load_vector(p.highest_mode, i), a = acceleration(p, i, of);
        const Real w2 = dot(w, w);
        sum.add({w2, dot(a, a), of.mass_factor * p.points.mass(i) * w2, p.viscous_work(i)});
      });
  const bool begins = !(sums.before > Real(0)) || !(sums.after > Real(0));
  const Real scale = begins ? Real(0) : Real(1) / Kokkos::sqrt(sums.after);
  const Real amplitude = noise / Kokkos::sqrt(Real(p.count)); // beside a length of 1
  const unsigned first = unsigned(seed) * 2654435761u;
  Kokkos::parallel_for(
      "advance_mode", Range(0, p.stored), KOKKOS_LAMBDA(int i) {
        Vector3 w{0, 0, 0};
        if (i < p.count) {
          const unsigned key = first + 3u * unsigned(p.identity(i));
          const Vector3 random{noise_of(key), noise_of(key + 1), noise_of(key + 2)};
          w = amplitude * random;
          if (!begins) w = w + scale * acceleration(p, i, of);
        }
        store_vector(p.highest_mode, i, w);
      });
  if (begins) return {};
  return {Kokkos::sqrt(sums.after / sums.before), sums.viscous / sums.energy};
}

} // namespace swarf
