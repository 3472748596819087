#include "src/accuracy/chart_settings.hpp"
#include "src/deck/keys.hpp"
#include "src/geometry/shape.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <tuple>

namespace swarf {
namespace {

bool is_same(double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); }

double thickness(const BodyDeck& b) { return b.shape == BodyShape::block ? b.size[2] : b.height; }
int axial(const BodyDeck& b) { return b.shape == BodyShape::block ? 2 : 1; } // direction of cells

bool is_periodic(const BodyDeck& b) {
  const std::string low = b.shape == BodyShape::block ? "z_min" : "bottom";
  return std::any_of(b.faces.begin(), b.faces.end(), [&](const FaceDeck& face) {
    return face.face == low && face.kind == FaceKind::periodic;
  });
}

// Across the chip. The previous tooth has taken a feed from a ring's bore, where the chip is thickest.
double spacing_of(const BodyDeck& b, const ToolDeck& tool) {
  if (b.spacing) return *b.spacing;
  if (b.shape == BodyShape::block) return b.size[1] / (*b.cells)[1];
  return (b.outer_radius - b.inner_radius + (b.previous_tooth ? tool.feed_per_tooth : 0)) / (*b.cells)[2];
}

double wave_speed(const MaterialDeck& m) {
  const double nu = m.poissons_ratio;
  return std::sqrt(m.youngs_modulus.greatest() * (1 - nu) / (1 + nu) / (1 - 2 * nu) / m.density);
}

int find_zone(const Deck& deck, BodyShape shape) {
  const auto nearness = [&](const BodyDeck& b) {
    return shape == BodyShape::block ? b.origin[1] + b.size[1] : -b.inner_radius;
  };
  int zone = -1;
  for (int k = 0; k < int(deck.bodies.size()); ++k) {
    const BodyDeck& body = deck.bodies[k];
    if (body.shape != shape)
      refuse_accuracy(deck,
                      fmt::format("the chart was measured with the shape \"{}\", and body \"{}\" is a {}. "
                                  "Remove this key and choose the settings yourself",
                                  word_of(shape), body.name, word_of(body.shape)));
    if (body.fill == Fill::particles && (zone < 0 || nearness(body) > nearness(deck.bodies[zone]))) zone = k;
  }
  if (zone < 0) refuse_accuracy(deck, "the chart is of particles, and this deck has none. Remove this key");
  return zone;
}

// Directions of the lattice but the slice's. Rings of particles keep a whole number of cells to a hex around.
void refine_cells(BodyDeck& b, const BodyDeck* tied_to, double finer) {
  const std::array<int, 3> old = *b.cells;
  for (int d = 0; d < 3; ++d) (*b.cells)[d] = std::max(1, int(std::lround(old[d] * finer)));
  if (!tied_to || !tied_to->cells || b.shape != BodyShape::ring || old[0] % (*tied_to->cells)[0] != 0) return;
  const int hexes = std::max(1, int(std::lround((*tied_to->cells)[0] * finer)));
  (*b.cells)[0] = old[0] / (*tied_to->cells)[0] * hexes;
}

void refine(Deck& deck, const Deck& old, const Cut& cut, double spacing) {
  const double finer = cut.spacing / spacing;
  if (is_same(finer, 1)) return;
  for (std::size_t k = 0; k < deck.bodies.size(); ++k) {
    BodyDeck& body = deck.bodies[k];
    if (body.spacing) {
      body.spacing = int(k) == cut.zone ? spacing : *body.spacing / finer;
      continue;
    }
    const bool is_tied = int(k) == cut.zone && cut.bulk >= 0;
    refine_cells(body, is_tied ? &old.bodies[cut.bulk] : nullptr, finer);
  }
}

// All that lies along the slice becomes thicker or thinner by the same share, so the tool still covers it.
struct Slice {
  int rows;
  double spacing; // m
};
void set_slice(Deck& deck, const Deck& old, const Cut& cut, const Slice& slice) {
  const auto [rows, spacing] = slice;
  const BodyDeck& zone = old.bodies[cut.zone];
  const double share = rows * spacing / thickness(zone), bottom = zone.origin[2];
  for (std::size_t k = 0; k < deck.bodies.size(); ++k) {
    BodyDeck& body = deck.bodies[k];
    if (!is_same(share, 1)) (body.shape == BodyShape::block ? body.size[2] : body.height) = rows * spacing;
    if (!body.cells) continue;
    const double old_rows = find_cells(old, zone)[axial(zone)];
    const double own = (*old.bodies[k].cells)[axial(body)] / old_rows;
    (*body.cells)[axial(body)] = std::max(1, int(std::floor(rows * own * (1 + 1e-9))));
  }
  if (is_same(share, 1)) return;
  ToolDeck& tool = *deck.tool;
  tool.position[2] = bottom + (tool.position[2] - bottom) * share;
  (tool.kind == ToolKind::wedge ? tool.width : tool.length) *= share;
  deck.output.force_scale /= share;
}

// Three digits, within the bounds of the key: a very slow tool has less inertia than was measured.
double mass_factor(double wave_share) {
  for (const auto& key : run_keys())
    if (key.name == "mass_factor") {
      const Bounds& range = std::get<Bounds>(key.allowed);
      return std::clamp(std::stod(fmt::format("{:.3g}", wave_share * wave_share)), range.low, range.high);
    }
  throw std::logic_error("run.mass_factor is no key");
}

void drop_bulk(Deck& deck, const Cut& cut) {
  BodyDeck& zone = deck.bodies[cut.zone];
  const std::string face = zone.shape == BodyShape::block ? "y_min" : "outer";
  zone.tie.clear();
  std::erase_if(zone.faces, [&](const FaceDeck& one) { return one.face == face; });
  zone.faces.push_back({face, FaceKind::fixed});
  deck.bodies.erase(deck.bodies.begin() + cut.bulk);
}

} // namespace

