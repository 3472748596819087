// Lists of the faces and particles that are near to those of another group of bodies. First what lies within
// the box of another group at all: of bodies that are far apart nothing is left, and they may move that far
// until the lists are made again. Then, from a grid of the boxes' centres, for each its neighbours: boxes
// that meet when both are grown by half the skin. That is the same for both, so that each is in the list of
// the other, and sums over lists are gathers on both sides. Reads positions, active, contact_gap; writes the
// lists, and takes the memory of faces along by their keys.
#include "body_contact_boxes.hpp"
#include "cell_order.hpp"
#include "rows_by_key.hpp"

namespace swarf {
namespace {

// The rows in ascending order for which takes(row).
template <class Takes>
IndexField rows_that(int rows, const Takes& takes) {
  const IndexField place(Kokkos::view_alloc(Kokkos::WithoutInitializing, "contact_place"), rows);
  Kokkos::parallel_for(
      "choose_contact_rows", Range(0, rows), KOKKOS_LAMBDA(int k) { place(k) = takes(k) ? 1 : 0; });
  const IndexField taken("contact_rows", number_taken(place));
  Kokkos::parallel_for(
      "choose_contact_rows", Range(0, rows), KOKKOS_LAMBDA(int k) {
        if (place(k) >= 0) taken(place(k)) = k;
      });
  return taken;
}

struct IsSurface {
  View<int*> active;
  View<int* [6]> behind;
  SWARF_FN bool operator()(int side) const {
    const int next = behind(side / 6, side % 6);
    return active(side / 6) != hex_deleted && (next == no_hex || (next >= 0 && active(next) == hex_deleted));
  }
};

// A box of rows [0, groups) is that of a group's faces, of [groups, 2 groups) of its particles.
struct IsNear {
  HexMesh h;
  Particles p;
  ContactGroups g;
  VectorField low, high;

  SWARF_FN bool meets(const ContactBox& box, int group, int row) const {
    return row % g.count != group && do_meet(box, {load_vector(low, row), load_vector(high, row)}, g.skin);
  }
  SWARF_FN bool face(int side) const {
    const ContactBox box = box_of_face(h, side);
    for (int row = 0; row < 2 * g.count; ++row)
      if (meets(box, g.of_hex(side / 6), row)) return true;
    return false;
  }
  SWARF_FN bool particle(int i) const {
    const ContactBox box = box_of_particle(p, i);
    for (int row = 0; row < g.count; ++row)
      if (meets(box, g.of_body(p.body(i)), row)) return true;
    return false;
  }
};

// Half of what lies between the two groups that are nearest to each other and may meet.
Real room_between(const std::vector<ContactBox>& boxes, const ContactGroups& g) {
  Real least = Kokkos::Experimental::infinity_v<Real>;
  for (int a = 0; a < 2 * g.count; ++a)
    for (int b = 0; b < a; ++b)
      if (a % g.count != b % g.count && b < g.count)
        least = Kokkos::min(least, distance_between(boxes[std::size_t(a)], boxes[std::size_t(b)]));
  return Real(0.5) * Kokkos::max(least, g.skin);
}

void collect(BodyContact& c, const HexMesh& h, const Particles& p, const ContactGroups& g) {
  const IndexField surface = rows_that(6 * h.points.count, IsSurface{h.active, g.behind});
  const std::vector<ContactBox> boxes = boxes_of_groups(h, p, g, surface);
  const int rows = int(boxes.size());
  const IsNear near{h, p, g, VectorField("group_low", rows), VectorField("group_high", rows)};
  const auto low = Kokkos::create_mirror_view(near.low), high = Kokkos::create_mirror_view(near.high);
  for (int k = 0; k < rows; ++k)
    store_vector(low, k, boxes[std::size_t(k)].low), store_vector(high, k, boxes[std::size_t(k)].high);
  Kokkos::deep_copy(near.low, low), Kokkos::deep_copy(near.high, high);
  const IndexField kept = rows_that(
      int(surface.extent(0)), KOKKOS_LAMBDA(int k) { return near.face(surface(k)); });
  const IndexField key("contact_key", kept.extent(0));
  Kokkos::parallel_for(
      "contact_key", Range(0, int(kept.extent(0))), KOKKOS_LAMBDA(int k) { key(k) = surface(kept(k)); });
  c.key = key;
  c.row = rows_that(
      p.count, KOKKOS_LAMBDA(int i) { return near.particle(i); });
  c.room = room_between(boxes, g);
}

// --- the lists

struct Search {
  CellGrid grid;
  KeyedRows rows; // by cell
  VectorField low, high;
  IndexField group;
  Real reach = 0; // from a box to the centre of one that it meets
  int items = 0, faces = 0;

