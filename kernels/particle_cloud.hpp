// The surface of a body of particles as a particle of another body sees it: about x_i a weighted mean,
//   n = sum_j W(x_ij) s_j / |..|,  p = sum_j w_j x_j / sum_j w_j,  w_j = |s_j|^2 W(t_ij),  W(r) = (1 - r/R)^2
//   (1 + 2 r/R),
// s_j the outward vectors of find_body_contact, which vanish inside, t the distance along the surface, R two
// gaps. On a flat face of a lattice p is on the outer row wherever x_i is, so that bodies slide without
// bumps.
#pragma once
#include "swarf/hexes/body_contact.hpp"
#include "swarf/particles/particles.hpp"

namespace swarf {

struct CloudPoint {
  Real penetration = 0;
  Vector3 normal{0, 0, 0};
  Real weight = 0; // sum of all
  Real cover = 0;  // 1; less where the surface ends
};

struct Cloud {
  const BodyContact& c;
  const Particles& p;

  static SWARF_FN Real falling(Real ratio) {
    const Real left = Real(1) - ratio;
    return left > Real(0) ? left * left * (Real(1) + Real(2) * ratio) : Real(0);
  }

  SWARF_FN Real cover_of(int i, int j, const Vector3& normal) const { // items
    const int a = c.row(i - c.faces), b = c.row(j - c.faces);
    const Vector3 d = load_vector(p.position, a) - load_vector(p.position, b);
    return falling(norm(d - dot(d, normal) * normal) / (p.contact_gap(a) + p.contact_gap(b)));
  }
  // Of item j in what item i sees along its normal.
  SWARF_FN Real weight(int i, int j, const Vector3& normal) const {
    const Vector3 s = load_vector(c.outward, j);
    return dot(s, s) * cover_of(i, j, normal);
  }

  template <class Take>
  SWARF_FN void for_each(int i, const Vector3& normal, const Take& take) const { // rows of particles
    for (int k = c.start(i); k < c.start(i + 1); ++k)
      if (c.other(k) >= c.faces) take(c.row(c.other(k) - c.faces), weight(i, c.other(k), normal));
  }

  SWARF_FN Vector3 normal_of(int i) const {
    const int a = c.row(i - c.faces);
    Vector3 sum{0, 0, 0};
    for (int k = c.start(i); k < c.start(i + 1); ++k) {
      if (c.other(k) < c.faces) continue;
      const int b = c.row(c.other(k) - c.faces);
      const Real r = norm(load_vector(p.position, a) - load_vector(p.position, b));
      const Real reach = Real(1.5) * (p.contact_gap(a) + p.contact_gap(b));
      sum = sum + falling(r / reach) * load_vector(c.outward, c.other(k));
    }
    const Real length = norm(sum);
    return length > Real(0) ? (Real(1) / length) * sum : Vector3{0, 0, 0};
  }

  SWARF_FN CloudPoint below(int i) const {
    CloudPoint at;
    at.normal = normal_of(i);
    if (at.normal.x == 0 && at.normal.y == 0 && at.normal.z == 0) return at;
    const int a = c.row(i - c.faces);
    const Vector3 x = load_vector(p.position, a);
    Real reach = 0;
    for (int k = c.start(i); k < c.start(i + 1); ++k) {
      if (c.other(k) < c.faces) continue;
      const int b = c.row(c.other(k) - c.faces);
      const Real w = weight(i, c.other(k), at.normal);
      at.weight += w, at.cover += cover_of(i, c.other(k), at.normal);
      reach += w * (p.contact_gap(b) - dot(at.normal, x - load_vector(p.position, b)));
    }
    at.cover = Kokkos::min(Real(1), Real(5) * at.cover); // a fifth of the least that a whole face gives
    at.penetration = at.weight > Real(0) ? p.contact_gap(a) + reach / at.weight : Real(0);
    return at;
  }
};

} // namespace swarf
