// Moves the particles by d_i and gives each what the fields that the table marks as transported are there:
//   f_i += sum_j V_j (f_j - f_i) grad W_ij . K_i d_i,
// exact for linear fields on any set of neighbours, and never beyond what the nearest have, all of one
// material. Masses stay as they are, so that sum m f of what is kept (momentum, heat, plastic
// strain) would change as far as sum m d is not zero: of a scalar, gains are scaled down to the losses, or
// losses to the gains; of a vector, the sum is taken back in proportion to each change, in directions in
// which ghosts leave it as it is: mirrors and turned sectors do not keep the others. The kinetic and
// elastic energy that goes is booked as shifting_work. Reads what find_shifts found; writes position,
// surface_normal, shifted_strain, the transported fields, internal_work and shifting_work.
#include "block_sum.hpp"
#include "swarf/kernels.hpp"
#include "swarf/material/thermal.hpp"
#include "swarf/particles/pair.hpp"
#include "swarf/particles/shifting.hpp"

namespace swarf {
namespace {

constexpr int columns = 16; // of all transported fields
using Values = View<Real* [columns]>;
using Changes = View<Real* [columns]>;

template <class Field>
SWARF_FN constexpr int width_of() {
  if constexpr (Field::rank == 1)
    return 1;
  else
    return int(Field::static_extent(1));
}
template <class Field>
SWARF_FN auto& element(const Field& f, int i, int c) {
  if constexpr (Field::rank == 1)
    return f(i);
  else
    return f(i, c);
}

// take(field, its first column, its facts) for each transported field; returns the number of columns.
template <class Take>
struct EachTransported {
  const Take& take;
  int* column;
  template <class Field, auto... named>
  SWARF_FN void operator()(const char*, const Field& field, Facts<named...> facts) const {
    if constexpr (facts.shifting != Shifting::stays) {
      take(field, *column, facts);
      *column += width_of<Field>();
    }
  }
};
template <class Take>
SWARF_FN int for_each_transported(const Particles& p, const Take& take) {
  int column = 0;
  for_each_field(p, EachTransported<Take>{take, &column});
  return column;
}

struct Count {
  template <class Field, class Row>
  SWARF_FN void operator()(const Field&, int, Row) const {}
};

struct Gather { // the values of row i
  const Values& to;
  int i;
  template <class Field, class Row>
  SWARF_FN void operator()(const Field& f, int column, Row) const {
    for (int c = 0; c < width_of<Field>(); ++c)
      to(i, column + c) = f.extent(0) > 0 ? element(f, i, c) : Real(0);
  }
};

struct Turn { // row `from` in the frame of its ghost `to`
  const Values& at;
  int from, to;
  const Tensor3& R;
  template <class Field, auto... named>
  SWARF_FN void operator()(const Field&, int k, Facts<named...> facts) const {
    if constexpr (facts.frame == Frame::vector) {
      const Vector3 v = multiply(R, Vector3{at(from, k), at(from, k + 1), at(from, k + 2)});
      at(to, k) = v.x, at(to, k + 1) = v.y, at(to, k + 2) = v.z;
    } else if constexpr (facts.frame == Frame::symmetric) {
      const Symmetric3 s = rotate(R, Symmetric3{at(from, k), at(from, k + 1), at(from, k + 2),
                                                at(from, k + 3), at(from, k + 4), at(from, k + 5)});
      at(to, k) = s.xx, at(to, k + 1) = s.yy, at(to, k + 2) = s.zz;
      at(to, k + 3) = s.xy, at(to, k + 4) = s.yz, at(to, k + 5) = s.zx;
    } else {
      for (int c = 0; c < width_of<Field>(); ++c) at(to, k + c) = at(from, k + c);
    }
  }
};

// Of all rows that a list may hold: side by side, for a pair reads them all.
Values gather_values(const Particles& p, const Neighbors& n, const GhostPlanes& planes) {
  const Values values(Kokkos::view_alloc(Kokkos::WithoutInitializing, "transported_values"), p.total);
  Kokkos::parallel_for(
      "gather_values", Range(0, p.listed), KOKKOS_LAMBDA(int i) {
        for_each_transported(p, Gather{values, i});
      });
  const int first = n.ghost_first;
  const auto source = n.ghost_source;
  for (int k = 0; k < n.planes; ++k) {
    const Tensor3 R = planes[std::size_t(k)].to_ghost.R;
    Kokkos::parallel_for(
        "turn_values", Range(n.ghost_start[k], n.ghost_start[k + 1]), KOKKOS_LAMBDA(int ghost) {
          for_each_transported(p, Turn{values, source(ghost), first + ghost, R});
        });
  }
  return values;
}

// The values of a cluster, and of each the sum, the least and the largest difference of near neighbours.
struct Transport {
  Pack own[columns], sum[columns], low[columns], high[columns];
};

KOKKOS_FORCEINLINE_FUNCTION void sum_neighbors(Transport& t, const Particles& p, const Neighbors& n,
                                               int cluster, const Lanes& lanes, const Values& values,
                                               const Vector3Of<Pack>& corrected) {
  const Pack zero(Real(0)), one(Real(1)), near2(value_reach * value_reach);
  const auto x_i = lanes.load_vector(p.position);
  const Pack inverse_support_i = lanes.load(p.inverse_support);
  const Pack material_i = make_pack([&](int lane) { return Real(p.points.material(lanes.row(lane))); });
  for (int c = 0; c < columns; ++c) t.own[c] = lanes.load(values, c);
  for (int c = 0; c < columns; ++c) t.sum[c] = t.low[c] = t.high[c] = zero;
  for_each_neighbor(n, cluster, [&](int j) {
    const auto x_ij = x_i - broadcast_vector(p.position, j);
    const Pack inverse_h = mean_inverse_h(inverse_support_i, p.inverse_support(j));
    const auto row = row_of(values, j);
    const Pack same = select(material_i == Pack(Real(p.points.material(j))), one, zero);
    const Pack weight = same * (pair_slope(p.volume(j), x_ij, inverse_h) * dot(x_ij, corrected));
    const Pack near = select(dot(x_ij, x_ij) * (inverse_h * inverse_h) < near2, same, zero);
    for (int c = 0; c < columns; ++c) {
      const Pack difference = Pack(row(c)) - t.own[c], seen = near * difference;
      t.sum[c] += weight * difference;
      t.low[c] = Kokkos::min(t.low[c], seen), t.high[c] = Kokkos::max(t.high[c], seen);
    }
  });
}

Changes find_changes(const Particles& p, const Neighbors& n, const Values& values, const Shifts& shifts) {
  const Changes changes(Kokkos::view_alloc(Kokkos::WithoutInitializing, "transported_changes"),
                        shifts.displacement.extent(0));
  Kokkos::parallel_for(
      "transport_fields", Range(0, shifts.clusters()), KOKKOS_LAMBDA(int k) {
        const int cluster = shifts.cluster(k);
        const Lanes lanes{n.first(cluster), n.size(cluster)}, slots{k * pack_width, lanes.size};
        Transport t;
        sum_neighbors(t, p, n, cluster, lanes, values, slots.load_vector(shifts.corrected));
        for (int lane = 0; lane < lanes.size; ++lane)
          for (int c = 0; c < columns; ++c)
            changes(slots.first + lane, c) =
                Kokkos::clamp(lane_of(t.sum[c], lane), lane_of(t.low[c], lane), lane_of(t.high[c], lane));
      });
  return changes;
}

// Sums over all of mass or heat capacity times the change, and times its size: of a vector's, in each column.
struct Balance {
  Real more[columns] = {}, size[columns] = {};
  KOKKOS_INLINE_FUNCTION void add(const Balance& o) {
    for (int c = 0; c < columns; ++c) more[c] += o.more[c], size[c] += o.size[c];
  }
  // What is left of the change of a scalar: all, or as much less as the other side has less.
  SWARF_FN Real kept(int c, Real change) const {
    const Real own = change > 0 ? size[c] + more[c] : size[c] - more[c], other = 2 * size[c] - own;
    return own > other ? other / own * change : change;
  }
};

struct Weigh {
  Balance& sums;
  const Changes& changes;
  int slot;
  Real mass, heat_capacity;
  template <class Field, auto... named>
  SWARF_FN void operator()(const Field&, int k, Facts<named...> facts) const {
    constexpr Shifting kind = facts.shifting;
    if constexpr (kind == Shifting::keeps_mass_sum || kind == Shifting::keeps_heat_sum) {
      const Real weight = kind == Shifting::keeps_mass_sum ? mass : heat_capacity;
      Real size2 = 0;
      for (int c = 0; c < width_of<Field>(); ++c) size2 += changes(slot, k + c) * changes(slot, k + c);
      for (int c = 0; c < width_of<Field>(); ++c)
        sums.more[k + c] += weight * changes(slot, k + c), sums.size[k + c] += weight * Kokkos::sqrt(size2);
    }
  }
};

struct KeepDirections { // of the sums of vectors
  Balance& sums;
  Tensor3 kept;
  template <class Field, auto... named>
  SWARF_FN void operator()(const Field&, int k, Facts<named...> facts) const {
    if constexpr (facts.frame == Frame::vector) {
      Real* more = sums.more + k;
      const Vector3 v = multiply(kept, Vector3{more[0], more[1], more[2]});
      more[0] = v.x, more[1] = v.y, more[2] = v.z;
    }
  }
};

struct Apply {
  const Balance& sums;
  const Changes& changes;
  int slot, i;
  template <class Field, auto... named>
  SWARF_FN void operator()(const Field& f, int k, Facts<named...> facts) const {
    constexpr bool keeps = facts.shifting != Shifting::transported;
    if (f.extent(0) == 0) return;
    Real size2 = 0;
    for (int c = 0; c < width_of<Field>(); ++c) size2 += changes(slot, k + c) * changes(slot, k + c);
    for (int c = 0; c < width_of<Field>(); ++c) {
      const Real change = changes(slot, k + c), size = sums.size[k + c];
      if constexpr (keeps && facts.frame == Frame::vector)
        element(f, i, c) += size > 0 ? change - Kokkos::sqrt(size2) * (sums.more[k + c] / size) : change;
      else
        element(f, i, c) += keeps ? sums.kept(k + c, change) : change;
    }
  }
};

// Row of a slot, or -1 of one that is spare.
SWARF_FN int row_of_slot(const Neighbors& n, const Shifts& shifts, int slot) {
  const int cluster = shifts.cluster(slot / pack_width), lane = slot % pack_width;
  return lane < n.size(cluster) ? n.first(cluster) + lane : -1;
}

Balance balance_changes(const Particles& p, const Neighbors& n, const MaterialTable& materials,
                        const Shifts& shifts, const Changes& changes) {
  return block_sum<Balance>(
      "balance_changes", shifts.clusters() * pack_width, KOKKOS_LAMBDA(int slot, Balance& sums) {
        const int i = row_of_slot(n, shifts, slot);
        if (i < 0) return;
        const Real mass = p.points.mass(i);
        for_each_transported(
            p, Weigh{sums, changes, slot, mass,
                     mass * specific_heat_at(materials(p.points.material(i)), p.points.temperature(i))});
      });
}

// Projects on the directions that no active plane turns or mirrors.
Tensor3 kept_directions(const GhostPlanes& planes) {
  Tensor3 kept = identity3();
  for (const GhostPlane& plane : planes) {
    const Tensor3 R = plane.to_ghost.R, back = transpose(R), I = identity3();
    const Real trace = R.xx + R.yy + R.zz, turned = Real(3) - trace;
    const bool mirror = determinant(R) < 0;
    if (!plane.active || (!mirror && turned < Real(1e-6))) continue; // a shift
    Tensor3 P; // half of 1 + R, or the axis times itself
    for (int c = 0; c < 9; ++c)
      (&P.xx)[c] = mirror ? Real(0.5) * ((&I.xx)[c] + (&R.xx)[c])
                          : ((&R.xx)[c] + (&back.xx)[c] + (Real(1) - trace) * (&I.xx)[c]) / turned;
    kept = multiply(kept, P);
  }
  return kept;
}

SWARF_FN Real stored_energy(const Particles& p, const Material& mat, int i) {
  return elastic_energy(mat, load_symmetric(p.points.stress, i),
                        p.points.mass(i) / p.points.density(i) /
                            stiffness_share(mat, p.points.temperature(i)));
}
// The changes keep the sum of heat capacity times the change: of a specific heat that depends on temperature
// so does the heat, as that of each particle is what its change says. The stress of the new place, which is
// taken along, has met what the temperature there has met.
SWARF_FN void settle_temperature(const MaterialPoints& p, const Material& mat, int i, Real before) {
  if (mat.specific_heat_table.points > 0)
    p.temperature(i) = warmed_by(mat, before, specific_heat_at(mat, before) * (p.temperature(i) - before));
  if (p.stress_temperature.extent(0) > 0) p.stress_temperature(i) += p.temperature(i) - before;
}
SWARF_FN Real kinetic_energy(const Particles& p, Real mass_factor, int i) {
  const Vector3 v = load_vector(p.velocity, i);
  return Real(0.5) * mass_factor * p.points.mass(i) * dot(v, v);
}

} // namespace

void transport_fields(const Particles& p, const Neighbors& n, const GhostPlanes& planes,
                      const MaterialTable& materials, const Shifts& shifts, Real mass_factor) {
  if (for_each_transported(p, Count{}) != columns)
    Kokkos::abort("transport_fields: another number of columns");
  if (shifts.clusters() == 0) return;
  const Values values = gather_values(p, n, planes);
  const Changes changes = find_changes(p, n, values, shifts);
  Balance sums = balance_changes(p, n, materials, shifts, changes);
  for_each_transported(p, KeepDirections{sums, kept_directions(planes)});
  const MaterialPoints points = p.points;
  Kokkos::parallel_for(
      "shift_particles", Range(0, shifts.clusters() * pack_width), KOKKOS_LAMBDA(int slot) {
        const int i = row_of_slot(n, shifts, slot);
        if (i < 0) return;
        const Vector3 d = load_vector(shifts.displacement, slot);
        store_vector(p.surface_normal, i, load_vector(shifts.normal, slot));
        if (dot(d, d) == 0) return;
        const Material& mat = materials(points.material(i));
        const Real kinetic = kinetic_energy(p, mass_factor, i), stored = stored_energy(p, mat, i),
                   strain = points.equivalent_plastic_strain(i), temperature = points.temperature(i);
        store_vector(p.position, i, load_vector(p.position, i) + d);
        for_each_transported(p, Apply{sums, changes, slot, i});
        settle_temperature(points, mat, i, temperature);
        const Real gained = stored_energy(p, mat, i) - stored;
        points.internal_work(i) += gained;
        p.shifting_work(i) -= gained + kinetic_energy(p, mass_factor, i) - kinetic;
        p.shifted_strain(i) += points.equivalent_plastic_strain(i) - strain +
                               norm(d) / (shift_per_strain * Kokkos::cbrt(p.volume(i)));
      });
}

} // namespace swarf
