// Puts rows [0, count) of every field in the order of a Z curve, so that the lanes of a pack and the lists of
// neighbours touch memory that is near. Stable: sorted rows stay as they are, which a restart relies on.
#include "z_order.hpp"

namespace swarf {

ZGrid z_grid(const VectorField& position, int rows, Real cell_size) {
  Real x = 0, y = 0, z = 0;
  Kokkos::parallel_reduce(
      "z_grid", Range(0, rows),
      KOKKOS_LAMBDA(int i, Real& mx, Real& my, Real& mz) {
        mx = Kokkos::min(mx, position(i, 0)), my = Kokkos::min(my, position(i, 1)),
        mz = Kokkos::min(mz, position(i, 2));
      },
      Kokkos::Min<Real>(x), Kokkos::Min<Real>(y), Kokkos::Min<Real>(z));
  return {{x, y, z}, cell_size};
}

SortedRows sort_rows(const VectorField& position, int rows, const ZGrid& grid) {
  const View<ZKey*> key(Kokkos::view_alloc(Kokkos::WithoutInitializing, "z_key"), rows);
  const SortedRows sorted{View<ZKey*>(Kokkos::view_alloc(Kokkos::WithoutInitializing, "sorted_z_key"), rows),
                          IndexField(Kokkos::view_alloc(Kokkos::WithoutInitializing, "sorted_row"), rows)};
  Kokkos::parallel_for(
      "z_key", Range(0, rows), KOKKOS_LAMBDA(int i) {
        key(i) = grid.key(load_vector(position, i));
        sorted.row(i) = i;
      });
  Kokkos::sort(
      ExecSpace{}, sorted.row,
      KOKKOS_LAMBDA(int a, int b) { return key(a) < key(b) || (key(a) == key(b) && a < b); });
  Kokkos::parallel_for(
      "sorted_z_key", Range(0, rows), KOKKOS_LAMBDA(int i) { sorted.key(i) = key(sorted.row(i)); });
  return sorted;
}

namespace {

template <class T>
void permute(const View<T*>& field, const IndexField& from) {
  if (field.extent(0) == 0) return;
  const int rows = int(from.extent(0));
  const View<T*> copy(Kokkos::view_alloc(Kokkos::WithoutInitializing, "copy"), rows);
  Kokkos::parallel_for(
      "sort_particles", Range(0, rows), KOKKOS_LAMBDA(int i) { copy(i) = field(from(i)); });
  Kokkos::parallel_for(
      "sort_particles", Range(0, rows), KOKKOS_LAMBDA(int i) { field(i) = copy(i); });
}

template <class T, std::size_t columns>
void permute(const View<T* [columns]>& field, const IndexField& from) {
  if (field.extent(0) == 0) return;
  const int rows = int(from.extent(0));
  const View<T* [columns]> copy(Kokkos::view_alloc(Kokkos::WithoutInitializing, "copy"), rows);
  Kokkos::parallel_for(
      "sort_particles", Range(0, rows), KOKKOS_LAMBDA(int i) {
        for (std::size_t c = 0; c < columns; ++c) copy(i, c) = field(from(i), c);
      });
  Kokkos::parallel_for(
      "sort_particles", Range(0, rows), KOKKOS_LAMBDA(int i) {
        for (std::size_t c = 0; c < columns; ++c) field(i, c) = copy(i, c);
      });
}

} // namespace

void sort_particles(Particles& p, Real cell_size) {
  const SortedRows sorted = sort_rows(p.position, p.count, z_grid(p.position, p.count, cell_size));
  p.for_each_field([&](const char*, auto& field) { permute(field, sorted.row); });
}

} // namespace swarf
