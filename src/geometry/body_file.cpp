#include "src/geometry/body_file.hpp"
#include "src/files/results.hpp"
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <list>
#include <mutex>

namespace swarf {
namespace {

namespace fs = std::filesystem;

BodyFile read_surface(const BodyDeck& body) {
  const FacetSurface surface = read_stl(body.file, body.file_scale);
  check_surface(surface, body.file);
  check_parts(surface, body.file);
  BodyFile file;
  file.surface = std::make_shared<ClosedSurface>(surface, body.origin);
  file.volume = file.surface->volume(), file.box = file.surface->box();
  std::string corners;
  for (const auto& facet : surface.facets)
    for (const int v : facet)
      corners.append(reinterpret_cast<const char*>(surface.vertices[std::size_t(v)].data()),
                     3 * sizeof(double));
  file.contents = fmt::format("{} facets with the checksum {}", surface.facets.size(), hash_text(corners));
  return file;
}

// A file that changes is another one.
struct Known {
  std::string path;
  fs::file_time_type written;
  std::uintmax_t bytes;
  BodyShape shape;
  Fill fill;
  Triple origin;
  double scale;
  bool operator==(const Known&) const = default;
};

} // namespace

std::shared_ptr<const BodyFile> read_body_file(const Deck& deck, const BodyDeck& body) {
  constexpr std::size_t most = 16; // files kept in memory
  static std::mutex turn;
  static std::list<std::pair<Known, std::shared_ptr<const BodyFile>>> read;
  const std::lock_guard lock(turn);
  std::error_code time, size;
  const Known asked{body.file,
                    fs::last_write_time(body.file, time),
                    fs::file_size(body.file, size),
                    body.shape,
                    body.fill,
                    body.origin,
                    body.file_scale};
  const auto at = std::find_if(read.begin(), read.end(), [&](const auto& one) { return one.first == asked; });
  if (at != read.end() && !time && !size) return at->second;
  try {
    const bool is_stl = body.shape == BodyShape::stl;
    read.emplace_front(
        asked, std::make_shared<const BodyFile>(is_stl ? read_surface(body) : read_mesh(body, body.file)));
  } catch (const DeckError& error) {
    reject(deck, body, "file", fmt::format("cannot be filled: {}", error.what()));
  }
  if (read.size() > most) read.pop_back();
  return read.front().second;
}

// From particles: from their cubes, along the axis where it is greatest, which is at most the distance.
double BodyFile::signed_distance(const Point& x) const {
  if (surface) return surface->signed_distance(x);
  const auto from_cube = [&](const FacetTree::Box& cube) {
    return (cube.min() - x).cwiseMax(x - cube.max()).maxCoeff();
  };
  double least = std::numeric_limits<double>::infinity();
  cubes->search([&](const FacetTree::Box& cube) { return from_cube(cube) < least; }, from_cube,
                [&](int row) { least = std::min(least, from_cube(cubes->box(row))); });
  return least;
}

} // namespace swarf
