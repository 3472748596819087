// 15. Heat of friction under a slider: a band that moves over a half space, and what it keeps for itself.
// References: the instantaneous line source of Carslaw & Jaeger (1959, sec. 10.3), integrated over the band
// and over time, which tends to Jaeger's moving band (Proc. R. Soc. N.S.W. 76 (1942) 203) and is exact before
// that, too; the partition as Blok (1937) and Jaeger have it, from equal mean temperatures of both surfaces
// under an even flux, here at every time.
#include "src/tool/geometry.hpp"
#include "tests/verification/case.hpp"
#include "tests/verification/drive.hpp"

using namespace swarf;
using namespace swarf::test;

namespace {

constexpr double k = 7.2, rho = 4430, c = 526.3, alpha = k / (rho * c); // Ti-6Al-4V
constexpr double k_tool = 46, rho_tool = 15000, c_tool = 203;           // WC-Co
constexpr double half = 8 * um, start = 300;                            // m, of the band; K
const std::string source = "Jaeger 1942; Carslaw & Jaeger 1959, sec. 10.3";

struct Slide {
  double cells;          // along half of the band
  double peclet;         // V l / (2 alpha), Jaeger's L
  bool conducts = false; // the slider
  double spacing() const { return half / cells; }
  double speed() const { return 2 * alpha * peclet / half; }
  double way() const { return (peclet < 1 ? 2 : peclet < 5 ? 3 : 4) * half; }
  double time() const { return way() / speed(); }
  double margin() const { // four diffusion lengths, in whole bands' tenths
    return std::ceil(40 * std::sqrt(alpha * time()) / half) / 10 * half;
  }
};

FacetSurface slider(double width, double height) {
  FacetSurface box;
  for (int v = 0; v < 8; ++v)
    box.vertices.push_back({v & 1 ? half : -half, v & 2 ? height : 0, v & 4 ? 2 * width : -width});
  box.facets = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return box;
}

// The surface is y = 0. The springs are too weak to move anything, and press evenly.
Deck deck_of(const Slide& s, const TemporaryFolder& folder) {
  Deck deck = empty_deck();
  deck.materials[0].conductivity = k;
  const double dx = s.spacing(), down = s.margin(), along = 2 * half + s.way() + 2 * s.margin();
  const double side = dx;
  const double left = -half - s.margin();
  deck.bodies = {block("work", "hexes", {left, -down, 0}, {along, down, side}, dx)};
  for (BodyDeck& body : deck.bodies) {
    body.temperature = start;
    for (const char* face : {"z_min", "z_max"}) body.faces.push_back({face, FaceKind::periodic, {}});
  }
  ToolDeck tool(ToolKind::stl);
  tool.file = (folder / "slider.stl").string(), tool.file_scale = 1;
  write_stl(slider(side, 10 * half), tool.file);
  tool.position = {0, -0.0005 * dx, 0}, tool.velocity = {s.speed(), 0, 0}, tool.temperature = start;
  if (s.conducts) {
    MaterialDeck carbide(Law::rigid);
    carbide.name = "carbide";
    carbide.density = rho_tool, carbide.specific_heat = c_tool, carbide.conductivity = k_tool;
    deck.materials.push_back(carbide);
    tool.material = "carbide";
  } else {
    deck.contact.heat_to_workpiece = 1;
  }
  deck.tool = tool;
  deck.contact.stiffness = 1e-6, deck.contact.friction = 0.5;
  deck.run.end_time = s.time();
  deck.run.courant = 0.3, deck.run.mass_factor = 1e5 * std::pow(dx / um, 2);
  return deck;
}

struct Outcome {
  double time, flux;               // s; W/m2, mean over the band
  double tool_share;               // of the heat that was made
  std::vector<double> ahead, rise; // m, of the band's middle; K, of the outer row
};

Outcome run(const Slide& s) {
  const TemporaryFolder folder;
  Simulation simulation(deck_of(s, folder));
  simulation.start();
  run_until(simulation, s.time() * (1 - 1e-9), [] {});
  simulation.check();
  const HistorySample sample = simulation.take_sample();
  const Scene& scene = simulation.scene();
  const double side = s.spacing();
  Outcome o{sample.time,
            sample.frictional / (2 * half * side * sample.time),
            sample.tool_heat / sample.frictional,
            {},
            {}};
  const auto x = host_copy(scene.hexes.position);
  const auto T = host_copy(scene.hexes.nodal_temperature);
  for (int i = 0; i < scene.hexes.nodes; ++i)
    if (std::abs(double(x(i, 1))) < 0.1 * s.spacing() && std::abs(double(x(i, 2))) < 0.1 * s.spacing())
      o.ahead.push_back(double(x(i, 0)) - s.speed() * sample.time), o.rise.push_back(double(T(i)) - start);
  return o;
}

// What a unit of flux made over the band `lag` ago does per unit of sqrt(lag), at `x` ahead of its middle of
// now and `y` below the surface.
double influence(double speed, double lag, double x, double y) {
  const double s = 2 * std::sqrt(alpha * lag), at = x + speed * lag;
  return std::exp(-y * y / (s * s)) * (std::erf((at + half) / s) - std::erf((at - half) / s)) /
         (rho * c * std::sqrt(pi * alpha));
}

// The same since the start, of one W/m2. Midpoints in sqrt(lag).
double rise_of(double speed, double time, double x, double y) {
  constexpr int n = 4000;
  const double du = std::sqrt(time) / n;
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += influence(speed, std::pow((i + 0.5) * du, 2), x, y) * du;
  return sum;
}

struct Errors {
  double maximum, profile; // of the largest rise; root mean square over the band, both over the largest rise
  double ours, reference;  // K m2/W, largest rise per flux
};

Errors compare(const Slide& s, const Outcome& o) {
  Errors e{0, 0, 0, 0};
  double squares = 0;
  int count = 0;
  for (std::size_t i = 0; i < o.ahead.size(); ++i) {
    if (std::abs(o.ahead[i]) > 2 * half) continue;
    const double exact = rise_of(s.speed(), o.time, o.ahead[i], 0), ours = o.rise[i] / o.flux;
    e.ours = std::max(e.ours, ours), e.reference = std::max(e.reference, exact);
    if (std::abs(o.ahead[i]) <= half) squares += (ours - exact) * (ours - exact), ++count;
  }
  e.maximum = relative_error(e.ours, e.reference);
  e.profile = std::sqrt(squares / count) / e.reference;
  return e;
}

std::string name_of(const Slide& s) {
  char text[80];
  std::snprintf(text, sizeof text, "15 moving band at Pe %g, hexes", s.peclet);
  return text;
}

void report_band(const Slide& s, const Errors& e) {
  char how[80];
  std::snprintf(how, sizeof how, "%g cells along half of the band", s.cells);
  report({name_of(s), "largest rise of the outer row per flux", how, e.reference * 1e6, "K mm2/W", source,
          e.ours * 1e6, e.maximum, 0.05});
  report({name_of(s), "profile under the band, mean square error over the largest rise", how, 0, "", source,
          e.profile, e.profile, 0.05, true});
}

void slide_at_three(double peclet, std::array<double, 3> cells) {
  std::array<double, 3> size{}, error{};
  for (std::size_t r = 0; r < 3; ++r) {
    const Slide s{cells[r], peclet};
    const Outcome o = run(s);
    const Errors e = compare(s, o);
    size[r] = s.spacing(), error[r] = e.profile;
    if (r == 2) report_band(s, e);
  }
  char how[80];
  std::snprintf(how, sizeof how, "%g, %g, %g cells along half of the band", cells[0], cells[1], cells[2]);
  report_order(name_of({cells[2], peclet}), "profile under the band", how, size, error, 1, 0.3,
               "first order at the ends of the band");
}

// Share of the heat of an even flux that a slider with insulated sides takes, from its start: both surfaces
// have one mean temperature, the slider's by 1 / (e sqrt(pi lag)), the work's by the band that moves.
double share_of_slider(double speed, double time) {
  constexpr int n = 400, parts = 40, points = 40;
  const double dt = time / n, e_tool = std::sqrt(k_tool * rho_tool * c_tool);
  std::vector<double> tool(n), work(n); // what an even flux in step m of the past has done to the means
  for (int m = 0; m < n; ++m) {
    tool[std::size_t(m)] = 2 * (std::sqrt((m + 1) * dt) - std::sqrt(m * dt)) / (e_tool * std::sqrt(pi));
    const double from = std::sqrt(m * dt), du = (std::sqrt((m + 1) * dt) - from) / parts;
    double sum = 0;
    for (int p = 0; p < parts; ++p)
      for (int i = 0; i < points; ++i)
        sum +=
            influence(speed, std::pow(from + (p + 0.5) * du, 2), ((i + 0.5) / points * 2 - 1) * half, 0) * du;
    work[std::size_t(m)] = sum / points;
  }
  std::vector<double> q(n); // of the slider, of 1
  double taken = 0;
  for (int j = 0; j < n; ++j) {
    double before = 0;
    for (int i = 0; i < j; ++i)
      before +=
          q[std::size_t(i)] * tool[std::size_t(j - i)] - (1 - q[std::size_t(i)]) * work[std::size_t(j - i)];
    q[std::size_t(j)] = (work[0] - before) / (tool[0] + work[0]);
    taken += q[std::size_t(j)] / n;
  }
  return taken;
}

void divide(double peclet, std::array<double, 3> cells) {
  std::array<double, 3> size{}, error{};
  double share = 0, reference = 0;
  for (std::size_t r = 0; r < 3; ++r) {
    const Slide s{cells[r], peclet, true};
    const Outcome o = run(s);
    share = o.tool_share, reference = share_of_slider(s.speed(), o.time);
    size[r] = s.spacing(), error[r] = relative_error(share, reference);
  }
  char name[80], how[120];
  std::snprintf(name, sizeof name, "15 slider that conducts, Pe %g, hexes", peclet);
  std::snprintf(how, sizeof how, "WC-Co on Ti-6Al-4V, %g, %g, %g cells; errors %.2g, %.2g, %.2g", cells[0],
                cells[1], cells[2], error[0], error[1], error[2]);
  report({name, "share of the friction heat that the slider takes", how, reference, "",
          "Blok 1937; Jaeger 1942: equal mean temperatures", share, error[2], 0.05});
}

} // namespace

TEST(VerifySlidingHeat, BandOnHexesAtPe2) { slide_at_three(2, {3, 6, 12}); }
TEST(VerifySlidingHeat, BandOnHexesAtPe10) { slide_at_three(10, {3, 6, 12}); }
TEST(VerifySlidingHeatLong, BandOnHexesAtPeHalf) { slide_at_three(0.5, {3, 6, 12}); }
TEST(VerifySlidingHeat, SliderOnHexesAtPe2) { divide(2, {3, 6, 12}); }
TEST(VerifySlidingHeat, SliderOnHexesAtPe10) { divide(10, {3, 6, 12}); }