void refuse_accuracy(const Deck& deck, const std::string& text) {
  const std::string line = deck.run.accuracy_line > 0 ? fmt::format(":{}", deck.run.accuracy_line) : "";
  throw DeckError(fmt::format("{}{}: run.accuracy: {}.", deck.file, line, text));
}

Cut find_cut(const Deck& deck) {
  if (!deck.tool || (deck.tool->kind != ToolKind::wedge && deck.tool->kind != ToolKind::end_mill))
    refuse_accuracy(
        deck, fmt::format("the chart was measured with an end mill and a wedge, and this deck has {}. "
                          "Remove this key and choose the settings yourself",
                          deck.tool ? "a tool of kind \"" + word_of(deck.tool->kind) + "\"" : "no tool"));
  const ToolDeck& tool = *deck.tool;
  const bool is_mill = tool.kind == ToolKind::end_mill;
  Cut cut;
  cut.zone = find_zone(deck, is_mill ? BodyShape::ring : BodyShape::block);
  const BodyDeck& zone = deck.bodies[cut.zone];
  for (int k = 0; k < int(deck.bodies.size()); ++k)
    if (deck.bodies[k].name == zone.tie) cut.bulk = k;
  for (int k = 0; k < int(deck.bodies.size()); ++k)
    if (k != cut.zone && cut.bulk >= 0 && deck.bodies[k].tie == zone.tie) cut.is_bulk_shared = true;
  cut.bulk_converts = cut.bulk >= 0 && deck.bodies[cut.bulk].converts();
  cut.chip = is_mill ? tool.feed_per_tooth : zone.origin[1] + zone.size[1] - tool.position[1];
  if (!(cut.chip > 0))
    refuse_accuracy(
        deck, fmt::format("counts particles across the uncut chip, which is {:.3g} m here. Set {}", cut.chip,
                          is_mill ? "tool.feed_per_tooth" : "tool.position below the work's top"));
  cut.spacing = spacing_of(zone, tool);
  cut.speed = is_mill ? tool.spindle_speed * tool.diameter / 2
                      : std::hypot(tool.velocity[0], tool.velocity[1], tool.velocity[2]);
  if (!(cut.speed > 0)) refuse_accuracy(deck, "needs a tool that moves. Set tool.spindle_speed");
  for (const MaterialDeck& m : deck.materials)
    if (m.name == zone.material) cut.wave = wave_speed(m);
  cut.depth = is_mill ? zone.outer_radius - zone.inner_radius : tool.position[1] - zone.origin[1];
  cut.is_slice = std::all_of(deck.bodies.begin(), deck.bodies.end(), [&](const BodyDeck& b) {
    return is_periodic(b) && is_same(thickness(b), thickness(zone)) && b.origin[2] == zone.origin[2];
  });
  return cut;
}

