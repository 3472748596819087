// Runs a scene to its end or its fault, and looks on the way at what spurious modes leave.
#pragma once
#include "tests/stability/cell.hpp"
#include "tests/verification/point_masses.hpp"

namespace swarf::stability {

using namespace test;

using LatticeIndex = std::array<int, 3>;

// Lines of five neighbours along the first two directions of a lattice. The fourth difference
// (1, -4, 6, -4, 1) / 16 along a line is the amplitude of what alternates from one to the next; of a smooth
// field of wavelength l it leaves (pi a / l)^4. Components x and y only: z is periodic in most scenes.
class Lattice {
 public:
  Lattice() = default;
  // `turn`: how many fit round, of a ring; 0: not closed.
  Lattice(const std::vector<PointState>& at, const std::function<LatticeIndex(const Triple&)>& index,
          int turn = 0);
  double sawtooth(const std::vector<Triple>& field) const; // largest rms of the directions
  bool empty() const { return lines[0].empty(); }

 private:
  std::vector<std::array<std::size_t, 5>> lines[2];
};

// Of a block of which `corner` is a point.
std::function<LatticeIndex(const Triple&)> block_index(const Triple& corner, double spacing);
Triple least_corner(const std::vector<PointState>& at);

class Watch {
 public:
  // After the velocities are set; starts the simulation.
  Watch(Simulation& simulation, double spacing, Lattice lattice = {});
  // Steps to `end`; look() some forty times on the way. A fault ends it.
  void run(double end, const std::function<void()>& look = {});

  Outcome result() const;                  // with energy_residual and sawtooth
  double sawtooth = 0;                     // so far at most, / spacing
  double work() const { return external; } // J, done on the scene up to the last look
  double noise() const { return fastest > 0 ? jitter / fastest : 0; }

 private:
  void look_at_lattice();

  Simulation& simulation;
  Lattice lattice;
  std::vector<PointState> start;
  double spacing, residual = 0, energy = 0, external = 0, jitter = 0, fastest = 0;
  Outcome outcome;
};

// Deterministic, even in [-1, 1], from whole numbers.
double scatter(int a, int b, int c, int d);

} // namespace swarf::stability
