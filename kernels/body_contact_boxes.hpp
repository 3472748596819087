// Boxes of faces, particles and groups of bodies, for find_body_contact.
#pragma once
#include "swarf/kernels.hpp"
#include <vector>

namespace swarf {

struct ContactBox {
  Vector3 low, high;
};

SWARF_FN Vector3 lower_of(const Vector3& a, const Vector3& b) {
  return {Kokkos::min(a.x, b.x), Kokkos::min(a.y, b.y), Kokkos::min(a.z, b.z)};
}
SWARF_FN Vector3 upper_of(const Vector3& a, const Vector3& b) {
  return {Kokkos::max(a.x, b.x), Kokkos::max(a.y, b.y), Kokkos::max(a.z, b.z)};
}

SWARF_FN ContactBox box_of_face(const HexMesh& h, int side) {
  ContactBox box;
  for (int a = 0; a < points_of_face; ++a) {
    const Vector3 x = load_vector(h.position, h.connectivity(side / 6, corner_of_side(side % 6, a)));
    box = a == 0 ? ContactBox{x, x} : ContactBox{lower_of(box.low, x), upper_of(box.high, x)};
  }
  return box;
}

SWARF_FN ContactBox box_of_particle(const Particles& p, int i) {
  const Real gap = p.contact_gap(i);
  const Vector3 x = load_vector(p.position, i), out{gap, gap, gap};
  return {x - out, x + out};
}

SWARF_FN bool do_meet(const ContactBox& a, const ContactBox& b, Real skin) {
  return a.low.x - skin <= b.high.x && b.low.x - skin <= a.high.x && a.low.y - skin <= b.high.y &&
         b.low.y - skin <= a.high.y && a.low.z - skin <= b.high.z && b.low.z - skin <= a.high.z;
}

inline Real distance_between(const ContactBox& a,
                             const ContactBox& b) { // along the axis in which it is most; 0: they meet
  const Vector3 apart = upper_of(a.low - b.high, b.low - a.high);
  return Kokkos::max(Kokkos::max(apart.x, apart.y), Kokkos::max(apart.z, Real(0)));
}

// box_at(row) of the rows that count, empty for the others. Extremes are the same in any order.
template <class BoxAt>
ContactBox box_around(int rows, const BoxAt& box_at) {
  constexpr Real infinity = Kokkos::Experimental::infinity_v<Real>;
  ContactBox all{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  Kokkos::parallel_reduce(
      "group_low", Range(0, rows),
      KOKKOS_LAMBDA(int k, Real& x, Real& y, Real& z) {
        const Vector3 low = box_at(k).low;
        x = Kokkos::min(x, low.x), y = Kokkos::min(y, low.y), z = Kokkos::min(z, low.z);
      },
      Kokkos::Min<Real>(all.low.x), Kokkos::Min<Real>(all.low.y), Kokkos::Min<Real>(all.low.z));
  Kokkos::parallel_reduce(
      "group_high", Range(0, rows),
      KOKKOS_LAMBDA(int k, Real& x, Real& y, Real& z) {
        const Vector3 high = box_at(k).high;
        x = Kokkos::max(x, high.x), y = Kokkos::max(y, high.y), z = Kokkos::max(z, high.z);
      },
      Kokkos::Max<Real>(all.high.x), Kokkos::Max<Real>(all.high.y), Kokkos::Max<Real>(all.high.z));
  return all;
}

SWARF_FN ContactBox empty_box() {
  const Real infinity = Kokkos::Experimental::infinity_v<Real>;
  return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
}

// Rows [0, groups): of each group's faces; [groups, 2 groups): of its particles. A group without has a box
// that nothing meets.
inline std::vector<ContactBox> boxes_of_groups(const HexMesh& h, const Particles& p, const ContactGroups& g,
                                               const IndexField& surface) {
  std::vector<ContactBox> boxes;
  for (int group = 0; group < g.count; ++group)
    boxes.push_back(box_around(
        int(surface.extent(0)), KOKKOS_LAMBDA(int k) {
          return g.of_hex(surface(k) / 6) == group ? box_of_face(h, surface(k)) : empty_box();
        }));
  for (int group = 0; group < g.count; ++group)
    boxes.push_back(box_around(
        p.count, KOKKOS_LAMBDA(int i) {
          return g.of_body(p.body(i)) == group ? box_of_particle(p, i) : empty_box();
        }));
  return boxes;
}

} // namespace swarf
