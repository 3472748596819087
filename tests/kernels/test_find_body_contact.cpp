#include "support/two_blocks.hpp"
#include <gtest/gtest.h>
#include <set>

using namespace swarf;
using namespace swarf::test;

namespace {

struct Lists {
  std::vector<int> key;
  std::set<std::pair<int, int>> pairs;
};

Lists lists_of(const BodyContact& c) {
  Lists l;
  const auto key = host_copy(c.key), start = host_copy(c.start), other = host_copy(c.other);
  for (int i = 0; i < c.faces; ++i) {
    l.key.push_back(key(i));
    for (int k = start(i); k < start(i + 1); ++k) l.pairs.insert({key(i), key(other(k))});
  }
  return l;
}

} // namespace

// The faces that the deleted layer has left bare, each with those over it and around: 9 inside.
TEST(FindBodyContact, faces_that_are_near_find_each_other) {
  TwoBlocks b = two_blocks(4, 2, Real(1), 0.1);
  find_body_contact(b.contact, b.mesh, b.particles, b.groups);
  const Lists l = lists_of(b.contact);
  const int upper_side = 6 * (1 * 16 + 5) + 5, lower_side = 6 * (3 * 16 + 5) + 4; // over each other, inside
  EXPECT_TRUE(l.pairs.contains({upper_side, lower_side}));
  int found = 0;
  for (const auto& [a, other] : l.pairs) {
    EXPECT_TRUE(l.pairs.contains({other, a})) << "both ways";
    EXPECT_NE(a / 6 / 16 > 2, other / 6 / 16 > 2) << "of two blocks";
    found += a == upper_side && other % 6 == 4 ? 1 : 0;
  }
  EXPECT_EQ(found, 9);
  EXPECT_TRUE(std::is_sorted(l.key.begin(), l.key.end()));
  EXPECT_DOUBLE_EQ(b.contact.room, 0.15);
}

TEST(FindBodyContact, blocks_far_apart_have_nothing_and_may_move_by_half_their_distance) {
  TwoBlocks b = two_blocks(4, 2, Real(1), 3);
  find_body_contact(b.contact, b.mesh, b.particles, b.groups);
  EXPECT_EQ(b.contact.items, 0);
  EXPECT_DOUBLE_EQ(b.contact.room, 1.5);
  set_nodal(b.mesh.position, b.mesh.position, [](const Point& x) { return Point{x[0], x[1] + 0.25, x[2]}; });
  EXPECT_DOUBLE_EQ(way_since(b.contact, b.mesh, b.particles), 0.25);
}

TEST(FindBodyContact, what_stays_in_the_lists_keeps_its_memory) {
  TwoBlocks b = two_blocks(3, 1, Real(1), 0.1);
  find_body_contact(b.contact, b.mesh, b.particles, b.groups);
  const auto friction = host_copy(b.contact.friction);
  const auto key = host_copy(b.contact.key);
  for (int f = 0; f < b.contact.faces; ++f) friction(f, 2, 1) = Real(key(f));
  Kokkos::deep_copy(b.contact.friction, friction);
  const auto active = host_copy(b.mesh.active);
  active(4) = 0; // bares a side of each of four, and takes one away
  Kokkos::deep_copy(b.mesh.active, active);
  find_body_contact(b.contact, b.mesh, b.particles, b.groups);
  const auto kept = host_copy(b.contact.friction);
  const auto new_key = host_copy(b.contact.key);
  const std::set<int> before(key.data(), key.data() + key.extent(0));
  int fresh = 0;
  for (int f = 0; f < b.contact.faces; ++f) {
    EXPECT_NE(new_key(f) / 6, 4);
    EXPECT_EQ(kept(f, 2, 1), before.contains(new_key(f)) ? Real(new_key(f)) : Real(0));
    fresh += before.contains(new_key(f)) ? 0 : 1;
  }
  EXPECT_EQ(fresh, 4);
}
