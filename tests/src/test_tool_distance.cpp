// The grid's distance against all facets; and no point passes through a tool.
#include "swarf/kernels.hpp"
#include "swarf/tool/signed_distance.hpp"
#include "tool_shapes.hpp"

#include "support/box_tool.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <random>

namespace swarf::test {
namespace {

View<Vector3*> upload_points(const std::vector<Triple>& points) {
  const View<Vector3*> x("x", points.size());
  const auto host = Kokkos::create_mirror_view(x);
  for (std::size_t i = 0; i < points.size(); ++i)
    host(i) = {Real(points[i][0]), Real(points[i][1]), Real(points[i][2])};
  Kokkos::deep_copy(x, host);
  return x;
}

std::vector<ToolDistance> query(const Tool& tool, const std::vector<Triple>& points) {
  const int n = int(points.size());
  const View<Vector3*> x = upload_points(points);
  const View<ToolDistance*> result("result", n);
  Kokkos::parallel_for(
      "query", Range(0, n), KOKKOS_LAMBDA(const int i) { result(i) = signed_distance(tool, x(i)); });
  const auto out = host_copy(result);
  return {out.data(), out.data() + n};
}

// Half of the points near the surface, half anywhere in the box around it and its reach.
std::vector<Triple> scatter_points(const FacetSurface& s, double reach, int count) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> unit(0, 1);
  Triple low = s.vertices[0], high = low;
  for (const Triple& v : s.vertices)
    for (int d = 0; d < 3; ++d) low[d] = std::min(low[d], v[d]), high[d] = std::max(high[d], v[d]);
  std::vector<Triple> points;
  for (int i = 0; i < count; ++i) {
    Triple x;
    if (i % 2) {
      const auto& f = s.facets[generator() % s.facets.size()];
      for (int d = 0; d < 3; ++d) x[d] = s.vertices[f[i / 2 % 3]][d] + 2 * reach * (2 * unit(generator) - 1);
    } else {
      for (int d = 0; d < 3; ++d)
        x[d] = low[d] - 2 * reach + (high[d] - low[d] + 4 * reach) * unit(generator);
    }
    points.push_back(x);
  }
  return points;
}

void expect_exact(const FacetSurface& surface, const ToolDeck& deck, double reach, int count) {
  const Tool tool = build_tool(surface, deck, reach);
  const auto points = scatter_points(surface, reach, count);
  const auto found = query(tool, points);
  int near = 0, inside = 0;
  for (int i = 0; i < count; ++i) {
    const double exact = exact_distance(surface, points[i]);
    if (std::abs(exact) <= reach * (1 - 1e-4)) {
      ASSERT_EQ(found[i].where, ToolDistance::Where::near) << exact;
    }
    if (found[i].where == ToolDistance::Where::near) {
      ASSERT_NEAR(found[i].distance, exact, 1e-9 * reach * coarse) << "point " << i;
      ++near, inside += exact < 0;
    } else {
      ASSERT_EQ(found[i].where == ToolDistance::Where::deep_inside, exact < 0) << exact;
    }
  }
  EXPECT_GT(near, count / 4);
  EXPECT_GT(inside, count / 20);
}

View<int*> which_are_beyond(const Tool& tool, const std::vector<Triple>& points, double gap) {
  const View<Vector3*> x = upload_points(points);
  const View<int*> result("result", points.size());
  Kokkos::parallel_for(
      "beyond", Range(0, int(points.size())),
      KOKKOS_LAMBDA(const int i) { result(i) = is_beyond(tool, x(i), Real(gap)); });
  return result;
}

// What a cell says of all its points is true of each, and of most points outside it says enough, among them
// those in reach of the surface, whose cells hold facets.
TEST(ToolDistance, BeyondIsOutsideAndFarther) {
  const double reach = 5e-6, gap = 1e-6;
  const FacetSurface surface = make_tool_surface(make_mill(), "");
  const Tool tool = build_tool(surface, make_mill(), reach);
  const auto points = scatter_points(surface, reach, 2000);
  const auto beyond = host_copy(which_are_beyond(tool, points, gap));
  int farther = 0, said = 0, farther_in_reach = 0, said_in_reach = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double exact = exact_distance(surface, points[i]);
    farther += exact > gap, said += beyond(i);
    if (exact < reach) farther_in_reach += exact > gap, said_in_reach += beyond(i);
    if (beyond(i)) {
      EXPECT_GT(exact, gap * (1 - 1e-4)) << i;
    }
  }
  EXPECT_GT(said, farther / 2);
  EXPECT_GT(said_in_reach, farther_in_reach / 2);
}

TEST(ToolDistance, DistanceIsExactOnAMill) {
  expect_exact(make_tool_surface(make_mill(), ""), make_mill(), 5e-6, 2000);
}
TEST(ToolDistance, DistanceIsExactOnAWedge) {
  ToolDeck deck = make_wedge_deck();
  expect_exact(make_tool_surface(deck, ""), deck, 5e-6, 10000);
  deck.inclination = 20 * degree, deck.rake = -30 * degree;
  expect_exact(make_tool_surface(deck, ""), deck, 5e-6, 10000);
}
TEST(ToolDistance, DistanceIsExactOnAWall) {
  expect_exact(make_tool_surface(make_wall_deck(), ""), make_wall_deck(), 2e-5, 20000);
}
TEST(ToolDistance, DistanceIsExactOnASphereFromAFile) {
  const TemporaryFolder folder;
  write_stl(make_sphere(1e-4, 3), (folder / "sphere.stl").string());
  ToolDeck deck(ToolKind::stl);
  deck.file = "sphere.stl", deck.file_scale = 1;
  expect_exact(make_tool_surface(deck, folder.path.string()), deck, 5e-6, 5000);
}

