// Contact of bodies: when its lists are made again, and what a checkpoint keeps of it.
#include "src/output/write_hdf5.hpp"
#include "src/simulation/checkpoint_checks.hpp"
#include "src/simulation/simulation.hpp"
#include <algorithm>
#include <cmath>

namespace swarf {
namespace {

// In ascending order, none twice, each within [0, most).
bool ascends(const IndexField& rows, int most) {
  const auto values = host_copy(rows);
  int last = -1;
  for (std::size_t k = 0; k < values.extent(0); ++k) {
    if (values(k) <= last || values(k) >= most) return false;
    last = values(k);
  }
  return true;
}

} // namespace

void Simulation::follow_bodies() {
  find_body_contact(meeting, model.hexes, model.particles, model.contact_groups);
  // What has left the lists presses nothing any more.
  Kokkos::deep_copy(model.hexes.body_contact_energy, Real(0));
  Kokkos::deep_copy(model.particles.body_contact_energy, Real(0));
  meeting_due = false;
  timer.mark("contact");
}

// As check() does for the neighbour lists; where hexes may be deleted the surface is looked at again each
// time.
long Simulation::plan_body_contact(double reach, long interval) {
  const double whole = double(meeting.room);
  const double left = whole - double(way_since(meeting, model.hexes, model.particles));
  if (left < 0) fail("bodies that outran the lists of their contact: " + place_of_fastest());
  if (reach * double(interval) > 0.5 * whole) interval = std::max(1L, long(0.5 * whole / reach));
  const bool deletes = hex_method.delete_failed || hex_method.delete_at_strain > Real(0);
  meeting_due = deletes || left < reach * double(interval);
  return interval;
}

void Simulation::write_body_contact(CheckpointWriter& out) const {
  out.put("body_contact/due", int(meeting_due)), out.put("body_contact/room", double(meeting.room));
  out.put("body_contact/face", meeting.key), out.put("body_contact/particle", meeting.row);
  out.put("body_contact/faces", meeting.faces), out.put("body_contact/items", meeting.items);
  out.put("body_contact/friction", meeting.friction);
  out.put("body_contact/node_position", meeting.node_position);
  out.put("body_contact/particle_position", meeting.particle_position);
}

// The lists are made again from the positions at which they were made, so that every sum keeps its order.
void Simulation::read_body_contact(const CheckpointReader& in) {
  const Particles& p = model.particles;
  const HexMesh& h = model.hexes;
  int due = 0, faces = 0, items = 0;
  double room = 0;
  in.get("body_contact/due", due), in.get("body_contact/room", room);
  in.get("body_contact/faces", faces), in.get("body_contact/items", items);
  in.require(room > 0, "body_contact/room");
  in.require(faces >= 0 && faces <= 6 * h.points.count, "body_contact/faces");
  in.require(items >= faces && items - faces <= p.count, "body_contact/items");
  in.get("body_contact/face", meeting.key, std::uint64_t(faces));
  in.get("body_contact/particle", meeting.row, std::uint64_t(items - faces));
  in.require(ascends(meeting.key, 6 * h.points.count), "body_contact/face");
  in.require(ascends(meeting.row, p.count), "body_contact/particle");
  VectorField node, particle;
  in.get("body_contact/node_position", node, std::uint64_t(h.nodes));
  in.get("body_contact/particle_position", particle, std::uint64_t(p.count));
  in.require(is_finite(node), "body_contact/node_position");
  in.require(is_finite(particle), "body_contact/particle_position");
  VectorField current("current", std::size_t(h.nodes));
  Kokkos::deep_copy(current, h.position);
  Kokkos::deep_copy(h.position, node);
  const auto rows = std::make_pair(0, p.count);
  Kokkos::deep_copy(Kokkos::subview(p.position, rows, Kokkos::ALL), particle); // read_state sets them again
  list_body_contact(meeting, h, p, model.contact_groups);
  Kokkos::deep_copy(h.position, current);
  in.get("body_contact/friction", meeting.friction, std::uint64_t(faces));
  meeting.room = Real(room), meeting_due = due != 0;
}

} // namespace swarf
