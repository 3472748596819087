// f_i = V_i sum_j V_j [ (sigma_i + t_i) K_i + (sigma_j + t_j) K_j - q_ij 1 ] grad W_ij, t: surface_stress.cpp
// The corrected gradient appears as in the velocity gradient, so that the forces do on any velocity field the
// work that the stresses do (Bonet & Lok 1999): linear and angular momentum and energy are conserved.
// q: the viscosity of Monaghan (1992), -alpha Z mu + beta rho mu^2, rho and Z = rho c of the scaled mass, mu
// from v_ij - (D_i + D_j) x_ij / 2, which a linear velocity field makes zero (Frontiere, Raskin & Owen 2017),
// so that steady shear feels no viscosity. The linear term damps whatever no gradient sees, whether the pair
// approaches or parts; the quadratic one acts in shocks, on pairs that approach. The sum of the remainder
// over time meets the hourglass stiffness, kappa G x_ij.(d_i - d_j) / r^2 (evolve_hourglass.cpp). In the
// initial frame grad W is that of X_ij (reference_gradient.cpp), and q acts along the line x_ij with its
// slope, so that it takes energy however the body has turned. Reads what prepare_pair_state wrote. Writes
// force, rows [0, count + tied); adds viscous_work.
#include "swarf/kernels.hpp"
#include "swarf/particles/pair.hpp"

namespace swarf {
namespace {

// Chosen when compiled: unused sums would cost a third of the pass.
template <bool with_stiff, bool in_initial_frame>
struct Terms {
  static constexpr bool stiff = with_stiff, initial = in_initial_frame;
};

// The cluster's own values and sums.
struct ForceSums {
  Vector3Of<Pack> neighbor_stress; // sum V_j [P_j - q] grad W
  Vector3Of<Pack> gradient;        // sum V_j grad W, meets P_i afterwards
  Vector3Of<Pack> hourglass_rate;
  Pack viscous_power, hourglass_power; // sum V_j q grad W . v_ij
};

// Of the pressures of a pair, which take the mean of both particles: half of it for each. Read from memory,
// for a compiler that knows a pack to be one number multiplies before it broadcasts: two operations, not one.
struct Coefficients {
  Pack linear, quadratic, stiffness; // of Z, rho, G
  Pack half;