  SWARF_FN bool are_near(int i, int j) const {
    return group(i) != group(j) && (i < faces || j < faces) &&
           do_meet({load_vector(low, i), load_vector(high, i)}, {load_vector(low, j), load_vector(high, j)},
                   grid_skin);
  }
  Real grid_skin = 0;

  template <class Take>
  SWARF_FN void for_each_near(int i, const Take& take) const {
    const Vector3 out{reach, reach, reach};
    const CellIndex first = grid.index(load_vector(low, i) - out),
                    last = grid.index(load_vector(high, i) + out);
    for (CellKey k = first.k; k <= last.k; ++k)
      for (CellKey j = first.j; j <= last.j; ++j) {
        const CellKey end = row_key({last.i, j, k});
        for (int at = lower_bound(rows, items, row_key({first.i, j, k})); at < items && rows(at).key <= end;
             ++at)
          if (are_near(i, rows(at).row)) take(rows(at).row);
      }
  }
};

Search make_search(const BodyContact& c, const HexMesh& h, const Particles& p, const ContactGroups& g) {
  Search s;
  s.items = c.items, s.faces = c.faces, s.grid_skin = g.skin;
  s.low = VectorField("contact_low", c.items), s.high = VectorField("contact_high", c.items);
  s.group = IndexField("contact_group", c.items);
  const VectorField centre("contact_centre", c.items), low = s.low, high = s.high;
  const IndexField key = c.key, row = c.row, group = s.group;
  const int faces = c.faces;
  Real widest = 0;
  Kokkos::parallel_reduce(
      "contact_boxes", Range(0, c.items),
      KOKKOS_LAMBDA(int i, Real& most) {
        const bool is_face = i < faces;
        const ContactBox box = is_face ? box_of_face(h, key(i)) : box_of_particle(p, row(i - faces));
        group(i) = is_face ? g.of_hex(key(i) / 6) : g.of_body(p.body(row(i - faces)));
        const Vector3 size = box.high - box.low;
        store_vector(low, i, box.low), store_vector(high, i, box.high);
        store_vector(centre, i, Real(0.5) * (box.low + box.high));
        most = Kokkos::max(most, Kokkos::max(size.x, Kokkos::max(size.y, size.z)));
      },
      Kokkos::Max<Real>(widest));
  s.reach = Real(1.001) * (Real(0.5) * widest + g.skin); // a little more: both must find each other
  s.grid = cell_grid(centre, c.items, widest + g.skin);
  s.rows = sort_rows(centre, first_rows(c.items), RowKeyOf{s.grid});
  return s;
}

void list_near(BodyContact& c, const Search& s) {
  c.start = IndexField("contact_start", c.items + 1);
  const IndexField start = c.start;
  Kokkos::parallel_for(
      "find_body_contact", Range(0, c.items), KOKKOS_LAMBDA(int i) {
        int count = 0;
        s.for_each_near(i, [&](int) { ++count; });
        start(i) = count;
      });
  int total = 0;
  const int items = c.items;
  Kokkos::parallel_scan(
      "contact_start", Range(0, items + 1),
      KOKKOS_LAMBDA(int i, int& sum, bool last) {
        const int own = i < items ? start(i) : 0;
        if (last) start(i) = sum;
        sum += own;
      },
      total);
  c.other = IndexField("contact_other", total);
  const IndexField other = c.other;
  Kokkos::parallel_for(
      "find_body_contact", Range(0, c.items), KOKKOS_LAMBDA(int i) {
        int at = start(i);
        s.for_each_near(i, [&](int j) { other(at++) = j; });
      });
}

void list_corners(BodyContact& c, const HexMesh& h) {
  c.node = View<int* [points_of_face]>("contact_node", c.faces);
  const int corners = points_of_face * c.faces;
  const IndexField key = c.key, node_of("contact_corner_node", corners);
  const auto node = c.node;
  const View<int* [8]> connectivity = h.connectivity;
  Kokkos::parallel_for(
      "contact_node", Range(0, corners), KOKKOS_LAMBDA(int k) {
        const int side = key(k / points_of_face), a = k % points_of_face;
        node_of(k) = node(k / points_of_face, a) = connectivity(side / 6, corner_of_side(side % 6, a));
      });
  c.corner_start = IndexField("contact_corner_start", h.nodes + 1),
  c.corner = IndexField("contact_corner", corners);
  list_rows_by_key(
      "contact_corner", node_of, corners, c.corner_start, c.corner, KOKKOS_LAMBDA(int) { return true; });
  const IndexField start = c.corner_start, corner = c.corner;
  Kokkos::parallel_for(
      "contact_corner", Range(0, h.nodes),
      KOKKOS_LAMBDA(int a) { sort_rows(corner, start(a), start(a + 1)); });
}

// Of faces that are in the lists again.
void keep_memory(BodyContact& c, const BodyContact& before) {
  c.friction = View<Real* [points_of_face][3]>("contact_friction", c.faces);
  const IndexField key = c.key, old_key = before.key;
  const auto friction = c.friction, old = before.friction;
  const int old_faces = int(Kokkos::min(old_key.extent(0), old.extent(0)));
  Kokkos::parallel_for(
      "keep_contact_memory", Range(0, c.faces), KOKKOS_LAMBDA(int f) {
        int low = 0, high = old_faces;
        while (low < high) {
          const int middle = (low + high) / 2;
          old_key(middle) < key(f) ? low = middle + 1 : high = middle;
        }
        if (low == old_faces || old_key(low) != key(f)) return;
        for (int q = 0; q < points_of_face; ++q)
          for (int d = 0; d < 3; ++d) friction(f, q, d) = old(low, q, d);
      });
}

} // namespace

void list_body_contact(BodyContact& c, const HexMesh& h, const Particles& p, const ContactGroups& g) {
  c.faces = int(c.key.extent(0)), c.items = c.faces + int(c.row.extent(0));
  c.touch = View<Touch* [points_of_face]>("contact_touch", c.items);
  list_corners(c, h);
  if (c.items > 0) list_near(c, make_search(c, h, p, g));
  c.node_position = VectorField("contact_node_position", h.nodes);
  c.particle_position = VectorField("contact_particle_position", p.count);
  const VectorField node = c.node_position, particle = c.particle_position;
  Kokkos::parallel_for(
      "contact_node_position", Range(0, h.nodes),
      KOKKOS_LAMBDA(int a) { store_vector(node, a, load_vector(h.position, a)); });
  Kokkos::parallel_for(
      "contact_particle_position", Range(0, p.count),
      KOKKOS_LAMBDA(int i) { store_vector(particle, i, load_vector(p.position, i)); });
}

void find_body_contact(BodyContact& c, const HexMesh& h, const Particles& p, const ContactGroups& g) {
  const BodyContact before = c;
  collect(c, h, p, g);
  list_body_contact(c, h, p, g);
  keep_memory(c, before);
}

Real way_since(const BodyContact& c, const HexMesh& h, const Particles& p) {
  Real node = 0, particle = 0;
  Kokkos::parallel_reduce(
      "contact_way", Range(0, h.nodes),
      KOKKOS_LAMBDA(int a, Real& most) {
        most = Kokkos::max(most, norm(load_vector(h.position, a) - load_vector(c.node_position, a)));
      },
      Kokkos::Max<Real>(node));
  Kokkos::parallel_reduce(
      "contact_way", Range(0, Kokkos::min(p.count, int(c.particle_position.extent(0)))),
      KOKKOS_LAMBDA(int i, Real& most) {
        most = Kokkos::max(most, norm(load_vector(p.position, i) - load_vector(c.particle_position, i)));
      },
      Kokkos::Max<Real>(particle));
  return Kokkos::max(node, particle);
}

} // namespace swarf
