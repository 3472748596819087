// Where the teeth of an end mill have been: the exact uncut chip of every point of its edges, on trochoids,
// with run-out, and with chips too thin to be cut.
#pragma once
#include "src/deck/deck.hpp"
#include <vector>

namespace swarf {

// The tool of a deck and what of it cuts. Throws DeckError where the deck has no end mill or nothing to cut.
struct MillCut {
  ToolDeck tool;
  double depth = 0, helix = 0; // m, rad
  double entry = 0, exit = 0;  // immersion, rad
  double minimum_chip = 0;     // m
  int elements = 32;           // along each edge

  double pitch() const;      // rad
  double lag() const;        // rad, of the edge's upper end behind its lower
  double feed_speed() const; // m/s
};
MillCut find_cut(const Deck& deck, const MechanisticDeck& model);

struct EdgePoint {
  double angle = 0;  // about the spindle, clockwise from +y, rad, in [0, 2 pi)
  double radius = 0; // from the spindle's axis, m
  double chip = 0;   // uncut chip along the radius, m; 0: does not touch the work
  bool cuts = false; // a chip comes off; false with a chip: the edge only presses
};

// Teeth are counted on: tooth 5 of a mill of two is tooth 1, two turns later.
class MillEdge {
 public:
  explicit MillEdge(const MillCut& cut);
  // Of the middle of element `element` (0: at the end face) of tooth `tooth`, where tooth 0 at the end face
  // is at `immersion`.
  EdgePoint look(int tooth, int element, double immersion) const;
  // Of all passes after the first ones, the share that left the work uncut at this immersion, mean of the
  // edge.
  double share_without_chip(double immersion) const;
  double element_depth() const { return cut.depth / cut.elements; }

 private:
  struct Tip {
    double radius, angle; // about the spindle's axis; without run-out R and -tooth * pitch - lag
  };
  MillCut cut;
  std::vector<Tip> tips;     // [tooth][element], one turn
  std::vector<char> was_cut; // [pass][element][cell of immersion]; empty: all
  int cells = 0, passes = 0;

  Tip tip(int pass, int element) const;
  bool cuts_there(int pass, int element, double angle) const;
  double find_chip(int pass, int element, double angle) const;
  double reach_of(const Tip& before, const Tip& now, double angle) const;
  void remember_passes();
  std::size_t place(int pass, int element, double angle) const;
};

} // namespace swarf
