#include "src/windows/windows.hpp"
#include "src/deck/section.hpp"
#include "src/geometry/shape.hpp"
#include "src/tool/mill_motion.hpp"
#include <charconv>
#include <cmath>
#include <numbers>

namespace swarf {
namespace {

using std::numbers::pi;
constexpr double degree = pi / 180;
constexpr double grain = 1e-6; // of a cell: closer lines are the same

[[noreturn]] void refuse(const Deck& deck, const WindowsDeck& windows, const std::string& key,
                         const std::string& text) {
  const std::string line = windows.line > 0 ? fmt::format(":{}", windows.line) : "";
  throw DeckError(fmt::format("{}{}: windows{}: {}.", deck.file, line, key.empty() ? "" : "." + key, text));
}

bool is_closed(const BodyDeck& ring) { return ring.end_angle - ring.start_angle > 2 * pi * (1 - 1e-12); }

double cell_angle(const Deck& deck, const BodyDeck& ring) {
  return (ring.end_angle - ring.start_angle) / find_cells(deck, ring)[0];
}

// Whole turns between the angles of a ring and those that follow the immersion without a jump.
double turns_of(const BodyDeck& ring, double angle) {
  const double middle = is_closed(ring) ? 0 : 0.5 * (ring.start_angle + ring.end_angle);
  return 2 * pi * std::round((middle - angle) / (2 * pi));
}

class Cutter {
 public:
  Cutter(const Deck& deck, const WindowsDeck& which) : whole(deck), windows(which) {
    check_tool();
    check_rings();
    tool = *whole.tool;
    for (const BodyDeck& body : whole.bodies) {
      if (!grid || cell_angle(whole, body) > cell_angle(whole, *grid)) grid = &body;
      if (body.previous_tooth || !bore) bore = &body;
      top = std::max(top, body.origin[2] + body.height);
      if (body.fill == Fill::particles || margin == 0) margin = std::max(margin, cell_angle(whole, body));
    }
    motion = {tool, bore->origin};
    check_teeth();
    lag = std::clamp(top - tool.position[2], 0.0, tool.length) * std::tan(tool.helix) / motion.radius();
    lead = lead_of_edge(tool, bore->inner_radius - tool.feed_per_tooth);
  }

  Window cut(double centre) const;

 private:
  const Deck& whole;
  const WindowsDeck& windows;
  ToolDeck tool;
  const BodyDeck *grid = nullptr, *bore = nullptr;
  MillMotion motion;
  double lag = 0, lead = 0, margin = 0, top = 0;

  struct Start {
    double immersion; // of tooth 0
    double end;       // angle of the rings where they begin: their free end
    bool as_whole;    // it is where the whole pass starts
  };

