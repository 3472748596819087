// What a flow law gives. A law is a struct of its constants with
//   thermal(T)                    what the temperature makes of it, once a step
//   stress(eps, d, dt, thermal)   flow stress at the plastic strain eps, of which d has come in the step dt
//   elastic_limit(T)              no more than any flow stress at T, without a power or a logarithm
//   first_increment(q, eps, thermal, three_G)   an increment at or above the one that takes the overstress q
// flow_law.hpp lists the laws. Pa, s, K.
#pragma once
#include "swarf/core/types.hpp"

namespace swarf {

struct FlowStress {
  Real value; // Pa
  Real slope; // d value / d plastic strain, at a rate of (plastic strain increment) / dt, Pa
};

} // namespace swarf
