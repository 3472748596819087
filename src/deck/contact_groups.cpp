// Which bodies may meet by contact.
#include "src/deck/deck.hpp"
#include <algorithm>
#include <numeric>

namespace swarf {

std::vector<int> contact_groups(const Deck& deck) {
  std::vector<int> group(deck.bodies.size());
  std::iota(group.begin(), group.end(), 0);
  for (std::size_t a = 0; a < deck.bodies.size(); ++a)
    for (std::size_t b = 0; b < deck.bodies.size(); ++b)
      if (!deck.bodies[a].tie.empty() && deck.bodies[a].tie == deck.bodies[b].name)
        for (const int from = group[a], to = group[b]; int& g : group) g = g == from ? to : g;
  return group;
}

bool are_all_tied(const Deck& deck) {
  const std::vector<int> group = contact_groups(deck);
  return std::all_of(group.begin(), group.end(), [&](int g) { return g == group.front(); });
}

bool can_meet(const Deck& deck, const BodyDeck& a, const BodyDeck& b) {
  return deck.contact.between_bodies == BetweenBodies::hexes &&
         (a.fill == Fill::hexes || b.fill == Fill::hexes);
}

bool can_meet(const Deck& deck) {
  const std::vector<int> group = contact_groups(deck);
  for (std::size_t a = 0; a < group.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (group[a] != group[b] && can_meet(deck, deck.bodies[a], deck.bodies[b])) return true;
  return false;
}

} // namespace swarf
