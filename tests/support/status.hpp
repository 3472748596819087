// The fault word of kernels, for tests.
#pragma once
#include "swarf/core/status.hpp"

namespace swarf::test {

inline Status make_status() {
  Status status("status");
  Kokkos::deep_copy(status, no_fault);
  return status;
}

inline unsigned long long read_status(const Status& status) {
  unsigned long long value;
  Kokkos::deep_copy(value, status);
  return value;
}

inline unsigned long long fault_at(Fault fault, unsigned index) {
  return (static_cast<unsigned long long>(fault) << 32) + index;
}

} // namespace swarf::test