// --- leaks: points that a constant force presses against the tool while it cuts through them at ten times
// the speed of the milling scene, with its step at a mass factor of 1e4 and the pressure of a hard contact, 3
// GPa.
struct Press {
  double spacing = 3e-6, dt = 1.8e-8, mass_factor = 1e4, drag_speed = 4;
  double force() const { return 3e9 * spacing * spacing; }
};

void move_pressed_points(const ContactPoints& p, const Press& press, const Vector3& direction) {
  const Real dt = Real(press.dt), f = Real(press.force()), drag = Real(press.force() / press.drag_speed);
  const Real factor = Real(press.mass_factor);
  Kokkos::parallel_for(
      "move_pressed_points", Range(0, p.count), KOKKOS_LAMBDA(const int i) {
        Vector3 v = load_vector(p.velocity, i);
        // Implicit drag: the terminal speed is drag_speed whatever the mass.
        const Real m = factor * p.mass(i);
        v = (1 / (1 + dt * drag / m)) * (v + (dt / m) * (f * direction + load_vector(p.force, i)));
        store_vector(p.velocity, i, v);
        store_vector(p.position, i, load_vector(p.position, i) + dt * v);
      });
}

ContactPoints fill_outside(const Tool& tool, const ToolPose& pose, const Vector3& low, const Vector3& high,
                           const Press& press) {
  std::vector<Triple> all, kept;
  for (double x = low.x; x < high.x; x += press.spacing)
    for (double y = low.y; y < high.y; y += press.spacing)
      for (double z = low.z; z < high.z; z += press.spacing) {
        const Vector3 local = to_tool(make_frame(pose), {Real(x), Real(y), Real(z)});
        all.push_back({x, y, z}), kept.push_back({local.x, local.y, local.z});
      }
  const auto found = query(tool, kept);
  kept.clear();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool near = found[i].where == ToolDistance::Where::near;
    if (found[i].where == ToolDistance::Where::outside || (near && found[i].distance > press.spacing / 2))
      kept.push_back(all[i]);
  }
  ContactPoints p = make_contact_points(int(kept.size()), 4430 * std::pow(press.spacing, 3));
  Kokkos::deep_copy(p.gap, Real(press.spacing / 2));
  Kokkos::deep_copy(p.area, Real(press.spacing * press.spacing));
  const auto x = host_copy(p.position);
  for (int i = 0; i < p.count; ++i)
    store_vector(x, i, {Real(kept[i][0]), Real(kept[i][1]), Real(kept[i][2])});
  Kokkos::deep_copy(p.position, x);
  return p;
}

struct Leaks {
  int points = 0, most_touching = 0, most_inside = 0;
};
Leaks press_against(const ToolDeck& deck, const Vector3& low, const Vector3& high, const Vector3& direction,
                    double start, double end) {
  const Press press;
  const Tool tool = build_tool(make_tool_surface(deck, ""), deck, 2 * press.spacing);
  const ContactPoints p = fill_outside(tool, tool_pose(deck, start), low, high, press);
  ContactLaw law;
  law.friction = Real(0.5), law.stiffness = Real(0.1);
  const ToolLoadSums sums = make_tool_load_sums(p.count);
  Leaks leaks;
  leaks.points = p.count;
  int step = 0;
  for (double time = start; time < end; time += press.dt, ++step) {
    move_pressed_points(p, press, direction);
    Kokkos::deep_copy(p.force, Real(0));
    const ToolPose pose = tool_pose(deck, time);
    tool_contact(p, tool, pose, law, MaterialTable("materials", 1), Real(press.mass_factor), Real(press.dt));
    if (step % 20) continue;
    Kokkos::deep_copy(sums.total, ToolLoad{});
    sum_tool_load(p, tool, pose, Real(press.dt), sums);
    const auto load = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, sums.total);
    leaks.most_touching = std::max(leaks.most_touching, int(load().contacts));
    leaks.most_inside = std::max(leaks.most_inside, count_points_inside(p, tool, pose, 0));
  }
  return leaks;
}

TEST(ToolContact, NoPointPassesThroughAWedgeAtTenTimesTheSpeed) {
  ToolDeck deck = make_wedge_deck();
  deck.edge_radius = 6e-6, deck.velocity = {4.2, 0, 0};
  const Vector3 low{Real(-30e-6), Real(-30e-6), Real(-10e-6)}, high{Real(60e-6), Real(60e-6), Real(10e-6)};
  for (const Vector3& direction : {Vector3{-1, 0, 0}, Vector3{0, 1, 0}, Vector3{Real(-0.7), Real(0.7), 0}}) {
    const Leaks leaks = press_against(deck, low, high, direction, 0, 8e-6);
    EXPECT_GT(leaks.points, 2000);
    EXPECT_GT(leaks.most_touching, 40);
    EXPECT_EQ(leaks.most_inside, 0);
  }
}
TEST(ToolContact, NoPointPassesThroughAMillAtTenTimesTheSpeed) {
  ToolDeck deck = make_mill();
  deck.spindle_speed = 10470, deck.feed_per_tooth = 10e-6; // 4.19 m/s at the edge
  const Vector3 low{Real(-40e-6), Real(340e-6), Real(20e-6)}, high{Real(60e-6), Real(420e-6), Real(40e-6)};
  for (const Vector3& direction :
       {Vector3{-1, 0, 0}, Vector3{0, -1, 0}, Vector3{Real(-0.7), Real(-0.7), 0}}) {
    const Leaks leaks = press_against(deck, low, high, direction, 0, 8e-6);
    EXPECT_GT(leaks.points, 2000);
    EXPECT_GT(leaks.most_touching, 40);
    EXPECT_EQ(leaks.most_inside, 0);
  }
}

} // namespace
} // namespace swarf::test
