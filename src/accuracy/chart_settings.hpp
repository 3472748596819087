// Settings of the accuracy chart put into a deck.
#pragma once
#include "src/accuracy/chart.hpp"

namespace swarf {

// What of a deck the chart's terms are measured by.
struct Cut {
  double chip = 0;             // uncut chip, m: of a mill the feed per tooth
  double spacing = 0;          // of the particles that are cut, m
  double speed = 0;            // of the edge, m/s
  double wave = 0;             // speed without mass scaling, m/s
  double depth = 0;            // of the particles below the cut (of a mill's: below the bore), m
  int zone = 0;                // row of deck.bodies: the particles that are cut
  int bulk = -1;               // row of the hexes they are tied to; -1: none
  bool is_bulk_shared = false; // other particles are tied to them too
  bool bulk_converts = false;  // they become particles where the tool comes
  bool is_slice = false;       // all bodies are as thick and periodic across
};

// The deck at run.accuracy: throws "file:line: run.accuracy: TEXT.".
[[noreturn]] void refuse_accuracy(const Deck& deck, const std::string& text);

// Throws DeckError for decks that the chart says nothing about: no wedge or end mill, other shapes, no
// particles.
Cut find_cut(const Deck& deck);

// "" or why the point's settings have no meaning in this deck.
std::string find_obstacle(const ChartPoint& point, const AccuracyChart& chart, const Cut& cut);

// What `count` windows add to the error of the point: as measured with no more particles across the chip, no
// more windows, and run-in, measurement and material ahead no longer; null where that was not measured.
const WindowsPoint* find_windows(const ChartPoint& point, const AccuracyChart& chart,
                                 const WindowsDeck& windows, int count);

// The deck with the point's settings, without run.accuracy. Bodies keep their sizes but along a periodic
// slice, which becomes a whole number of spacings; the tool along it, and the force scale, follow.
Deck put_settings(const Deck& deck, const Cut& cut, const ChartPoint& point);

// Predicted for the deck with the point's settings, on one core of the machine that measured the chart.
double predict_core_seconds(const Deck& with_settings, const Cut& cut, const ChartPoint& point);

// A key whose value differs in its first six digits, as TOML; "" where a deck does not have it. Without a
// key: a section that only one of them has.
struct KeyChange {
  std::string section, key, now, was;
};
std::vector<KeyChange> list_changes(const Deck& before, const Deck& after);
// `[body "cut zone"] spacing = "2.5e-06 m", was "5e-06 m"`.
std::string describe(const KeyChange& change);

} // namespace swarf
