#include "src/mechanistic/mill_edge.hpp"
#include "src/geometry/shape.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace swarf {
namespace {

using std::numbers::pi;

double wrap(double angle) { return angle - 2 * pi * std::floor(angle / (2 * pi)); }

// What the tool's axial extent shares with the bodies'.
double overlap(const Deck& deck) {
  double low = 1e300, high = -1e300;
  for (const BodyDeck& body : deck.bodies) {
    const auto [least, greatest] = find_box(deck, body);
    low = std::min(low, least[2]), high = std::max(high, greatest[2]);
  }
  const double end = deck.tool->position[2];
  return std::min(high, end + deck.tool->length) - std::max(low, end);
}

} // namespace

double MillCut::pitch() const { return 2 * pi / tool.flutes; }
double MillCut::lag() const { return depth * std::tan(helix) / (0.5 * tool.diameter); }
double MillCut::feed_speed() const { return tool.feed_per_tooth * tool.spindle_speed / pitch(); }

MillCut find_cut(const Deck& deck, const MechanisticDeck& model) {
  if (!deck.tool || deck.tool->kind != ToolKind::end_mill)
    throw DeckError(deck.file +
                    ": tool: the mechanistic model is one of an end mill. Give a deck that has one.");
  MillCut cut;
  cut.tool = *deck.tool;
  cut.depth = model.depth.value_or(overlap(deck) * deck.output.force_scale);
  if (!(cut.depth > 0))
    throw DeckError(deck.file +
                    ": tool: is above or below all bodies, so it cuts nothing. Give mechanistic.depth.");
  cut.helix = model.helix.value_or(deck.tool->helix);
  cut.entry = model.entry, cut.exit = model.exit, cut.minimum_chip = model.minimum_chip;
  return cut;
}

MillEdge::MillEdge(const MillCut& from) : cut(from) {
  const double R = 0.5 * cut.tool.diameter;
  for (int tooth = 0; tooth < cut.tool.flutes; ++tooth)
    for (int element = 0; element < cut.elements; ++element) {
      const double behind = cut.pitch() * tooth + cut.lag() * (element + 0.5) / cut.elements;
      // The run-out seen from this tip, which is that much behind tooth 0.
      const double from_tip = cut.tool.runout_angle + behind;
      const double out = R + cut.tool.runout * std::cos(from_tip),
                   aside = cut.tool.runout * std::sin(from_tip);
      tips.push_back({std::hypot(out, aside), std::atan2(aside, out) - behind});
    }
  if (cut.minimum_chip > 0) remember_passes();
}

MillEdge::Tip MillEdge::tip(int pass, int element) const {
  const int turn = pass >= 0 ? pass / cut.tool.flutes : -((cut.tool.flutes - 1 - pass) / cut.tool.flutes);
  Tip at = tips[std::size_t((pass - turn * cut.tool.flutes) * cut.elements + element)];
  at.angle -= 2 * pi * turn; // turns of the mill later
  return at;
}

// Along the ray from where the spindle is now, how far the surface that an earlier tip left is. That tip was
// on the ray, at angle + e, when the spindle was behind by the feed of the immersion between: sin(e) =
// (offset across the ray) / radius. Each pass gains a factor of feed / (pitch * radius), below 1e-2.
double MillEdge::reach_of(const Tip& before, const Tip& now, double angle) const {
  const Triple& d = cut.tool.feed_direction;
  const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  const double s = std::sin(angle), c = std::cos(angle),
               per_angle = cut.tool.feed_per_tooth / cut.pitch() / length;
  const double along = (d[0] * s + d[1] * c) * per_angle, across = (d[0] * c - d[1] * s) * per_angle;
  double e = 0, turned = 0;
  for (int pass = 0; pass < 6; ++pass) {
    turned = before.angle - now.angle - e; // immersion since
    e = std::asin(across * turned / before.radius);
  }
  return before.radius * std::cos(e) - along * turned;
}

std::size_t MillEdge::place(int pass, int element, double angle) const {
  const int cell = std::min(cells - 1, int(wrap(angle) / (2 * pi) * cells));
  return (std::size_t(pass) * std::size_t(cut.elements) + std::size_t(element)) * std::size_t(cells) +
         std::size_t(cell);
}

bool MillEdge::cuts_there(int pass, int element, double angle) const {
  return was_cut.empty() || pass < 0 || was_cut[place(pass, element, angle)];
}

// The surface is what the tips of one turn left, and those before as far back as one of them did cut.
double MillEdge::find_chip(int pass, int element, double angle) const {
  const Tip now = tip(pass, element);
  double reach = 0;
  bool found = false;
  for (int before = 1; before <= cut.tool.flutes || !found; ++before) {
    if (!cuts_there(pass - before, element, angle)) continue;
    reach = std::max(reach, reach_of(tip(pass - before, element), now, angle));
    found = true;
  }
  return std::max(0.0, now.radius - reach);
}

// Passes one after another from a surface that was cut everywhere, until the habit of skipping has settled.
void MillEdge::remember_passes() {
  cells = 360, passes = 24 * cut.tool.flutes;
  was_cut.assign(std::size_t(passes) * std::size_t(cut.elements) * std::size_t(cells), 0);
  for (int pass = 0; pass < passes; ++pass)
    for (int element = 0; element < cut.elements; ++element)
      for (int cell = 0; cell < cells; ++cell) {
        const double angle = 2 * pi * (cell + 0.5) / cells;
        was_cut[place(pass, element, angle)] =
            angle < cut.entry || angle > cut.exit || find_chip(pass, element, angle) >= cut.minimum_chip;
      }
}

EdgePoint MillEdge::look(int tooth, int element, double immersion) const {
  // The last turn of those remembered stands for all.
  const int pass = tooth + (was_cut.empty() ? 0 : passes - cut.tool.flutes);
  const Tip at = tip(tooth, element);
  EdgePoint point{wrap(immersion + at.angle), at.radius};
  if (point.angle < cut.entry || point.angle > cut.exit) return point;
  point.chip = find_chip(pass, element, point.angle);
  point.cuts = point.chip > 0 && cuts_there(pass, element, point.angle);
  return point;
}

double MillEdge::share_without_chip(double immersion) const {
  if (was_cut.empty()) return 0;
  int without = 0, all = 0;
  for (int pass = passes / 4; pass < passes; ++pass)
    for (int element = 0; element < cut.elements; ++element)
      without += was_cut[place(pass, element, immersion)] ? 0 : 1, ++all;
  return double(without) / all;
}

} // namespace swarf
