#include "src/scene/convert_hexes.hpp"
#include "src/geometry/upload.hpp"
#include "src/scene/hex_conversion.hpp"
#include <algorithm>
#include <cmath>
#include <map>

namespace swarf {
namespace {

using Cell = ConversionLayout::Cell;

std::vector<bool> converted_hexes(const Scene& scene) {
  const auto active = host_copy(scene.hexes.active);
  std::vector<bool> converted(std::size_t(scene.hexes.points.count), false);
  for (std::size_t e = 0; e < converted.size(); ++e) converted[e] = active(int(e)) == hex_deleted;
  return converted;
}

void set_counts(Particles& p, int free, int tied) {
  p.count = p.whole = free, p.tied = tied;
  p.points.count = p.listed = p.stored = p.total = free + tied;
}

// --- what follows from the layout alone
void set_tie(Scene& scene, const ConversionLayout& layout) {
  const HexConversion& of = *scene.conversion;
  std::vector<TiedPoint> points;
  for (const Cell& c : layout.tied) {
    TiedPoint point;
    point.host = c.hex;
    point.shape = HexConversion::shape(of.lattice[std::size_t(of.body[std::size_t(c.hex)])].n, c.cell);
    points.push_back(point);
  }
  scene.tie = make_tie(points, scene.hexes);
  const int first = scene.particles.count;
  scene.tie.row = upload<IndexField>("tie.row", scene.tie.count, [&](auto& f, int k) { f(k) = first + k; });
}

template <class Field>
void set_values(const Field& field, const std::vector<double>& values) {
  const auto host = Kokkos::create_mirror_view(field);
  for (std::size_t i = 0; i < values.size(); ++i) host(i) = Real(values[i]);
  Kokkos::deep_copy(field, host);
}

// A node without hexes is at rest for good.
void set_mesh(const Deck& deck, Scene& scene, const ConversionLayout& layout) {
  const HexConversion& of = *scene.conversion;
  HexMesh& m = scene.hexes;
  set_values(m.share, layout.share), set_values(m.mass, layout.node_mass);
  set_values(m.contact_area, layout.contact_area);
  const auto bits = host_copy(m.constraints);
  const auto v = host_copy(m.velocity), friction = host_copy(m.friction_force),
             contact = host_copy(m.contact_force);
  const auto energy = host_copy(m.contact_energy);
  for (int a = 0; a < m.nodes; ++a) {
    if (layout.contact_area[std::size_t(a)] == 0)
      store_vector(friction, a, {0, 0, 0}), store_vector(contact, a, {0, 0, 0}), energy(a) = 0;
    if (layout.node_mass[std::size_t(a)] > 0) continue;
    bits(a) |= held_bit;
    store_vector(v, a, {0, 0, 0});
  }
  Kokkos::deep_copy(m.constraints, bits), Kokkos::deep_copy(m.velocity, v);
  Kokkos::deep_copy(m.friction_force, friction), Kokkos::deep_copy(m.contact_force, contact);
  Kokkos::deep_copy(m.contact_energy, energy);
  const auto capacity = host_copy(m.heat_capacity); // of a node without hexes: as it was
  for (std::size_t e = 0; e < of.hex.size(); ++e)
    for (int node : of.hex[e])
      if (const double mass = layout.node_mass[std::size_t(node)]; mass > 0) {
        const int material = of.lattice[std::size_t(of.body[e])].material;
        capacity(node) = Real(mass * deck.materials[std::size_t(material)].specific_heat.value);
      }
  Kokkos::deep_copy(m.heat_capacity, capacity);
}

// --- rows
template <class Field>
void copy_rows(const Field& to, const Field& from, const std::vector<int>& source) {
  if (from.extent(0) == 0 || to.extent(0) == 0) return;
  const auto old = host_copy(from), host = host_copy(to);
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (source[i] < 0) continue;
    if constexpr (Field::rank == 1)
      host(i) = old(source[i]);
    else
      for (std::size_t c = 0; c < Field::static_extent(1); ++c) host(i, c) = old(source[i], c);
  }
  Kokkos::deep_copy(to, host);
}

// Particles of which row i was row source[i], or is new.
Particles take_rows(const Deck& deck, const Particles& from, const std::vector<int>& source) {
  Particles to = from; // the same Views, until each field gets its own
  for_each_field(to, [&](const char* name, auto& field, auto facts) {
    const auto old = field;
    allocate(field, name, facts, deck, int(source.size()));
    if (facts.life == Life::history) copy_rows(field, old, source);
  });
  return to;
}

// --- the hand-over
struct HostPoints { // on the host, of particles or hexes
  explicit HostPoints(const MaterialPoints& p)
      : on_device(p), mass(host_copy(p.mass)), density(host_copy(p.density)),
        plastic_strain(host_copy(p.equivalent_plastic_strain)), rate(host_copy(p.plastic_strain_rate)),
        temperature(host_copy(p.temperature)), stress_temperature(host_copy(p.stress_temperature)),
        damage(host_copy(p.damage)), internal_work(host_copy(p.internal_work)),
        plastic_work(host_copy(p.plastic_work)), stress(host_copy(p.stress)),
        L(host_copy(p.velocity_gradient)), material(host_copy(p.material)) {}
  void copy_back() const {
    const MaterialPoints& p = on_device;
    Kokkos::deep_copy(p.mass, mass), Kokkos::deep_copy(p.density, density);
    Kokkos::deep_copy(p.equivalent_plastic_strain, plastic_strain);
    Kokkos::deep_copy(p.plastic_strain_rate, rate), Kokkos::deep_copy(p.temperature, temperature);
    Kokkos::deep_copy(p.stress_temperature, stress_temperature);
    Kokkos::deep_copy(p.damage, damage), Kokkos::deep_copy(p.internal_work, internal_work);
    Kokkos::deep_copy(p.plastic_work, plastic_work), Kokkos::deep_copy(p.stress, stress);
    Kokkos::deep_copy(p.velocity_gradient, L), Kokkos::deep_copy(p.material, material);
  }
  template <class Field>
  using Mirror = decltype(host_copy(std::declval<Field>()));
  using Scalars = Mirror<ScalarField>;
  MaterialPoints on_device;
  Scalars mass, density, plastic_strain, rate, temperature, stress_temperature, damage, internal_work,
      plastic_work;
  Mirror<SymmetricField> stress;
  Mirror<TensorField> L;
  Mirror<IndexField> material;
};

// Heats are counted from the temperature of the nodes where these hold the heat (gather_heat.cpp), else
// from 0 K.
struct BaseTemperature {
  double particle = 0, hex = 0;
};

// A particle takes the mass up to `mass` from a hex, which had `hex_mass`, and the hex's state with it.
struct TakeOver {
  int particle, hex;
  double mass, hex_mass; // kg
  BaseTemperature base;
};
void take_over(const HostPoints& p, const HostPoints& hex, const TakeOver& what) {
  const int i = what.particle, e = what.hex;
  const double mass = what.mass, hex_mass = what.hex_mass;
  const BaseTemperature& base = what.base;
  const double own = double(p.mass(i)), more = mass - own;
  p.mass(i) = Real(mass);
  if (more <= 0 || hex_mass <= 0) return;
  const double own_volume = own > 0 ? own / double(p.density(i)) : 0, volume = more / double(hex.density(e));
  const auto mix = [&](const HostPoints::Scalars& to, const HostPoints::Scalars& from) {
    to(i) = Real((own * double(to(i)) + more * double(from(e))) / mass);
  };
  mix(p.plastic_strain, hex.plastic_strain), mix(p.rate, hex.rate), mix(p.damage, hex.damage);
  for (int c = 0; c < 6; ++c)
    p.stress(i, c) = Real((own_volume * double(p.stress(i, c)) + volume * double(hex.stress(e, c))) /
                          (own_volume + volume));
  for (int c = 0; c < 9; ++c) p.L(i, c) = hex.L(e, c);
  p.density(i) = Real(mass / (own_volume + volume));
  const auto mix_heat = [&](const HostPoints::Scalars& to, const HostPoints::Scalars& from) {
    const double own_heat = own > 0 ? own * (double(to(i)) - base.particle) : 0;
    to(i) = Real(base.particle + (own_heat + more * (double(from(e)) - base.hex)) / mass);
  };
  mix_heat(p.temperature, hex.temperature);
  if (p.stress_temperature.extent(0) > 0) mix_heat(p.stress_temperature, hex.stress_temperature);
  p.internal_work(i) += Real(more / hex_mass * double(hex.internal_work(e)));
  p.plastic_work(i) += Real(more / hex_mass * double(hex.plastic_work(e)));
  p.material(i) = hex.material(e);
}

// The cells that rows of particles belong to, and the rows that they had.
struct Rows {
  std::vector<Cell> cell; // of rows first, first + 1, ...
  std::vector<int> source;
  int first = 0, free = 0;
};

Rows list_rows(const Scene& scene, const ConversionLayout& layout, const std::vector<bool>& is_new) {
  Rows rows;
  rows.first = scene.particles.count;
  for (const Cell& c : layout.free)
    if (is_new[std::size_t(c.hex)]) rows.cell.push_back(c);
  rows.free = rows.first + int(rows.cell.size());
  rows.cell.insert(rows.cell.end(), layout.tied.begin(), layout.tied.end());
  for (int i = 0; i < rows.first; ++i) rows.source.push_back(i);
  std::map<std::pair<int, int>, int> row_of; // of a cell that was tied
  if (scene.layout)
    for (const Cell& c : scene.layout->tied)
      row_of.emplace(std::pair(c.hex, c.cell), rows.first + int(row_of.size()));
  for (const Cell& c : rows.cell) {
    const auto at = row_of.find({c.hex, c.cell});
    rows.source.push_back(at == row_of.end() ? -1 : at->second);
  }
  return rows;
}

// What is fixed when a particle is made, and its place and velocity.
void set_new_rows(const Deck& deck, const Scene& scene, Particles& p, const Rows& rows) {
  const HexConversion& of = *scene.conversion;
  const auto node_x = host_copy(scene.hexes.position), node_v = host_copy(scene.hexes.velocity);
  const auto x = host_copy(p.position), v = host_copy(p.velocity), impedance = host_copy(p.impedance);
  const auto inverse_support = host_copy(p.inverse_support), gap = host_copy(p.contact_gap),
             area = host_copy(p.contact_area), volume = host_copy(p.volume), mass = host_copy(p.points.mass),
             density = host_copy(p.points.density);
  const auto body = host_copy(p.body), identity = host_copy(p.identity);
  for (int k = 0; k < int(rows.cell.size()); ++k) {
    const Cell& c = rows.cell[std::size_t(k)];
    const int i = rows.first + k, row = of.body[std::size_t(c.hex)];
    const HexConversion::Lattice& lattice = of.lattice[std::size_t(row)];
    const Material material = make_material(deck.materials[std::size_t(lattice.material)]);
    identity(i) = i, body(i) = row;
    volume(i) = mass(i) / density(i);
    gap(i) = Real(of.gap[std::size_t(c.hex)]);
    area(i) = i < rows.free ? Real(std::pow(double(volume(i)), 2.0 / 3.0)) : Real(0);
    const Real scaled = Real(deck.run.mass_factor) * density(i);
    const bool is_new = rows.source[std::size_t(i)] < 0;
    if (is_new) inverse_support(i) = Real(0.5 / (deck.particles.smoothing_ratio * lattice.spacing));
    if (deck.particles.smoothing_length == SmoothingLength::evolving)
      inverse_support(i) *= std::cbrt(is_new ? density(i) / material.density : scaled / impedance(i, 1));
    impedance(i, 0) = scaled * longitudinal_wave_speed(material) / Real(std::sqrt(deck.run.mass_factor));
    impedance(i, 1) = scaled, impedance(i, 2) = material.shear_modulus;
    const auto N = HexConversion::shape(lattice.n, c.cell);
    Vector3 place{0, 0, 0}, velocity{0, 0, 0};
    for (std::size_t a = 0; a < 8; ++a) {
      const int node = of.hex[std::size_t(c.hex)][a];
      place = place + Real(N[a]) * load_vector(node_x, node);
      velocity = velocity + Real(N[a]) * load_vector(node_v, node);
    }
    store_vector(x, i, place), store_vector(v, i, velocity);
  }
  Kokkos::deep_copy(p.position, x), Kokkos::deep_copy(p.velocity, v), Kokkos::deep_copy(p.volume, volume);
  Kokkos::deep_copy(p.inverse_support, inverse_support), Kokkos::deep_copy(p.impedance, impedance);
  Kokkos::deep_copy(p.contact_gap, gap), Kokkos::deep_copy(p.contact_area, area);
  Kokkos::deep_copy(p.body, body), Kokkos::deep_copy(p.identity, identity);
}

// From the hexes to the particles of the cells.
void hand_over(const Scene& scene, const Particles& p, const Rows& rows, const ConversionLayout& layout) {
  const HexConversion& of = *scene.conversion;
  const HexMesh& m = scene.hexes;
  const HostPoints points(p.points), hexes(m.points);
  const bool conducts = m.nodal_temperature.extent(0) > 0;
  const auto T = host_copy(m.nodal_temperature);
  std::vector<double> hex_mass;
  for (int e = 0; e < m.points.count; ++e) hex_mass.push_back(double(hexes.mass(e)));
  for (int k = 0; k < int(rows.cell.size()); ++k) {
    const Cell& c = rows.cell[std::size_t(k)];
    const auto N = HexConversion::shape(of.lattice[std::size_t(of.body[std::size_t(c.hex)])].n, c.cell);
    BaseTemperature base;
    for (std::size_t a = 0; conducts && a < 8; ++a) {
      const double T_a = double(T(of.hex[std::size_t(c.hex)][a]));
      base.particle += N[a] * T_a, base.hex += T_a / 8;
    }
    const double mass = c.weight * of.mass[std::size_t(c.hex)] / of.cells_of(c.hex);
    take_over(points, hexes, {rows.first + k, c.hex, mass, hex_mass[std::size_t(c.hex)], base});
  }
  for (int e = 0; e < m.points.count; ++e) {
    hexes.mass(e) = Real(layout.share[std::size_t(e)] * of.mass[std::size_t(e)]);
    if (hex_mass[std::size_t(e)] == 0) continue;
    const double left = double(hexes.mass(e)) / hex_mass[std::size_t(e)];
    hexes.internal_work(e) *= Real(left), hexes.plastic_work(e) *= Real(left);
  }
  points.copy_back(), hexes.copy_back();
}

// Nothing is left of these hexes.
void clear(const HexMesh& m, const std::vector<int>& chosen) {
  const HostPoints hexes(m.points);
  const auto active = host_copy(m.active);
  const auto hourglass = host_copy(m.hourglass);
  for (const int e : chosen) {
    active(e) = hex_deleted;
    hexes.plastic_strain(e) = hexes.rate(e) = hexes.damage(e) = 0;
    for (int c = 0; c < 6; ++c) hexes.stress(e, c) = 0;
    for (int c = 0; c < 9; ++c) hexes.L(e, c) = 0;
    for (int k = 0; k < 4; ++k)
      for (int d = 0; d < 3; ++d) hourglass(e, k, d) = 0;
  }
  hexes.copy_back();
  Kokkos::deep_copy(m.active, active), Kokkos::deep_copy(m.hourglass, hourglass);
}

} // namespace

