// What is asked of the values of a checkpoint before they are used.
#pragma once
#include "swarf/core/types.hpp"
#include <cmath>

namespace swarf {

inline bool is_finite(const VectorField& field) {
  const auto x = host_copy(field);
  for (std::size_t i = 0; i < x.extent(0); ++i)
    if (!std::isfinite(x(i, 0)) || !std::isfinite(x(i, 1)) || !std::isfinite(x(i, 2))) return false;
  return true;
}

} // namespace swarf
