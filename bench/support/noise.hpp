// Repeatable numbers in [-1, 1), by row and channel, the same on every number of threads.
#pragma once
#include "swarf/core/types.hpp"

namespace swarf::bench {

struct Noise {
  unsigned row;
  KOKKOS_INLINE_FUNCTION Real operator()(unsigned channel) const {
    unsigned long long h = (static_cast<unsigned long long>(row) << 8 | channel) * 0x9e3779b97f4a7c15ULL;
    h ^= h >> 32, h *= 0xd6e8feb86659fd93ULL, h ^= h >> 32; // a multiplicative hash, twice
    return Real(double(h >> 12) / double(1ULL << 51) - 1);
  }
};

} // namespace swarf::bench