void convert_hexes(const Deck& deck, Scene& scene, const std::vector<int>& chosen) {
  std::vector<bool> converted = converted_hexes(scene), is_new(converted.size(), false);
  for (const int e : chosen) converted[std::size_t(e)] = is_new[std::size_t(e)] = true;
  const auto layout = std::make_shared<const ConversionLayout>(lay_out(*scene.conversion, converted));
  const Rows rows = list_rows(scene, *layout, is_new);
  Particles next = take_rows(deck, scene.particles, rows.source);
  set_counts(next, rows.free, int(layout->tied.size()));
  hand_over(scene, next, rows, *layout);
  set_new_rows(deck, scene, next, rows);
  scene.particles = next;
  clear(scene.hexes, chosen);
  set_tie(scene, *layout), set_mesh(deck, scene, *layout);
  scene.layout = layout;
}

bool restore_conversion(const Deck& deck, Scene& scene, const ParticleCounts& counts) {
  const auto layout =
      std::make_shared<const ConversionLayout>(lay_out(*scene.conversion, converted_hexes(scene)));
  if (int(layout->free.size()) != counts.free || int(layout->tied.size()) != counts.tied) return false;
  scene.particles = allocate_particles(deck, counts.free + counts.tied);
  set_counts(scene.particles, counts.free, counts.tied);
  set_tie(scene, *layout), set_mesh(deck, scene, *layout);
  scene.layout = layout;
  return true;
}

} // namespace swarf
