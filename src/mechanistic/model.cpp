#include "src/mechanistic/model.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace swarf {
namespace {

constexpr double degree = std::numbers::pi / 180, resolution = 0.5; // deg

struct Extent {
  double from, to; // deg
};

// A turn, and what the deck runs through.
Extent extent_of(const Deck& deck) {
  const double start = deck.tool->start_angle / degree;
  const double end = start + end_time_of(deck) * deck.tool->spindle_speed / degree;
  return {resolution * std::floor(std::min(0.0, start) / resolution),
          std::min(std::max(360.0, end), start + 7200)};
}

} // namespace

Coefficients coefficients_of(const MechanisticDeck& m) {
  return {m.K_tc, m.K_rc, m.K_ac, m.K_te, m.K_re, m.K_ae};
}

void set_coefficients(const Coefficients& values, MechanisticDeck& m) {
  m.K_tc = values[0], m.K_rc = values[1], m.K_ac = values[2];
  m.K_te = values[3], m.K_re = values[4], m.K_ae = values[5];
}

std::array<MillLoad, 6> find_shares(const MillEdge& edge, const MillCut& cut, int tooth, double immersion) {
  std::array<MillLoad, 6> shares{};
  const double dz = edge.element_depth();
  for (int element = 0; element < cut.elements; ++element) {
    const EdgePoint point = edge.look(tooth, element, immersion);
    if (point.chip <= 0) continue;
    const double s = std::sin(point.angle), c = std::cos(point.angle);
    const double weights[2] = {point.cuts ? point.chip * dz : 0,
                               dz}; // of the chip's and of the edge's coefficients
    for (std::size_t part = 0; part < 2; ++part) {
      MillLoad *tangential = &shares[3 * part], *radial = tangential + 1, *axial = tangential + 2;
      const double w = weights[part];
      tangential->force[0] -= w * c, tangential->force[1] += w * s, tangential->torque += w * point.radius;
      radial->force[0] -= w * s, radial->force[1] -= w * c;
      axial->force[2] -= w;
    }
  }
  return shares;
}

HistoryTable run_model(const Deck& deck, const MechanisticDeck& model) {
  const MillCut cut = find_cut(deck, model);
  const MillEdge edge(cut);
  const Coefficients k = coefficients_of(model);
  const int teeth = cut.tool.flutes;
  HistoryTable table;
  const auto columns = history_columns(teeth);
  for (const HistoryColumn& column : columns)
    if (column.name == "time" || column.name == "immersion" ||
        column.name.find("force_") != std::string::npos || column.name == "torque")
      table.columns.push_back(column);
  table.columns.push_back({"uncut_chip", "m"}), table.columns.push_back({"without_chip", "1"});
  table.values.resize(table.columns.size());

  const Extent extent = extent_of(deck);
  const int rows = int(std::floor((extent.to - extent.from) / resolution + 1e-9)) + 1;
  for (int row = 0; row < rows; ++row) {
    const double immersion = extent.from + row * resolution;
    HistorySample sample;
    sample.immersion = immersion,
    sample.time = (immersion * degree - cut.tool.start_angle) / cut.tool.spindle_speed;
    for (int tooth = 0; tooth < teeth; ++tooth) {
      const auto shares = find_shares(edge, cut, tooth, immersion * degree);
      for (std::size_t i = 0; i < k.size(); ++i) {
        for (std::size_t a = 0; a < 3; ++a)
          sample.tooth_force[std::size_t(tooth)][a] += k[i] * shares[i].force[a];
        sample.torque += k[i] * shares[i].torque;
      }
      for (std::size_t a = 0; a < 3; ++a) sample.force[a] += sample.tooth_force[std::size_t(tooth)][a];
    }
    const std::vector<double> all = history_row(sample, teeth);
    std::size_t kept = 0;
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (kept < table.columns.size() && columns[c].name == table.columns[kept].name)
        table.values[kept++].push_back(all[c]);
    const EdgePoint first = edge.look(0, 0, immersion * degree);
    table.values[kept++].push_back(first.chip);
    table.values[kept].push_back(edge.share_without_chip(first.angle));
  }
  return table;
}

} // namespace swarf
