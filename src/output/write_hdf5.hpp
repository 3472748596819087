// HDF5: the history for analysis, and the checkpoint container.
//
// A checkpoint is a set of named arrays and numbers, row-major whatever the layout of the Views, with a
// version, the precision of Real, the physics of the deck and a checksum over every block and all of HDF5's
// own structure. It is written as FILE.tmp and renamed when it is whole: a kill at any moment leaves the one
// before. Every error is a ResultsError that names the file and the dataset; HDF5 itself never prints.
#pragma once
#include "src/files/results.hpp"
#include "swarf/core/types.hpp"

#include <cstdint>
#include <type_traits>

namespace swarf {

struct HistoryTable;

// /history/<column> and /history/<column>_filtered, extendible, chunked, each with the attribute `units`.
void write_history_hdf5(const std::filesystem::path& file, const HistoryTable& raw,
                        const HistoryTable& filtered);

inline constexpr int checkpoint_version = 8;

enum class NumberType { float32, float64, int32, uint32, int64, uint64 };

template <class T>
constexpr NumberType number_type() {
  static_assert(std::is_arithmetic_v<T> && !std::is_same_v<T, bool> && sizeof(T) >= 4,
                "float, double or integers");
  if constexpr (std::is_floating_point_v<T>)
    return sizeof(T) == 4 ? NumberType::float32 : NumberType::float64;
  else if constexpr (std::is_signed_v<T>)
    return sizeof(T) == 4 ? NumberType::int32 : NumberType::int64;
  else
    return sizeof(T) == 4 ? NumberType::uint32 : NumberType::uint64;
}

using Extents = std::vector<std::uint64_t>;

template <class V>
using RowMajor = Kokkos::View<typename V::non_const_data_type, Kokkos::LayoutRight, Kokkos::HostSpace>;

template <class V>
RowMajor<V> make_row_major(const Extents& shape) {
  Kokkos::LayoutRight layout;
  for (std::size_t r = 0; r < V::rank; ++r) layout.dimension[r] = shape[r];
  return RowMajor<V>(Kokkos::view_alloc(Kokkos::WithoutInitializing, "checkpoint"), layout);
}

// An open HDF5 file (hid_t), closed at the end of its life.
struct Hdf5File {
  std::int64_t id = -1;
  Hdf5File() = default;
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;
  ~Hdf5File() { close(); }
  bool close(); // false if what was left to write could not be written
};

class CheckpointWriter {
 public:
  CheckpointWriter(const std::filesystem::path& file, const std::string& deck);
  ~CheckpointWriter(); // without finish(): the checkpoint before stays
  CheckpointWriter(const CheckpointWriter&) = delete;
  CheckpointWriter& operator=(const CheckpointWriter&) = delete;

  // name is a path: "particles/position". Fields may live on the device.
  template <class Data, class... Properties>
  void put(const std::string& name, const Kokkos::View<Data, Properties...>& view) {
    using V = Kokkos::View<Data, Properties...>;
    Extents shape;
    for (std::size_t r = 0; r < V::rank; ++r) shape.push_back(view.extent(r));
    const auto rows = make_row_major<V>(shape);
    Kokkos::deep_copy(rows, Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view));
    write(name, rows.data(), number_type<typename V::non_const_value_type>(), shape);
  }
  template <class T>
  void put(const std::string& name, const std::vector<T>& values) {
    write(name, values.data(), number_type<T>(), {values.size()});
  }
  template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>>
  void put(const std::string& name, T value) {
    write(name, &value, number_type<T>(), {1});
  }
  // Marks the file complete, flushes it to the disk and puts it in the place of the one before.
  void finish();

 private:
  void write(const std::string& name, const void* data, NumberType type, const Extents& shape);
  [[noreturn]] void fail(const std::string& what);
  std::filesystem::path name_of_file;
  Hdf5File file;
};

class CheckpointReader {
 public:
  static constexpr std::uint64_t any = ~std::uint64_t{0};
  // Checks that the file is whole, of this version and of this precision.
  explicit CheckpointReader(const std::filesystem::path& file);

  const std::string& deck() const { return deck_text; }
  // Throws ResultsError where what `name` holds cannot be.
  void require(bool is_possible, const std::string& name) const;
  bool has(const std::string& name) const;
  Extents shape(const std::string& name) const;

  // Resizes the view to the stored rows; what the View's type fixes must agree, and the rows where they are
  // given: nothing is allocated before.
  template <class Data, class... Properties>
  void get(const std::string& name, Kokkos::View<Data, Properties...>& view, std::uint64_t rows = any) const {
    using V = Kokkos::View<Data, Properties...>;
    Extents fixed;
    for (std::size_t r = 0; r < V::rank; ++r)
      fixed.push_back(r == 0 ? rows : r < V::rank_dynamic ? any : view.static_extent(r));
    const Extents found = check(name, number_type<typename V::non_const_value_type>(), fixed);
    const auto stored = make_row_major<V>(found);
    read(name, stored.data(), number_type<typename V::non_const_value_type>());
    typename V::array_layout layout;
    for (std::size_t r = 0; r < V::rank; ++r) layout.dimension[r] = found[r];
    Kokkos::realloc(view, layout);
    const auto mirror = Kokkos::create_mirror_view(Kokkos::HostSpace{}, view);
    Kokkos::deep_copy(mirror, stored);
    Kokkos::deep_copy(view, mirror);
  }
  template <class T>
  void get(const std::string& name, std::vector<T>& values, std::uint64_t count = any) const {
    values.resize(check(name, number_type<T>(), {count})[0]);
    read(name, values.data(), number_type<T>());
  }
  template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>>
  void get(const std::string& name, T& value) const {
    check(name, number_type<T>(), {1});
    read(name, &value, number_type<T>());
  }

 private:
  Extents check(const std::string& name, NumberType type, const Extents& expected) const; // the stored shape
  void read(const std::string& name, void* data, NumberType type) const;
  [[noreturn]] void fail(const std::string& what) const;
  std::filesystem::path name_of_file;
  Hdf5File file;
  std::string deck_text;
};

} // namespace swarf
