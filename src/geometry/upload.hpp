// Fields filled on the host.
#pragma once
#include "swarf/core/types.hpp"
#include <string>
#include <vector>

namespace swarf {

// A field of `rows` rows; fill(host_field, row) writes each row.
template <class Field, class Fill>
Field upload(const std::string& label, int rows, Fill&& fill) {
  Field field(label, std::size_t(rows));
  auto host = Kokkos::create_mirror_view(field);
  for (int i = 0; i < rows; ++i) fill(host, i);
  Kokkos::deep_copy(field, host);
  return field;
}

inline IndexField upload(const std::string& label, const std::vector<int>& values) {
  return upload<IndexField>(label, int(values.size()),
                            [&](auto& f, int i) { f(i) = values[std::size_t(i)]; });
}

} // namespace swarf
