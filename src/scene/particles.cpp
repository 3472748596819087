#include "src/geometry/upload.hpp"
#include "src/scene/parts.hpp"
#include <bit>
#include <cmath>

namespace swarf {
namespace {

// A row of the particles' fields, wherever it comes from.
struct Row {
  const FilledBody* body;
  Point position;
  double volume, gap;
  double temperature; // a tied particle has that of its hex
  int material;
  bool is_tied;
};

std::vector<Row> list_rows(const std::vector<FilledBody>& bodies, const std::vector<TiedPoint>& tied) {
  std::vector<Row> rows;
  for (const FilledBody& b : bodies)
    for (std::size_t i = 0; i < b.points.position.size(); ++i)
      rows.push_back({&b, b.points.position[i], b.points.volume[i], b.points.gap[i], b.deck->temperature,
                      b.material, false});
  for (const TiedPoint& p : tied) {
    const FilledBody& body = bodies[std::size_t(p.body)];
    const auto host = std::find_if(bodies.begin(), bodies.end(), [&](const FilledBody& b) {
      return !b.has_particles() && p.host >= b.first_hex && p.host < b.first_hex + int(b.hexes.hex.size());
    });
    rows.push_back({&body, p.position, p.volume, 0, host->deck->temperature, host->material, true});
  }
  return rows;
}

} // namespace

std::vector<int> particle_rows(const Particles& p) {
  const auto identity = host_copy(p.identity);
  std::vector<int> rows;
  for (int i = 0; i < p.stored; ++i)
    if (identity(i) < p.whole) rows.push_back(i);
  return rows;
}

bool uses(const Deck& deck, Method method) {
  const ParticlesDeck& set = deck.particles;
  const bool initial = set.kernel_frame == KernelFrame::initial;
  switch (method) {
  case Method::always:
    return true;
  case Method::with_body_contact:
    return can_meet(deck);
  case Method::with_conduction:
    return conducts_heat(deck);
  case Method::with_face_heat:
    return heats_faces(deck);
  case Method::with_heat_tables:
    return std::any_of(deck.materials.begin(), deck.materials.end(),
                       [](const MaterialDeck& m) { return !m.specific_heat.points.empty(); });
  case Method::with_hourglass_stiffness:
    return set.hourglass_stiffness > 0 && !initial;
  case Method::with_initial_frame:
    return initial;
  case Method::with_pressure_diffusion:
    return set.pressure_diffusion > 0;
  case Method::with_shifting:
    return set.shifting && !initial;
  case Method::with_freeze:
    return bool(deck.sleep.distance);
  case Method::with_summation:
    return set.density == DensityRule::summation;
  case Method::with_surface_gradient:
    return set.correction && set.correct_forces;
  case Method::with_thermal_stress:
    return stress_knows_heat(deck);
  case Method::with_tool:
    return deck.tool.has_value();
  case Method::with_tool_heat:
    return deck.tool && !deck.tool->material.empty();
  }
  return false;
}

Particles allocate_particles(const Deck& deck, int rows) {
  Particles p;
  for_each_field(
      p, [&](const char* name, auto& field, auto facts) { allocate(field, name, facts, deck, rows); });
  return p;
}

Particles make_particles(const Deck& deck, const std::vector<FilledBody>& bodies,
                         const std::vector<TiedPoint>& tied, const Faces& faces) {
  const std::vector<Row> rows = list_rows(bodies, tied);
  const int n = int(rows.size());
  Particles p = allocate_particles(deck, n); // what is left zero is derived or history
  p.tied = int(tied.size());
  p.count = n - p.tied;
  p.points.count = n;
  p.listed = p.stored = p.total = n;
  p.whole = p.count;

  const auto vector = [&](auto&& value) {
    return [&rows, value](auto& f, int i) { store_vector(f, i, to_vector3(value(rows[std::size_t(i)]))); };
  };
  const auto scalar = [&](auto&& value) {
    return [&rows, value](auto& f, int i) { f(i) = Real(value(rows[std::size_t(i)])); };
  };
  const auto index = [&](auto&& value) {
    return [&rows, value](auto& f, int i) { f(i) = value(rows[std::size_t(i)]); };
  };
  const auto density = [&](const Row& r) { return deck.materials[std::size_t(r.material)].density; };
  p.position = upload<VectorField>("position", n, vector([](const Row& r) { return r.position; }));
  p.velocity = upload<VectorField>("velocity", n, [&](auto& f, int i) {
    Vector3 v = to_vector3(rows[std::size_t(i)].body->deck->velocity);
    if (i < p.count && faces.particle_host[std::size_t(i)] >= 0) { // as hold_faces will keep it
      const auto face = std::size_t(std::countr_zero(faces.particle_bits[std::size_t(i)]));
      v = (1 - held_share) * faces.constraints[face].velocity + held_share * v;
    }
    store_vector(f, i, v);
  });
  p.volume = upload<ScalarField>("volume", n, scalar([](const Row& r) { return r.volume; }));
  p.inverse_support = upload<ScalarField>(
      "inverse_support", n,
      scalar([&](const Row& r) { return 0.5 / (deck.particles.smoothing_ratio * r.body->points.spacing); }));
  p.contact_gap = upload<ScalarField>("contact_gap", n, scalar([](const Row& r) { return r.gap; }));
  p.contact_area = upload<ScalarField>("contact_area", n, scalar([](const Row& r) {
                                         return r.is_tied ? 0.0 : std::pow(r.volume, 2.0 / 3.0);
                                       }));
  p.points.mass = upload<ScalarField>("mass", n, scalar([&](const Row& r) { return density(r) * r.volume; }));
  p.points.density = upload<ScalarField>("density", n, scalar(density));
  p.points.temperature =
      upload<ScalarField>("temperature", n, scalar([](const Row& r) { return r.temperature; }));
  if (p.points.stress_temperature.extent(0) > 0)
    Kokkos::deep_copy(p.points.stress_temperature, p.points.temperature);
  if (p.heated_faces.extent(0) > 0)
    p.heated_faces = upload<View<unsigned*>>("heated_faces", n, [&](auto& f, int i) {
      f(i) = i < p.count ? faces.heated_bits[std::size_t(i)] : 0u;
    });
  p.points.material = upload<IndexField>("material", n, index([](const Row& r) { return r.material; }));
  p.body = upload<IndexField>("body", n, index([](const Row& r) { return r.body->row; }));
  p.identity = upload<IndexField>("identity", n, [](auto& f, int i) { f(i) = i; });
  // As prepare_pair_state leaves it, for sums that come before it in the first step.
  p.impedance = upload<View<Real* [3]>>("impedance", n, [&](auto& f, int i) {
    const Material m = make_material(deck.materials[std::size_t(rows[std::size_t(i)].material)]);
    const double scaled = deck.run.mass_factor * double(m.density);
    f(i, 0) = Real(scaled * double(longitudinal_wave_speed(m)) / std::sqrt(deck.run.mass_factor)),
         f(i, 1) = Real(scaled);
  });
  p.constraints = upload<View<unsigned*>>("constraints", n, [&](auto& f, int i) {
    f(i) = i < p.count ? faces.particle_bits[std::size_t(i)] : 0u;
  });
  return p;
}

} // namespace swarf