  void check_tool() const;
  void check_rings() const;
  void check_teeth() const;
  void check_place(const Window& window) const;
  double line(double angle, int direction) const;
  Start find_start(double from) const;
  void cut_ring(BodyDeck& ring, double low, double high) const;
  double find_uncut_chip(double immersion) const;
};

void Cutter::check_tool() const {
  if (!whole.tool || whole.tool->kind != ToolKind::end_mill)
    refuse(
        whole, windows, "",
        fmt::format("spread over the immersion of an end mill, and this deck has {}. Run it without windows",
                    whole.tool ? "a tool of kind \"" + word_of(whole.tool->kind) + "\"" : "no tool"));
  if (whole.tool->lift_time || !whole.tool->temperature_from.empty())
    refuse(
        whole, windows, "",
        "are runs side by side that end in the cut: tool.lift_time and tool.temperature_from are for a whole "
        "pass. Leave them out, or run this deck without windows");
  if (!whole.run.end_immersion)
    refuse(whole, windows, "", "need run.end_immersion instead of end_time: it says where the pass ends");
}

void Cutter::check_rings() const {
  const Triple& axis = whole.bodies.front().origin;
  for (const BodyDeck& body : whole.bodies) {
    if (body.shape != BodyShape::ring)
      reject(whole, body, "shape",
             fmt::format("is a {}: windows are cut from rings only. Run this deck without windows",
                         word_of(body.shape)));
    if (std::hypot(body.origin[0] - axis[0], body.origin[1] - axis[1]) > 1e-9 * body.outer_radius)
      reject(whole, body, "origin",
             fmt::format("has another axis than \"{}\": windows are cut from rings of one axis. Move it",
                         whole.bodies.front().name));
    for (const FaceDeck& face : body.faces)
      if ((face.face == "start" || face.face == "end") && face.kind == FaceKind::periodic)
        reject(whole, body, "faces." + face.face,
               "is periodic around the ring, which a window cuts open. Run this deck without windows");
  }
}

void Cutter::check_teeth() const {
  double arc = pi; // of a slot
  for (const BodyDeck& body : whole.bodies) arc = std::min(arc, body.end_angle - body.start_angle);
  if (arc > motion.pitch() * (1 + 1e-9))
    refuse(
        whole, windows, "",
        fmt::format("hold one tooth each, and {} flutes cut an arc of {:.4g} deg together. Make the rings' "
                    "sector at most {:.4g} deg, or run without windows",
                    tool.flutes, arc / degree, motion.pitch() / degree));
  for (const double immersion : {tool.start_angle, *whole.run.end_immersion})
    if (!motion.is_near_axis(immersion))
      refuse(whole, windows, "",
             "need the mill's axis near the rings': expected less than a tenth of its radius apart all "
             "through the pass. Move tool.position");
}

void Cutter::check_place(const Window& window) const {
  const auto outside = [&](const std::string& key, const std::string& text) {
    refuse(whole, windows, key,
           fmt::format("the window at {:.6g} deg is measured from {:.6g} to {:.6g} deg, {}",
                       window.centre / degree, window.from / degree, window.to / degree, text));
  };
  if (window.from < tool.start_angle)
    outside("first",
            fmt::format("before tool.start_angle = {:.6g} deg. Take a later one", tool.start_angle / degree));
  const double end = std::min(*whole.run.end_immersion, tool.start_angle + motion.pitch() + lag);
  if (window.to > end * (1 + 1e-12))
    outside("last", fmt::format("past {:.6g} deg, where the pass of one tooth ends (run.end_immersion, or a "
                                "pitch after tool.start_angle). Take an earlier one",
                                end / degree));
  for (const BodyDeck& body : whole.bodies) {
    if (is_closed(body)) continue;
    const double middle = pi / 2 - motion.about_ring(window.centre), turns = turns_of(body, middle);
    const double last = pi / 2 - motion.about_ring(window.to) + turns,
                 first = pi / 2 - motion.about_ring(window.from - lag) + turns;
    if (last < body.start_angle || first > body.end_angle)
      outside("last",
              fmt::format("and body \"{}\" of line {} has no material there: it lies at immersions from "
                          "{:.6g} to {:.6g} deg. Take windows inside, or enlarge the ring",
                          body.name, body.line, 90 - (body.end_angle - turns) / degree,
                          90 - (body.start_angle - turns) / degree));
  }
}

// The line of the coarsest lattice at the angle, or next in the direction.
double Cutter::line(double angle, int direction) const {
  const double cell = cell_angle(whole, *grid), turns = turns_of(*grid, angle);
  const double k = (angle + turns - grid->start_angle) / cell;
  const double whole_k = direction > 0 ? std::ceil(k - grain) : std::floor(k + grain);
  return grid->start_angle + whole_k * cell - turns;
}

Cutter::Start Cutter::find_start(double from) const {
  const double entry = from - lag - windows.run_in;
  const double end = line(pi / 2 - motion.about_ring(entry), +1);
  const double immersion = motion.where_about_ring(pi / 2 - end) - lead - margin;
  const bool is_inside = is_closed(*grid) || end + turns_of(*grid, end) < grid->end_angle;
  if (immersion > tool.start_angle && is_inside) return {immersion, end, false};
  const double front = pi / 2 - motion.about_ring(tool.start_angle + lead + margin);
  const double own_end = is_closed(*grid) ? line(front, -1) : grid->end_angle - turns_of(*grid, front);
  return {tool.start_angle, own_end, true};
}

void Cutter::cut_ring(BodyDeck& ring, double low, double high) const {
  const BodyDeck uncut = ring;
  const double turns = turns_of(ring, 0.5 * (low + high)), little = grain * cell_angle(whole, uncut);
  const auto replace_face = [&](const std::string& name, bool fixed) {
    std::erase_if(ring.faces, [&](const FaceDeck& face) { return face.face == name; });
    if (fixed) ring.faces.push_back({name, FaceKind::fixed});
  };
  if (is_closed(uncut) || low + turns > uncut.start_angle + little) {
    ring.start_angle = low + turns;
    replace_face("start", ring.fill == Fill::hexes); // the ring goes on
  }
  if (is_closed(uncut) || high + turns < uncut.end_angle - little) {
    ring.end_angle = high + turns;
    replace_face("end", false);
  }
  const Triple cells = find_cells(whole, uncut);
  const double around = (ring.end_angle - ring.start_angle) / cell_angle(whole, uncut);
  ring.cells = {std::max(1, int(std::lround(around))), int(cells[1]), int(cells[2])};
  ring.spacing.reset();
}

double Cutter::find_uncut_chip(double immersion) const {
  const double angle = pi / 2 - motion.about_ring(immersion);
  const double before = bore->previous_tooth
                            ? previous_tooth_surface(tool, bore->origin)(angle, tool.position[2])
                            : bore->inner_radius;
  return motion.tip_radius(immersion) - before;
}

Window Cutter::cut(double centre) const {
  Window window;
  window.centre = centre;
  window.from = centre - 0.5 * windows.width, window.to = centre + 0.5 * windows.width;
  check_place(window);
  const double tens = std::round(centre / degree * 100) / 100;
  window.name = tens == std::round(tens) ? fmt::format("window_{:03.0f}", tens + 0.0)
                                         : fmt::format("window_{:06.2f}", tens);
  window.uncut_chip = find_uncut_chip(centre);

  Deck& deck = window.deck = whole;
  deck.windows.reset(), deck.picked.reset();
  deck.title += fmt::format(", window at {:.6g} deg", centre / degree);
  const Start start = find_start(window.from);
  const double end = line(pi / 2 - motion.about_ring(window.to + windows.ahead), -1);
  for (BodyDeck& body : deck.bodies) cut_ring(body, end, start.end);
  if (!start.as_whole) {
    deck.tool->start_angle = start.immersion;
    deck.tool->position = motion.position(start.immersion);
  }
  deck.run.end_immersion = window.to;
  std::erase_if(deck.output.picture_immersion,
                [&](double view) { return view < deck.tool->start_angle || view > window.to; });
  return window;
}

} // namespace

std::vector<Window> cut_windows(const Deck& whole, const WindowsDeck& windows) {
  if (windows.last < windows.first)
    refuse(whole, windows, "last",
           fmt::format("expected at least first = {:.6g} deg, got {:.6g} deg", windows.first / degree,
                       windows.last / degree));
  const double count = std::floor((windows.last - windows.first) / windows.step * (1 + 1e-12) + 1e-9) + 1;
  if (count > 1000 || windows.step < 0.01 * degree)
    refuse(whole, windows, "step",
           fmt::format("makes {:.0f} windows: expected at most 1000, 0.01 deg apart or more. Make it larger",
                       count));
  const Cutter cutter(whole, windows);
  std::vector<Window> all;
  for (int k = 0; k < int(count); ++k) all.push_back(cutter.cut(windows.first + k * windows.step));
  return all;
}

WindowsDeck read_windows_option(const std::string& text, WindowsDeck windows) {
  const auto fault = [&](const std::string& what) {
    return DeckError(fmt::format(
        "--windows {}: {}. Write first:last:step in degrees of immersion, such as 10:170:20.", text, what));
  };
  const std::vector<std::pair<std::string, double WindowsDeck::*>> parts = {
      {"first", &WindowsDeck::first}, {"last", &WindowsDeck::last}, {"step", &WindowsDeck::step}};
  std::string_view rest = text;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto colon = rest.find(':');
    if ((colon == rest.npos) != (k + 1 == parts.size()))
      throw fault("expected three numbers with : between them");
    const std::string number(rest.substr(0, colon));
    double value = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
    if (error != std::errc{} || end != number.data() + number.size())
      throw fault(fmt::format("\"{}\" is not a number", number));
    const auto key = std::find_if(windows_keys().begin(), windows_keys().end(),
                                  [&](const auto& row) { return row.name == parts[k].first; });
    const Bounds& range = std::get<Bounds>(key->allowed);
    if (!(value >= range.low && value <= range.high) || (range.low_open && value == range.low))
      throw fault(fmt::format("{} must be {}", key->name, describe_bounds(range, Dimension::angle)));
    windows.*parts[k].second = value * degree;
    if (colon != rest.npos) rest.remove_prefix(colon + 1);
  }
  windows.line = 0;
  return windows;
}

double find_effort(const Deck& deck) {
  double cells = 0;
  for (const BodyDeck& body : deck.bodies) cells += count_cells(deck, body);
  return cells * (*deck.run.end_immersion - deck.tool->start_angle);
}

double effort_in_windows(const Deck& deck) {
  double effort = 0;
  for (const Window& window : cut_windows(deck, *deck.windows)) effort += find_effort(window.deck);
  return effort / find_effort(deck);
}

} // namespace swarf
