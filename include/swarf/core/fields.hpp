// What the tables of fields (material.hpp, particles.hpp, hex_mesh.hpp) say of a field. A row is
//   visit("name", field, Facts<named...>());
// with facts of the kinds below in any order; of a kind that is not named, the first one holds. Allocation,
// sorting, freezing, checkpoints, ghosts, periodic wraps and conversion follow from the rows.
#pragma once
#include "swarf/core/transform.hpp"
#include <type_traits>

namespace swarf {

// What a turned frame x' = R x + t makes of it.
enum class Frame {
  scalar,            // nothing: every column is a number of its own
  point,             // R x + t
  vector,            // R v; of fields with three indices, each of several vectors
  symmetric,         // R A R^T of the symmetric part of A, in 6 columns or in 9
  tensor,            // R A R^T
  scalar_and_vector, // a number, then a vector
};

enum class Life {
  derived, // made again by the step, or by the scene: only allocated
  pair,    // made again for rows that are active, read from their neighbours: frozen rows keep it
  history, // of the row for good: goes where it goes, and into checkpoints
};

// When ghosts take it from the row that they are ghosts of. More than one may be named.
enum class Ghosts {
  when_made,
  after_drift,
  before_forces,
  in_diffuse_pressure,
  in_conduct_heat,
  in_find_shifts,
  in_highest_mode,
  in_surface_gradient,
  in_surface_stress,
};

// What it is there for; without it, it has 0 rows.
enum class Method {
  always,
  with_body_contact,
  with_conduction,
  with_face_heat,
  with_heat_tables,
  with_hourglass_stiffness,
  with_initial_frame,
  with_pressure_diffusion,
  with_shifting,
  with_freeze,
  with_summation,
  with_surface_gradient,
  with_thermal_stress,
  with_tool,
  with_tool_heat,
};

// Particles are elements, like hexes.
enum class Per { per_element, per_node };

// Whether a particle that is shifted takes the value at its new place, and of what the sum over all is kept.
enum class Shifting {
  stays,
  transported,
  keeps_mass_sum, // sum of mass times the value
  keeps_heat_sum, // sum of heat capacity times the value
};

template <class Kind, auto... named>
constexpr Kind fact_of() {
  static_assert((0 + ... + int(std::is_same_v<decltype(named), Kind>)) <= 1, "one fact of this kind");
  return Kind((0 + ... + (std::is_same_v<decltype(named), Kind> ? int(named) : 0)));
}

template <auto... named>
struct Facts {
  static constexpr Frame frame = fact_of<Frame, named...>();
  static constexpr Life life = fact_of<Life, named...>();
  static constexpr Method method = fact_of<Method, named...>();
  static constexpr Per per = fact_of<Per, named...>();
  static constexpr Shifting shifting = fact_of<Shifting, named...>();
  static constexpr bool on_ghosts = (std::is_same_v<decltype(named), Ghosts> || ...);
  static constexpr bool on_ghosts_at(Ghosts when) {
    return ((std::is_same_v<decltype(named), Ghosts> && int(named) == int(when)) || ...);
  }
};

// Calls visit("name", field, Facts<...>()) for each row of the table of a struct of fields; on a const one
// also on the device.
template <class Fields, class Visit>
SWARF_FN void for_each_field(Fields& fields, const Visit& visit) {
  Fields::list_fields(fields, visit);
}

// Whether the run has the field; known when compiled where every run has it.
template <class Field, auto... named>
SWARF_FN bool has_rows(const Field& f, Facts<named...> facts) {
  return facts.method == Method::always || f.extent(0) > 0;
}

// Row `to` of a field becomes what row `from` is in a turned frame.
template <class Field, auto... named>
SWARF_FN void copy_turned(const Field& f, int from, int to, const Transform& map, Facts<named...> facts) {
  const Tensor3& R = map.R;
  if constexpr (facts.frame == Frame::point)
    store_vector(f, to, apply(map, load_vector(f, from)));
  else if constexpr (facts.frame == Frame::vector)
    store_vector(f, to, multiply(R, load_vector(f, from)));
  else if constexpr (facts.frame == Frame::symmetric && Field::static_extent(1) == 6)
    store_symmetric(f, to, rotate(R, load_symmetric(f, from)));
  else if constexpr (facts.frame == Frame::symmetric)
    store_tensor(f, to, to_tensor(rotate(R, symmetric_part(load_tensor(f, from)))));
  else if constexpr (facts.frame == Frame::tensor) {
    const Tensor3 A = load_tensor(f, from);
    store_tensor(f, to, multiply(multiply(R, A), transpose(R)));
  } else if constexpr (facts.frame == Frame::scalar_and_vector) {
    const Vector3 v = multiply(R, Vector3{f(from, 1), f(from, 2), f(from, 3)});
    f(to, 0) = f(from, 0), f(to, 1) = v.x, f(to, 2) = v.y, f(to, 3) = v.z;
  } else if constexpr (Field::rank == 1)
    f(to) = f(from);
  else
    for (int c = 0; c < int(Field::static_extent(1)); ++c) f(to, c) = f(from, c);
}

} // namespace swarf
