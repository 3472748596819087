// The 8-node hexahedron with one integration point (Flanagan & Belytschko 1981), as pure functions.
// Corners in VTK order: xi = - + + - - + + -, eta = - - + + - - + +, zeta = - - - - + + + +.
#pragma once
#include "swarf/core/eigen.hpp"
#include "swarf/core/pack.hpp"
#include "swarf/hexes/hex_mesh.hpp"

namespace swarf {

template <class S>
struct HexVectorsOf { // one vector per corner
  Vector3Of<S> at[8];
};
using HexVectors = HexVectorsOf<Real>;

// Rows of a nodal field at the corners of hex e, less the row of corner 0: a uniform field is exactly 0.
SWARF_FN HexVectors load_corners(const VectorField& field, const View<int* [8]>& connectivity, int e) {
  HexVectors c;
  const Vector3 origin = load_vector(field, connectivity(e, 0));
  for (int a = 0; a < 8; ++a) c.at[a] = load_vector(field, connectivity(e, a)) - origin;
  return c;
}
SWARF_FN HexVectors load_gradient(const View<Real* [8][3]>& gradient, int e) {
  HexVectors B;
  for (int a = 0; a < 8; ++a) B.at[a] = {gradient(e, a, 0), gradient(e, a, 1), gradient(e, a, 2)};
  return B;
}
SWARF_FN void store_corners(const View<Real* [8][3]>& field, int e, const HexVectors& c) {
  for (int a = 0; a < 8; ++a)
    field(e, a, 0) = c.at[a].x, field(e, a, 1) = c.at[a].y, field(e, a, 2) = c.at[a].z;
}

// --- mean gradient
// The bilinear face a b c d, seen counter-clockwise from outside, adds the integral of N n dA over it to each
// of its corners: at a, (2 S + (x_b - x_a) x (x_d - x_a)) / 12, S = (x_c - x_a) x (x_d - x_b) / 2 its area.
template <class S>
SWARF_FN void add_face(const HexVectorsOf<S>& x, HexVectorsOf<S>& sum, int a, int b, int c, int d) {
  const S share(Real(1) / Real(12));
  const Vector3Of<S> area2 = share * cross(x.at[c] - x.at[a], x.at[d] - x.at[b]);
  const Vector3Of<S> at_a = share * cross(x.at[b] - x.at[a], x.at[d] - x.at[a]);
  const Vector3Of<S> at_b = share * cross(x.at[c] - x.at[b], x.at[a] - x.at[b]);
  sum.at[a] = sum.at[a] + area2 + at_a;
  sum.at[b] = sum.at[b] + area2 + at_b;
  sum.at[c] = sum.at[c] + area2 + (area2 - at_a);
  sum.at[d] = sum.at[d] + area2 + (area2 - at_b);
}

template <class S>
struct HexGradientOf {
  HexVectorsOf<S> B; // 1/m
  S volume;          // m3, exact for the trilinear hex; not positive: inverted, and B has no meaning
};
using HexGradient = HexGradientOf<Real>;

// B_a = (dV/dx_a) / V, the mean of grad N_a over the hex: exact for linear fields on any hex.
template <class S>
SWARF_FN HexGradientOf<S> mean_gradient(const HexVectorsOf<S>& x) {
  const S zero(Real(0));
  HexVectorsOf<S> sum;
  for (int a = 0; a < 8; ++a) sum.at[a] = {zero, zero, zero};
  add_face(x, sum, 0, 3, 2, 1);
  add_face(x, sum, 4, 5, 6, 7);
  add_face(x, sum, 0, 1, 5, 4);
  add_face(x, sum, 1, 2, 6, 5);
  add_face(x, sum, 2, 3, 7, 6);
  add_face(x, sum, 3, 0, 4, 7);
  S volume(Real(0));
  for (int a = 0; a < 8; ++a) volume = volume + dot(sum.at[a], x.at[a]);
  volume = volume / S(Real(3));
  const S inverse_volume = S(Real(1)) / volume;
  for (int a = 0; a < 8; ++a) sum.at[a] = inverse_volume * sum.at[a];
  return {sum, volume};
}

// L_ij = sum_a v_ai B_aj
template <class S>
SWARF_FN Tensor3Of<S> velocity_gradient(const HexVectorsOf<S>& v, const HexVectorsOf<S>& B) {
  const S zero(Real(0));
  Tensor3Of<S> L{zero, zero, zero, zero, zero, zero, zero, zero, zero};
  for (int a = 0; a < 8; ++a) {
    const Vector3Of<S>&u = v.at[a], &b = B.at[a];
    L = L + Tensor3Of<S>{u.x * b.x, u.x * b.y, u.x * b.z, u.y * b.x, u.y * b.y,
                         u.y * b.z, u.z * b.x, u.z * b.y, u.z * b.z};
  }
  return L;
}

// --- length
struct HexMoments {  // of sum_a B_a B_a^T, 1/m2
  Real largest, sum; // eigenvalue; of all three
};
SWARF_FN HexMoments gradient_moments(const HexVectors& B) {
  Symmetric3 sum{};
  for (int a = 0; a < 8; ++a) {
    const Vector3& b = B.at[a];
    sum = sum + Symmetric3{b.x * b.x, b.y * b.y, b.z * b.z, b.x * b.y, b.y * b.z, b.z * b.x};
  }
  return {largest_eigenvalue(sum), trace(sum)};
}

// The edge of a cube, the thickness of a flat brick. Plane waves in a mesh of lumped masses need dt <= l / c.
SWARF_FN Real characteristic_length(const HexMoments& g) {
  return Real(1) / Kokkos::sqrt(Real(2) * g.largest);
}
SWARF_FN Real characteristic_length(const HexVectors& B) {
  return characteristic_length(gradient_moments(B));
}
SWARF_FN Real characteristic_length(const HexMesh& mesh, int e) {
  return characteristic_length(load_gradient(mesh.gradient, e));
}

// --- bulk viscosity
struct HexInertia {
  Real density;    // mass-scaled, kg/m3
  Real wave_speed; // of the scaled mass, m/s
};

// q = rho ((b2 l rate)^2 - b1 c l rate) in compression, rate = tr D < 0; 0 in expansion (von Neumann &
// Richtmyer 1950, Landshoff 1955). Pa, a pressure. Usual: b1 = 0.06, b2 = 1.2.
SWARF_FN Real bulk_viscosity(const HexInertia& scaled, Real linear, Real quadratic, Real length, Real rate) {
  if (rate >= Real(0)) return 0;
  const Real speed = length * rate;
  return scaled.density * speed * (quadratic * quadratic * speed - linear * scaled.wave_speed);
}

// --- hourglass control
struct HexModes { // one vector per hourglass base vector: eta zeta, zeta xi, xi eta, xi eta zeta
  Vector3 mode[4];
};

// sum_a h_a^m u_a
SWARF_FN HexModes project_modes(const HexVectors& u) {
  const Vector3 s01 = u.at[0] + u.at[1], s23 = u.at[2] + u.at[3], s45 = u.at[4] + u.at[5];
  const Vector3 d01 = u.at[0] - u.at[1], d23 = u.at[2] - u.at[3], d45 = u.at[4] - u.at[5];
  const Vector3 s67 = u.at[6] + u.at[7], d67 = u.at[6] - u.at[7];
  return {{(s01 - s23) - (s45 - s67), (d01 - d23) - (d45 - d67), (d01 + d23) + (d45 + d67),
           (d45 + d67) - (d01 + d23)}};
}

// sum_a gamma_a^m v_a, gamma_a^m = h_a^m - B_a . sum_b h_b^m x_b: 0 for every linear velocity field.
SWARF_FN HexModes hourglass_rates(const HexModes& x, const HexVectors& v, const Tensor3& L) {
  HexModes q = project_modes(v);
  for (int m = 0; m < 4; ++m) q.mode[m] = q.mode[m] - multiply(L, x.mode[m]);
  return q;
}

// Viscous control: generalised force per rate, kappa rho c V^(2/3) / 4.
SWARF_FN Real hourglass_damping(const HexInertia& scaled, Real kappa, Real volume) {
  const Real edge = Kokkos::cbrt(volume);
  return Real(0.25) * kappa * scaled.density * scaled.wave_speed * edge * edge;
}

// Stiffness control: generalised force per displacement; the eigenvalue of an hourglass mode is
// kappa 4 mu V B:B. Of mu only: the modes bend and twist a hex, which takes no more force when it is nearly
// incompressible. A cube's largest eigenvalue is K V B:B: no time step is lost while kappa 4 mu < K, which is
// kappa < 2/3 at nu = 1/3, kappa < 1/6 at nu = 0.
SWARF_FN Real hourglass_stiffness(const Material& mat, Real kappa, Real volume, const HexVectors& B) {
  Real sum = 0;
  for (int a = 0; a < 8; ++a) sum += dot(B.at[a], B.at[a]);
  return Real(0.5) * kappa * mat.shear_modulus * volume * sum;
}

struct HourglassStep {
  bool stiffness;   // else viscous
  Real coefficient; // stiffness or damping
  Tensor3 rotation; // of the material in this step
  Real kept;        // share of a trial stress that the plastic return of the hex left
  Real dt;
};
struct Hourglass {
  HexModes force; // Q^m, N
  Real work;      // of this step, J
};

// Generalised forces at the end of the step. Stiffness control: Q turns with the material, grows by k q dt,
// and returns with the deviator: to first order in what the hourglass adds to the mean stress, J2 flow takes
// the same share of every deviator at right angles to the mean one, so that a flowing hex resists as a fluid
// of viscosity sigma_y / (3 rate), not as the elastic solid. Work: mean of the forces before and after, times
// q dt, as central differences do it.
SWARF_FN Hourglass update_hourglass(const HexModes& before, const HexModes& rate, const HourglassStep& step) {
  Hourglass h{{}, 0};
  for (int m = 0; m < 4; ++m) {
    const Vector3 old = multiply(step.rotation, before.mode[m]), &q = rate.mode[m];
    h.force.mode[m] =
        step.stiffness ? step.kept * (old + (step.coefficient * step.dt) * q) : step.coefficient * q;
    h.work += Real(0.5) * step.dt * dot(old + h.force.mode[m], q);
  }
  return h;
}

SWARF_FN HexModes load_modes(const View<Real* [4][3]>& field, int e) {
  HexModes h;
  for (int m = 0; m < 4; ++m) h.mode[m] = {field(e, m, 0), field(e, m, 1), field(e, m, 2)};
  return h;
}
SWARF_FN void store_modes(const View<Real* [4][3]>& field, int e, const HexModes& h) {
  for (int m = 0; m < 4; ++m)
    field(e, m, 0) = h.mode[m].x, field(e, m, 1) = h.mode[m].y, field(e, m, 2) = h.mode[m].z;
}

// --- time step
// Largest step of central differences, whose damping takes the velocity half a step back, for a mode
// x'' = -damping x' - w2 x: there 4 - 2 dt damping - dt^2 w2 = 0. With w and its share of critical damping
// xi = damping / 2 w it is (2 / w) (sqrt(1 + xi^2) - xi) (Belytschko, Liu & Moran 2000). Either may be zero.
SWARF_FN Real damped_step(Real w2, Real damping) {
  return Real(4) / (damping + Kokkos::sqrt(damping * damping + Real(4) * w2));
}

// Of a free hex, which no mode of a mesh exceeds (Irons & Treharne, 1971). Corners of mass rho V / 8 that
// move by u_a = sigma B_a have w2 strain = (8 / rho) sym(sigma g), g = sum_a B_a B_a^T: for the stress lambda
// tr strain + 2 mu strain at most (8 / rho) (2 mu g_max + lambda tr g) (Flanagan & Belytschko 1984), which is
// 12 K / rho of a unit cube, 4 (lambda + 2 mu) / rho of a flat brick. Damped by the slope of q, a pressure,
// in the same way. It meets the next compression, so b1 counts in expansion too. (Manuals take the secant q /
// rate, half of the quadratic share, which is enough for a rate that alternates about zero, not about a
// shock's.)
struct BulkViscosity {
  Real linear, quadratic; // b1, b2
};
SWARF_FN Real wave_step(const Material& mat, const HexInertia& scaled, const BulkViscosity& q,
                        const HexMoments& g, Real rate) {
  const Real lambda = Kokkos::max(mat.bulk_modulus - Real(2) / Real(3) * mat.shear_modulus, Real(0));
  const Real length = characteristic_length(g), compression = Kokkos::max(-rate, Real(0));
  const Real slope = length * (q.linear * scaled.wave_speed +
                               Real(2) * q.quadratic * q.quadratic * length * compression); // over rho
  return damped_step(Real(8) / scaled.density * (Real(2) * mat.shear_modulus * g.largest + lambda * g.sum),
                     Real(8) * slope * g.sum);
}

// Of the hourglass mode of all hexes of a mesh: sum_a gamma_a h_a = 8, and a node of mass rho V meets 8
// hexes.
SWARF_FN Real hourglass_step(bool stiffness, Real coefficient, Real scaled_mass) {
  const Real eigenvalue = Real(64) * coefficient / scaled_mass;
  return stiffness ? damped_step(eigenvalue, 0) : damped_step(0, eigenvalue);
}

// --- forces
// f_a = -(V sigma . B_a + sum_m gamma_a^m Q^m) = -((V sigma - sum_m Q^m x^m) . B_a + sum_m h_a^m Q^m), N.
SWARF_FN HexVectors corner_forces(const Symmetric3& volume_stress, const HexVectors& B, const HexModes& x,
                                  const HexModes& Q) {
  Tensor3 T = to_tensor(volume_stress);
  for (int m = 0; m < 4; ++m) {
    const Vector3 &h = x.mode[m], &f = Q.mode[m];
    T = T + Tensor3{-f.x * h.x, -f.x * h.y, -f.x * h.z, -f.y * h.x, -f.y * h.y,
                    -f.y * h.z, -f.z * h.x, -f.z * h.y, -f.z * h.z};
  }
  const Vector3 p01 = Q.mode[0] + Q.mode[1], p23 = Q.mode[2] + Q.mode[3];
  const Vector3 m01 = Q.mode[0] - Q.mode[1], m23 = Q.mode[2] - Q.mode[3];
  const HexVectors spread{{p01 + m23, m01 - m23, m23 - p01, Vector3{} - m01 - m23, p23 - p01,
                           Vector3{} - m01 - p23, p01 + p23, m01 - p23}};
  HexVectors f;
  for (int a = 0; a < 8; ++a) f.at[a] = Vector3{} - (multiply(T, B.at[a]) + spread.at[a]);
  return f;
}

} // namespace swarf