  explicit Coefficients(const ParticleMethod& m)
      : linear(Real(-0.5) * m.viscosity_linear), quadratic(Real(0.5) * m.viscosity_quadratic),
        stiffness(Real(-0.5) * m.hourglass_stiffness), half(Real(0.5)) {}
};

struct Cluster {
  Vector3Of<Pack> x, X, v, d;
  Tensor3Of<Pack> F;
  Symmetric3Of<Pack> D; // with half its diagonal
  Pack inverse_support;
  Pack linear, quadratic, stiffness; // its own part of the pair's
};

struct PairViscosity {
  Pack pressure;      // Pa
  Pack beyond_linear; // x_ij . (v_ij - (D_i + D_j) x_ij / 2), m2/s
  Pack per_area;      // 1 / r2, 1/m2
};

// xv - x . (D_i + D_j) x / 2
KOKKOS_FORCEINLINE_FUNCTION Pack beyond_linear(const Pack& xv, const Symmetric3Of<Pack>& D_i,
                                               const Symmetric3Of<Pack>& D_j, const Vector3Of<Pack>& x,
                                               const Pack& half) {
  const Pack xy = D_i.xy + D_j.xy, yz = D_i.yz + D_j.yz, zx = D_i.zx + D_j.zx;
  const Pack Dx = (D_i.xx + half * D_j.xx) * x.x + (xy * x.y + zx * x.z);
  const Pack Dy = (D_i.yy + half * D_j.yy) * x.y + yz * x.z, Dz = (D_i.zz + half * D_j.zz) * x.z;
  return xv - Dx * x.x - Dy * x.y - Dz * x.z;
}

// xv = x_ij . v_ij. The shock's part is zero for pairs that part; the weaker of v_ij and what is left of it
// counts, so that it never feeds energy. The linear part may, of a pair whose remainder has the other sign
// than xv; its sum over all pairs damps.
KOKKOS_FORCEINLINE_FUNCTION PairViscosity pair_viscosity(const Cluster& i, const Particles& p, int j,
                                                         const Vector3Of<Pack>& x_ij, const Pack& xv,
                                                         const Pack& inverse_h, const Coefficients& c) {
  const Pack zero(Real(0));
  const Pack beyond =
      beyond_linear(xv, i.D, broadcast_symmetric(p.points.velocity_gradient, j), x_ij, c.half);
  const Pack approach = Kokkos::max(Kokkos::min(xv, zero), Kokkos::min(beyond, zero));
  const Pack q2 = dot(x_ij, x_ij) * (inverse_h * inverse_h);
  const Pack per_length = inverse_h * reciprocal(q2 + Pack(Real(0.01)));
  const Pack mu = approach * per_length, Z_j = broadcast(p.impedance, j, 0);
  const Pack quadratic = i.quadratic + c.quadratic * broadcast(p.impedance, j, 1);
  return {(i.linear + c.linear * Z_j) * (beyond * per_length) + quadratic * mu * mu, beyond,
          per_length * inverse_h};
}

struct PairSpring {
  Pack end, mean; // Pa, at the end of the step; the mean over it, whose work is that of the forces
};

// Resists what no gradient sees: differences of hourglass_displacement; in the initial frame elongations that
// F does not explain (Ganzenmueller 2015). The displacement lacks what this step adds to it, at most twice
// the pair's own motion (planes of a lattice that move against each other, evolve_hourglass.cpp). That much
// is added: a spring that lags makes energy at every step, a hasty one damps.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION PairSpring pair_spring(const Cluster& i, const Particles& p, int j,
                                                   const Vector3Of<Pack>& x_ij, const Vector3Of<Pack>& X_ij,
                                                   const Pack& inverse_h, const PairViscosity& q,
                                                   const Coefficients& c, Real dt) {
  const Pack half_step(Real(0.5) * dt), modulus = i.stiffness + c.stiffness * broadcast(p.impedance, j, 2);
  if constexpr (T::initial) {
    const auto F = i.F + broadcast_tensor(p.deformation_gradient, j);
    const Pack stretch = dot(x_ij, x_ij - Pack(Real(0.5)) * multiply(F, X_ij));
    const Pack stiffness = modulus / (dot(X_ij, X_ij) + Pack(Real(0.01)) / (inverse_h * inverse_h));
    return {stiffness * stretch, stiffness * (stretch - half_step * q.beyond_linear)};
  } else {
    const Pack stretch =
        dot(x_ij, i.d - broadcast_vector(p.hourglass_displacement, j)) + Pack(Real(2) * dt) * q.beyond_linear;
    const Pack stiffness = modulus * q.per_area;
    return {stiffness * stretch, stiffness * (stretch - half_step * q.beyond_linear)};
  }
}

template <class T>
KOKKOS_FORCEINLINE_FUNCTION void add_pair(ForceSums& s, const Cluster& i, const Particles& p,
                                          const Neighbors& n, int j, const Coefficients& c, Real dt) {
  const auto x_ij = i.x - broadcast_vector(p.position, j);
  const auto v_ij = i.v - broadcast_vector(p.velocity, j);
  const Pack inverse_h = mean_inverse_h(i.inverse_support, p.inverse_support(j));
  auto X_ij = x_ij;
  if constexpr (T::initial) X_ij = i.X - broadcast_vector(n.build_position, j);
  const Pack slope = pair_slope(p.volume(j), X_ij, inverse_h);
  const auto grad = slope * X_ij, line = slope * x_ij;
  const Pack xv = dot(x_ij, v_ij);
  const PairViscosity q = pair_viscosity(i, p, j, x_ij, xv, inverse_h, c);
  const Pack rate = slope * xv;
  Pack pressure = q.pressure;
  s.viscous_power += q.pressure * rate;
  if constexpr (T::stiff) {
    const PairSpring spring = pair_spring<T>(i, p, j, x_ij, X_ij, inverse_h, q, c, dt);
    pressure += spring.end;
    s.hourglass_power += spring.mean * rate;
    if constexpr (!T::initial) s.hourglass_rate = s.hourglass_rate - q.beyond_linear * grad;
  }
  s.gradient = s.gradient + grad;
  add_product(s.neighbor_stress, broadcast_tensor(p.pair_stress, j), grad);
  s.neighbor_stress = s.neighbor_stress - pressure * line;
}

template <class T>
KOKKOS_INLINE_FUNCTION ForceSums sum_pairs(const Particles& p, const Neighbors& n, int cluster,
                                           const Lanes& lanes, const Coefficients& c, Real dt) {
  const Pack zero(Real(0));
  ForceSums s{{zero, zero, zero}, {zero, zero, zero}, {zero, zero, zero}, zero, zero};
  const Pack impedance = lanes.load(p.impedance, 0);
  const auto D = load_symmetric(p.points.velocity_gradient, lanes);
  const Cluster i{.x = lanes.load_vector(p.position),
                  .X = lanes.load_vector(T::initial ? n.build_position : p.position),
                  .v = lanes.load_vector(p.velocity),
                  .d = T::stiff && !T::initial ? lanes.load_vector(p.hourglass_displacement)
                                               : Vector3Of<Pack>{zero, zero, zero},
                  .F = T::stiff && T::initial ? lanes.load_tensor(p.deformation_gradient) : Tensor3Of<Pack>{},
                  .D = {c.half * D.xx, c.half * D.yy, c.half * D.zz, D.xy, D.yz, D.zx},
                  .inverse_support = lanes.load(p.inverse_support),
                  .linear = c.linear * impedance,
                  .quadratic = c.quadratic * lanes.load(p.impedance, 1),
                  .stiffness = c.stiffness * lanes.load(p.impedance, 2)};
  for_each_neighbor(n, cluster, [&](int j) { add_pair<T>(s, i, p, n, j, c, dt); });
  return s;
}

template <class T>
void launch(const Particles& p, const Neighbors& n, const ParticleMethod& m, Real dt) {
  const Coefficients c(m);
  Kokkos::parallel_for(
      "particle_forces", Range(0, n.clusters + n.tied_clusters), KOKKOS_LAMBDA(int cluster) {
        const Lanes lanes{n.first(cluster), n.size(cluster)};
        const ForceSums s = sum_pairs<T>(p, n, cluster, lanes, c, dt);
        for (int lane = 0; lane < lanes.size; ++lane) {
          const int i = lanes.first + lane;
          const Vector3 own = multiply(load_tensor(p.pair_stress, i), lane_of(s.gradient, lane));
          const Vector3 f = lane_of(s.neighbor_stress, lane) + own;
          store_vector(p.force, i, p.volume(i) * f);
          if constexpr (T::stiff && !T::initial)
            store_vector(p.hourglass_rate, i, lane_of(s.hourglass_rate, lane));
          p.viscous_work(i) += Real(0.5) * dt * p.volume(i) * lane_of(s.viscous_power, lane);
          p.hourglass_work(i) += Real(0.5) * dt * p.volume(i) * lane_of(s.hourglass_power, lane);
        }
      });
}

} // namespace

void particle_forces(const Particles& p, const Neighbors& n, const ParticleMethod& m, Real dt) {
  const bool stiff = m.hourglass_stiffness > 0;
  if (m.initial_frame)
    stiff ? launch<Terms<true, true>>(p, n, m, dt) : launch<Terms<false, true>>(p, n, m, dt);
  else
    stiff ? launch<Terms<true, false>>(p, n, m, dt) : launch<Terms<false, false>>(p, n, m, dt);
}

} // namespace swarf
