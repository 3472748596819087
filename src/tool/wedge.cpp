// Tools with plane faces: the wedge of orthogonal and oblique cutting, and the wall.
#include "src/tool/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swarf {

FacetSurface make_wedge(const ToolDeck& tool) {
  constexpr double pi = std::numbers::pi;
  const double rake = tool.rake, clearance = tool.clearance, rho = tool.edge_radius;
  const double rise = tool.height - rho - rho * std::sin(rake); // of the rake face
  if (rake + clearance >= pi / 2 || std::abs(rake) >= pi / 2 || clearance < 0)
    throw DeckError("tool.rake: rake plus clearance must be less than 90 deg, and clearance at least 0");
  if (!(rise > 0))
    throw DeckError("tool.height: must reach beyond the rounded edge; take at least 2 edge_radius");

  Section section = round_edge({0, rho}, rho, 1.5 * pi - clearance, 1.5 * pi, 2 * pi + rake);
  const auto edge_end = section.back(), edge_begin = section.front();
  const double length = rise / std::cos(rake);
  const double back_x = -length * std::cos(clearance), back_y = length * std::sin(clearance);
  const double top_x = edge_end[0] - rise * std::tan(rake);
  section.push_back({top_x, tool.height});
  section.push_back({top_x + back_x, tool.height + back_y});
  section.push_back({edge_begin[0] + back_x, edge_begin[1] + back_y});

  // Cut along z, so that the narrow facets of the edge are not needles.
  const double step = rho > 0 ? 2 * rho : tool.width;
  const int parts = int(std::clamp(std::ceil(tool.width / step), 1.0, 50.0));
  std::vector<Layer> layers;
  for (int l = 0; l <= parts; ++l) layers.push_back({tool.width * (double(l) / parts - 0.5), 0});
  FacetSurface surface = loft(section, layers);
  const double c = std::cos(tool.inclination), s = std::sin(tool.inclination);
  for (Triple& v : surface.vertices) v = {c * v[0] + s * v[2], v[1], -s * v[0] + c * v[2]};
  return surface;
}

FacetSurface make_wall(const ToolDeck& tool) {
  const double length = std::hypot(tool.normal[0], tool.normal[1], tool.normal[2]);
  if (!(length > 0))
    throw DeckError("tool.normal: has no length; give the outward normal of the wall's face");
  Triple n = tool.normal;
  for (double& component : n) component /= length;
  // Two directions in the plane, from the axis that is farthest from the normal.
  const int a =
      int(std::min_element(n.begin(), n.end(), [](double p, double q) { return std::abs(p) < std::abs(q); }) -
          n.begin());
  Triple u{};
  u[a] = 1;
  const double along = n[a];
  for (int k = 0; k < 3; ++k) u[k] -= along * n[k];
  const double u_length = std::hypot(u[0], u[1], u[2]);
  for (double& component : u) component /= u_length;
  const Triple w{n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0]};

  const double half = tool.size / 2;
  FacetSurface surface =
      loft({{-half, -half}, {half, -half}, {half, half}, {-half, half}}, {{-tool.size / 4, 0}, {0, 0}});
  for (Triple& v : surface.vertices) {
    const Triple local = v;
    for (int k = 0; k < 3; ++k) v[k] = local[0] * u[k] + local[1] * w[k] + local[2] * n[k];
  }
  return surface;
}

} // namespace swarf
