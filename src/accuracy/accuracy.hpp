// The key run.accuracy: the cheapest measured settings that keep the asked accuracy.
#pragma once
#include "src/accuracy/chart_settings.hpp"

namespace swarf {

struct Choice {
  const ChartPoint* point = nullptr;
  const WindowsPoint* windows = nullptr; // null: the whole pass in one run
  Deck deck;                             // with the point's settings
  double core_seconds = 0;               // see predict_core_seconds
};

struct AccuracyPlan {
  const AccuracyChart* chart = nullptr;
  Cut cut;
  double asked = 0;            // relative
  std::vector<Choice> choices; // of single runs that can be carried over, cheapest first
  int picked = -1;             // the cheapest within the asked accuracy; -1: none is
};

// Error and standard error together, no less than what the reference is known to. Those of windows come on
// top.
double level_of(const ChartPoint& point, const AccuracyChart& chart);
double level_of(const Choice& choice, const AccuracyChart& chart);

// A deck with [windows] leaves open whether the pass runs as a whole; --windows does not. Throws DeckError
// for decks that the chart says nothing about. The same deck always gives the same plan: a run that is
// resumed has the settings that it began with.
AccuracyPlan plan_accuracy(const Deck& deck, const std::vector<AccuracyChart>& charts = accuracy_charts());

// The picked deck, which says in `picked` what was set and why; throws DeckError, with what is possible, if
// there is none.
Deck planned_deck(const Deck& deck, const AccuracyPlan& plan);

// planned_deck of a deck with run.accuracy; any other as it is.
Deck apply_accuracy(const Deck& deck);

// The choices as a table. scale: core-seconds here over those of the machine that measured.
std::string show_choices(const AccuracyPlan& plan, double scale);

// "accuracy 10 %: ..." and a line for each key; "" if nothing was picked.
std::string show_pick(const Deck& deck);

} // namespace swarf
