// A pass of a tooth as short runs ("immersion windows"): each from the previous tooth's surface, over the arc
// of the ring that it needs.
#pragma once
#include "src/deck/deck.hpp"

namespace swarf {

struct Window {
  std::string name; // window_090
  double centre = 0, from = 0,
         to = 0;         // immersion of tooth 0 at the end face, rad; measured between the last two
  double uncut_chip = 0; // m, at the centre and the end face
  Deck deck;
};

// The geometry is the whole deck's at the same immersion: the tool has advanced, the previous tooth's surface
// is the same, cells lie on the lines of the coarsest ring's lattice. A window whose run-in would begin
// before the whole pass begins as that does. Throws DeckError for decks and windows that this cannot be done
// for.
std::vector<Window> cut_windows(const Deck& whole, const WindowsDeck& windows);

// "10:170:20", first:last:step in degrees, in place of those of `windows`. Throws DeckError.
WindowsDeck read_windows_option(const std::string& text, WindowsDeck windows);

// Cells times immersion to go through: what a run costs is proportional to it, whatever the window.
double find_effort(const Deck& deck);
// Of all windows of a deck with [windows], over that of its whole pass.
double effort_in_windows(const Deck& deck);

} // namespace swarf
