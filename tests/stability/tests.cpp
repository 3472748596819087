// The columns.
#include "tests/stability/cell.hpp"

namespace swarf::stability {
namespace {

const char* const pairing =
    "The velocity gradient does not see neighbours that move in pairs, and tension drives them. A "
    "stiffness against what the gradient does not see holds it if it is larger than the tension's drive. "
    "Kernels of the initial positions have no such mode.";

}

const std::vector<Test>& tests() {
  static const std::vector<Test> all = {
      {"rings", "tension: ring", "a rubber ring meets a wall at 0.059 c0, 4 cells thick", pairing,
       Kind::elastic, false, collide_ring},
      {"strip", "tension: strip", "an elastic strip pulled by 20 %, 24 x 8 cells", pairing, Kind::elastic,
       false, pull_strip},
      {"plate", "bending: plate", "a clamped plate, 40 x 4 cells, its tip started at 0.05 c0, one period",
       pairing, Kind::elastic, false, bend_plate},
      {"zero_energy", "zero-energy mode",
       "a checkerboard in an endless block, without viscosity of shocks: of velocities, 1e-3 c; and driven "
       "to a "
       "twentieth of the spacing and let go",
       "No velocity gradient in one point sees it. A viscosity only slows it down; what holds it has a "
       "stiffness.",
       Kind::elastic, false, shake_block},
      {"rotation", "large rotation", "a free plate, 16 x 16 cells, spins by 360 deg",
       "Plain sums see a strain in the rotation of a body with a surface. Where the corrected gradient is "
       "used, what "
       "grows is the pairing in the tension of the spin.",
       Kind::elastic, false, spin_plate},
      {"disorder", "disorder", "a plate of 12 x 12 points a fifth of a spacing off their lattice vibrates",
       "On a lattice out of order sums of first order make noise that only the viscosity damps.",
       Kind::elastic, false, disturb_lattice},
      {"contact", "contact, fast",
       "a block meets a wall obliquely at 60 m/s, ten times the verification's speed, friction 0.5",
       "The tool is rigid and meets single particles: the penalty must not make energy.", Kind::elastic,
       false, hit_wall},
      {"lone", "lone particle", "one particle leaves the others at half the speed of waves",
       "The correction changes within a step as neighbours leave: the residual is of first order in the "
       "step.",
       Kind::elastic, true, lose_particle},
      {"scale", "scale", "a block meets a wall, plastic, with friction; cells of 1 mm, 1 um, 60 nm, 1 nm", "",
       Kind::elastic, false, scale_scene},
      {"courant", "time step", "a cube shaken at random, Courant number 0.3 to 1.2", "", Kind::elastic, false,
       raise_courant},
      {"mass", "mass factor", "a block of the cut squeezed by 10 % at 0.5 m/s, mass factor 1 to 1e6",
       "The viscosity grows with the root of the mass factor, and what damps modes of the lattice with it.",
       Kind::plastic, false, raise_mass},
      {"viscosity", "viscosity",
       "the same under mass factor 1e4, linear viscosity 0 to 2, the quadratic one twice that; and the time "
       "step at 2",
       "Particles: as under the mass factor; it acts only where the velocity is not linear. "
       "The stable step takes the viscosity into account: Courant numbers mean as much with it as without.",
       Kind::plastic, false, raise_viscosity},
      {"pull_metal", "plastic tension",
       "a strip of metal that hardens enough to stretch evenly, pulled by 50 %, 24 x 8 cells",
       "Pairing, as in the elastic strip: shifting delays it, the more the faster it flows.", Kind::plastic,
       false, pull_metal},
      {"shear_metal", "shear to 10",
       "a layer between two plates sheared by ten times its height, linear hardening, from a lattice a fifth "
       "of "
       "a spacing out of order",
       "Rows that pass one another out of order gather in strings, which slide without any strain that the "
       "gradient sees.",
       Kind::plastic, false, shear_metal},
      {"cut", "large shear: cut", "orthogonal cutting, 30 m/min, 40 um deep, cells of 10 um, 150 um of cut",
       "Particles: pressures alternate from neighbour to neighbour; the forces do not notice. Hexes: where "
       "none is "
       "deleted they are crushed and make energy; where they are, so is the chip, and the tool cuts little.",
       Kind::cut, false, stability::cut},
      {"cut_fast", "cut, ten times as fast", "the same at 300 m/min, under the same mass factor",
       "As at the lower speed.", Kind::cut, false, cut_fast},
      {"voids", "chip's voids",
       "the cut at 30 m/min with six cells of 6.7 um across, 120 um of it; where the plastic strain is more "
       "than "
       "0.3, worst of the last quarter",
       "As in the sheared layer.", Kind::cut, true, fill_chip},
  };
  return all;
}

} // namespace swarf::stability