std::string find_obstacle(const ChartPoint& point, const AccuracyChart& chart, const Cut& cut) {
  if (point.bulk && cut.bulk < 0)
    return "the particles were tied to hexes behind them; here body.tie is missing";
  if (!point.bulk && cut.depth < chart.depth * cut.chip * (1 - 1e-9))
    return fmt::format(
        "without hexes the particles were {:.3g} um deep for this uncut chip; here they are {:.3g} um",
        1e6 * chart.depth * cut.chip, 1e6 * cut.depth);
  if (!point.bulk && cut.bulk_converts) return "the hexes that would be left out are to become particles";
  if (!point.bulk && cut.is_bulk_shared)
    return "other particles are tied to the hexes that would be left out";
  if (cut.wave < point.wave_over_speed * cut.speed)
    return fmt::format("the tool moves at {:.3g} m/s: at most {:.3g} m/s have the inertia that was measured",
                       cut.speed, cut.wave / point.wave_over_speed);
  return "";
}

const WindowsPoint* find_windows(const ChartPoint& point, const AccuracyChart& chart,
                                 const WindowsDeck& windows, int count) {
  const WindowsPoint* found = nullptr;
  const double little = 1e-9;
  const auto rank = [](const WindowsPoint& one) { return std::tuple(one.chip_rows, one.run_in, one.width); };
  for (const WindowsPoint& one : chart.windows)
    if (one.chip_rows <= point.chip_rows * (1 + 1e-3) && one.count <= count &&
        one.run_in <= windows.run_in + little && one.width <= windows.width + little &&
        one.ahead <= windows.ahead + little && (!found || rank(one) > rank(*found)))
      found = &one;
  return found;
}

Deck put_settings(const Deck& deck, const Cut& cut, const ChartPoint& point) {
  Deck with = deck;
  with.run.accuracy.reset(), with.run.accuracy_line = 0;
  const double spacing = cut.chip / point.chip_rows;
  refine(with, deck, cut, spacing);
  if (cut.is_slice) set_slice(with, deck, cut, {point.slice_rows, spacing});
  if (!point.bulk && cut.bulk >= 0) drop_bulk(with, cut);
  with.run.mass_factor = mass_factor(cut.wave / (point.wave_over_speed * cut.speed));
  with.run.courant = point.courant;
  if (point.sleep_rows > 0) with.sleep.distance = point.sleep_rows * spacing; // else what the deck says
  with.particles = point.particles;
  with.particles.skin = deck.particles.skin; // changes the cost only
  return with;
}

double predict_core_seconds(const Deck& with, const Cut& cut, const ChartPoint& point) {
  double particles = 0;
  for (const BodyDeck& body : with.bodies)
    if (body.fill == Fill::particles) particles += count_cells(with, body);
  const double step = point.step * cut.chip / point.chip_rows * std::sqrt(with.run.mass_factor) / cut.wave;
  return particles * end_time_of(with) / step * point.seconds_per_particle_step;
}

} // namespace swarf
