#include "src/accuracy/chart.hpp"
#include "src/deck/section.hpp"
#include <numbers>

namespace swarf {

std::string accuracy_chart_text(); // made by CMake

namespace {

template <class T>
T get(const toml::table& table, const std::string& key) {
  if (const auto value = table[key].value<T>()) return *value;
  throw std::runtime_error("accuracy chart: " + key + " is missing or of another type");
}

ChartPoint read_point(const toml::table& table) {
  ChartPoint p;
  p.label = get<std::string>(table, "label"), p.runs = get<int>(table, "runs");
  p.chip_rows = get<double>(table, "chip_rows"), p.slice_rows = get<int>(table, "slice_rows");
  p.wave_over_speed = get<double>(table, "wave_over_speed"), p.courant = get<double>(table, "courant");
  p.bulk = get<bool>(table, "bulk");
  p.sleep_rows = get<double>(table, "sleep_rows");
  p.run_in = get<double>(table, "run_in"), p.measured = get<double>(table, "measured");
  p.error = get<double>(table, "error"), p.standard_error = get<double>(table, "standard_error");
  p.level = table["level"].value<double>();
  p.step = get<double>(table, "step");
  p.seconds_per_particle_step = get<double>(table, "seconds_per_particle_step");
  DeckReport report("accuracy chart, " + p.label);
  const toml::table* particles = table["particles"].as_table();
  if (!particles) throw std::runtime_error("accuracy chart: " + p.label + " has no particles");
  read_keys(*particles, "particles", particles_keys(), p.particles, report);
  report.throw_if_any();
  return p;
}

WindowsPoint read_windows(const toml::table& table) {
  const auto angle = [&](const char* key) { return std::numbers::pi / 180 * get<double>(table, key); };
  return {get<double>(table, "chip_rows"),
          get<int>(table, "count"),
          angle("run_in"),
          angle("width"),
          angle("ahead"),
          get<double>(table, "error"),
          get<double>(table, "standard_error")};
}

AccuracyChart read_chart(const std::string& tool, const toml::table& table) {
  AccuracyChart chart;
  chart.tool = value_of_word<ToolKind>(tool), chart.title = get<std::string>(table, "title"),
  chart.deck = get<std::string>(table, "deck");
  chart.where = get<std::string>(table, "where");
  chart.uncertainty = get<double>(table, "uncertainty");
  chart.edge_over_chip = get<double>(table, "edge_over_chip"), chart.rake = get<double>(table, "rake");
  chart.depth = get<double>(table, "depth");
  const toml::array* points = table["points"].as_array();
  if (!points) throw std::runtime_error("accuracy chart: " + tool + " has no points");
  for (auto&& point : *points) chart.points.push_back(read_point(*point.as_table()));
  if (const toml::array* windows = table["windows"].as_array())
    for (auto&& one : *windows) chart.windows.push_back(read_windows(*one.as_table()));
  return chart;
}

} // namespace

std::vector<AccuracyChart> read_accuracy_charts(const std::string& text) {
  std::vector<AccuracyChart> charts;
  const toml::table root = toml::parse(text, std::string_view("accuracy_chart.toml"));
  for (auto&& [tool, chart] : root) charts.push_back(read_chart(std::string(tool.str()), *chart.as_table()));
  return charts;
}

const std::vector<AccuracyChart>& accuracy_charts() {
  static const std::vector<AccuracyChart> charts = read_accuracy_charts(accuracy_chart_text());
  return charts;
}

} // namespace swarf
