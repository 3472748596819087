#include "src/files/results.hpp"
#include "src/surface/surface.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace swarf {
namespace {

struct Piece { // of the work: a particle or a hex
  SurfacePlace at;
  double volume, size; // m3, m
  double along, across, normal, plastic_strain, temperature;
  int identity; // -1: a hex
};

// Stress in the directions of the surface; xx yy zz xy yz zx.
void resolve(const PointFields& state, std::size_t i, Piece& piece) {
  const float* s = &state.stress[6 * i];
  Eigen::Matrix3d stress;
  stress << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  const Eigen::Vector3d &a = piece.at.direction, &n = piece.at.normal, z(0, 0, 1);
  piece.along = a.dot(stress * a), piece.normal = n.dot(stress * n), piece.across = z.dot(stress * z);
  piece.plastic_strain = state.equivalent_plastic_strain[i], piece.temperature = state.temperature[i];
  piece.volume = state.volume[i], piece.size = std::cbrt(piece.volume);
}

std::vector<Piece> list_pieces(const MachinedSurface& surface, const FrameData& frame) {
  std::vector<Piece> pieces;
  const auto& p = frame.particles;
  for (std::size_t i = 0; 3 * i < p.position.size(); ++i) {
    if (!p.retired.empty() && p.retired[i] != 0) continue;
    Piece piece{};
    piece.at = surface.place({p.position[3 * i], p.position[3 * i + 1], p.position[3 * i + 2]});
    piece.identity = p.identity[i];
    resolve(p.state, i, piece);
    pieces.push_back(piece);
  }
  const auto& h = frame.hexes;
  for (std::size_t e = 0; 8 * e < h.connectivity.size(); ++e) {
    if (!h.active.empty() && h.active[e] == 0) continue;
    Eigen::Vector3d middle(0, 0, 0);
    for (std::size_t a = 0; a < 8; ++a)
      for (int d = 0; d < 3; ++d)
        middle[d] += h.position[3 * std::size_t(h.connectivity[8 * e + a]) + std::size_t(d)] / 8;
    Piece piece{};
    piece.at = surface.place(middle), piece.identity = -1;
    resolve(h.state, e, piece);
    pieces.push_back(piece);
  }
  return pieces;
}

double finest_of(const std::vector<Piece>& pieces) {
  double sum = 0;
  int count = 0;
  for (const Piece& p : pieces)
    if (p.identity >= 0) sum += p.size, ++count;
  if (count > 0) return sum / count;
  double least = std::numeric_limits<double>::infinity();
  for (const Piece& p : pieces) least = std::min(least, p.size);
  return least;
}

// What hangs together from below: the first gap of more than one and a half sizes ends the work, and what is
// beyond is chip. Returns the top of what is left.
double top_of(std::vector<const Piece*>& strip) {
  std::sort(strip.begin(), strip.end(),
            [](const Piece* a, const Piece* b) { return a->at.above < b->at.above; });
  double reached = strip.front()->at.above, top = reached + 0.5 * strip.front()->size;
  std::size_t k = 1;
  for (;
       k < strip.size() && strip[k]->at.above - reached < 1.5 * std::max(strip[k]->size, strip[k - 1]->size);
       ++k)
    reached = strip[k]->at.above, top = std::max(top, reached + 0.5 * strip[k]->size);
  strip.resize(k);
  return top;
}

void add_layers(WorkSurface& w, const std::vector<const Piece*>& work) {
  std::map<int, std::vector<const Piece*>> layers;
  for (const Piece* p : work) {
    const double depth = w.mean_height - p->at.above;
    layers[std::max(0, int(std::floor(depth / w.spacing)))].push_back(p); // what stands out is of the first
  }
  for (const auto& [row, pieces] : layers) {
    DepthLayer l;
    double along2 = 0, across2 = 0, depth = 0;
    for (const Piece* p : pieces) {
      l.volume += p->volume, depth += p->volume * (w.mean_height - p->at.above);
      l.along += p->volume * p->along, l.across += p->volume * p->across, l.normal += p->volume * p->normal;
      along2 += p->volume * p->along * p->along, across2 += p->volume * p->across * p->across;
      l.plastic_strain += p->volume * p->plastic_strain, l.temperature += p->volume * p->temperature;
      if (row == 0 && p->identity >= 0) w.outermost.push_back(p->identity);
    }
    for (double* mean : {&l.along, &l.across, &l.normal, &l.plastic_strain, &l.temperature})
      *mean /= l.volume;
    l.depth = depth / l.volume;
    l.along_scatter = std::sqrt(std::max(0.0, along2 / l.volume - l.along * l.along));
    l.across_scatter = std::sqrt(std::max(0.0, across2 / l.volume - l.across * l.across));
    w.layers.push_back(l);
  }
}

} // namespace

WorkSurface measure_surface(const MachinedSurface& surface, const FrameData& frame, double share) {
  const std::vector<Piece> pieces = list_pieces(surface, frame);
  WorkSurface w;
  w.spacing = finest_of(pieces);
  const double passed = surface.passed(frame.time);
  std::map<int, std::vector<const Piece*>> strips; // of what the tip has passed
  for (const Piece& p : pieces)
    if (p.at.along < passed) strips[int(std::floor(p.at.along / w.spacing))].push_back(&p);
  // The cut begins with the first strip that has something within a spacing of the surface.
  double begin = passed;
  std::map<int, double> top;
  w.burr = -std::numeric_limits<double>::infinity();
  for (auto& [row, strip] : strips) {
    const double height = top_of(strip), along = (row + 0.5) * w.spacing;
    if (height < -2 * w.spacing || along < 0) continue; // beside the work, or where the tool never was
    top[row] = height, begin = std::min(begin, along);
    if (height > w.burr) w.burr = height, w.burr_along = along;
  }
  if (top.empty())
    throw ResultsError("the tool has cut nothing off by the last frame: there is no new surface to look at");
  w.from = begin + share * (passed - begin), w.to = passed - share * (passed - begin);
  std::vector<const Piece*> work;
  for (const auto& [row, height] : top) {
    const double along = (row + 0.5) * w.spacing;
    if (along < w.from || along > w.to) continue;
    w.strip.push_back(along), w.height.push_back(height);
    work.insert(work.end(), strips[row].begin(), strips[row].end());
  }
  if (w.strip.empty())
    throw ResultsError(
        "less than a spacing of the new surface is left to look at: let the tool cut farther, or give "
        "a smaller --skip");
  for (const double h : w.height) w.mean_height += h / double(w.height.size());
  const auto [least, most] = std::minmax_element(w.height.begin(), w.height.end());
  for (const double h : w.height) w.Ra += std::abs(h - w.mean_height) / double(w.height.size());
  w.Rz = *most - *least;
  add_layers(w, work);
  return w;
}

} // namespace swarf
