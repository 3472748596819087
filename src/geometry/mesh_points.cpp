// Meshes of particles: rows x, y, z, volume.
#include "src/files/results.hpp"
#include "src/geometry/body_file.hpp"
#include "src/geometry/mesh_text.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace swarf {

// Particles: a row each, "x, y, z, volume" and the names of the sets that it is in.
PointSet read_mesh_points(const BodyDeck& body, const std::string& file) {
  PointSet set;
  const auto keywords = read_mesh_text(read_text(file));
  if (keywords.size() > 1)
    refuse_line(file, keywords[1].line,
                "a mesh of particles has no keywords: expected rows \"x, y, z, volume\"");
  const double s = body.file_scale;
  for (const MeshRow& row : keywords.front().rows) {
    if (row.fields.size() < 4)
      refuse_line(file, row.line,
                  fmt::format("has {} numbers: expected x, y, z and the volume", row.fields.size()));
    Point x;
    for (std::size_t d = 0; d < 3; ++d) x[int(d)] = body.origin[d] + s * number_in(row, d, file);
    const double volume = s * s * s * number_in(row, 3, file);
    if (!(volume > 0)) refuse_line(file, row.line, "has a volume that is not more than 0");
    for (std::size_t f = 4; f < row.fields.size(); ++f) {
      set.faces[row.fields[f]].push_back(int(set.position.size()));
      set.behind[row.fields[f]].push_back(-1);
    }
    set.position.push_back(x), set.volume.push_back(volume), set.gap.push_back(0.5 * std::cbrt(volume));
  }
  if (set.position.empty()) throw DeckError(file + ": holds no particle: expected rows \"x, y, z, volume\"");
  const auto [least, most] = std::minmax_element(set.volume.begin(), set.volume.end());
  if (*most > 8 * *least)
    throw DeckError(
        fmt::format("{}: has volumes from {:.4g} to {:.4g} m3: expected at most 8 times as much as the "
                    "least, since the kernels of a body have one size; make several bodies of it",
                    file, *least, *most));
  double sum = 0;
  for (const double v : set.volume) sum += v;
  set.spacing = std::cbrt(sum / double(set.volume.size()));
  return set;
}

// The cubic lattice through the first particle, which must be that of all.
PointSet continue_points_of_mesh(const Shape& shape, int layers) {
  const PointSet& own = shape.file->points;
  const double s = own.spacing;
  const Point first = own.position.front();
  const auto place = [&](const Point& x) -> Point { return (x - first) / s; };
  for (const Point& x : own.position) {
    const Point at = place(x);
    const double off = (at - Point(at.array().round().matrix())).cwiseAbs().maxCoeff();
    if (off > 0.05)
      reject(
          *shape.deck, *shape.body, "tie",
          fmt::format(
              "is tied, and its particle at ({:.6g}, {:.6g}, {:.6g}) m is not on the cubic lattice of "
              "{:.6g} m, the cube root of its mean volume, through its first one: expected a lattice along "
              "x, y, z, which goes on into the hexes. Make it one, or leave tie out",
              x.x(), x.y(), x.z(), s));
  }
  const Point low = place(shape.file->box.min()), high = place(shape.file->box.max());
  std::array<int, 3> from{}, to{};
  for (int d = 0; d < 3; ++d)
    from[std::size_t(d)] = int(std::floor(low[d])) - layers,
    to[std::size_t(d)] = int(std::ceil(high[d])) + layers;
  PointSet set;
  for (int i = from[0]; i <= to[0]; ++i)
    for (int j = from[1]; j <= to[1]; ++j)
      for (int k = from[2]; k <= to[2]; ++k) {
        const Point x = first + s * Point(i, j, k);
        if (shape.signed_distance(x) > 0) set.position.push_back(x), set.volume.push_back(s * s * s);
      }
  return set;
}

} // namespace swarf
