// One step of a block of hexes, for tests.
#pragma once
#include "swarf/kernels.hpp"

#include "support/hex_block.hpp"
#include "support/status.hpp"

#include <gtest/gtest.h>

namespace swarf::test {

// Velocity gradient, stress and forces from positions and velocities; a fault fails the test.
inline void compute_forces(const HexMesh& mesh, const Material& mat, const HexMethod& method, Real dt) {
  const Status status = make_status();
  const MaterialTable table = make_material_table({mat});
  hex_velocity_gradient(mesh, status);
  update_stress(mesh.points, table, dt, status);
  hex_forces(mesh, table, method, dt);
  gather_corner_forces(mesh);
  EXPECT_EQ(read_status(status), no_fault);
}

inline Motion motion_of(const HexMesh& m) {
  return {m.nodes, m.position, m.velocity, m.force, m.mass, m.external_work, m.constraints, {}};
}

struct Surroundings {
  Vector3 gravity{0, 0, 0};
  ConstraintTable constraints{"constraints", 1};
};

inline void step_hexes(const HexMesh& mesh, const Material& mat, const HexMethod& method,
                       const Surroundings& around, Real dt) {
  const Real half = Real(0.5) * dt;
  kick(motion_of(mesh), around.constraints, around.gravity, method.mass_factor, half);
  drift(motion_of(mesh), dt);
  compute_forces(mesh, mat, method, dt);
  kick(motion_of(mesh), around.constraints, around.gravity, method.mass_factor, half);
}

} // namespace swarf::test
