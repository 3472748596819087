// STL: binary (80 bytes, count, 50 bytes per facet, little endian) or ASCII. The stored normals are not read:
// the order of the corners tells the outside.
#include "src/tool_geometry.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace swarf {
namespace {

constexpr std::size_t header_size = 84, facet_size = 50;

// Joins corners that are equal to the last bit.
class Builder {
 public:
  explicit Builder(double scale) : scale_(scale) {}
  void add_corner(const Triple& raw) {
    const Triple key{raw[0] + 0.0, raw[1] + 0.0, raw[2] + 0.0}; // -0 and 0 are one
    const auto [entry, is_new] = index_.try_emplace(key, int(surface_.vertices.size()));
    if (is_new) surface_.vertices.push_back({scale_ * key[0], scale_ * key[1], scale_ * key[2]});
    corner_.push_back(entry->second);
    if (corner_.size() == 3) surface_.facets.push_back({corner_[0], corner_[1], corner_[2]}), corner_.clear();
  }
  FacetSurface take() { return std::move(surface_); }
  std::size_t facets() const { return surface_.facets.size(); }

 private:
  double scale_;
  FacetSurface surface_;
  std::map<Triple, int> index_;
  std::vector<int> corner_;
};

void require_finite(const Triple& v, const std::string& file, std::size_t facet) {
  for (const double x : v)
    if (!std::isfinite(x))
      throw DeckError(fmt::format(
          "{}: facet {} has a corner that is not a finite number; export the file again", file, facet + 1));
}

FacetSurface read_binary(const std::string& bytes, const std::string& file, double scale) {
  Builder builder(scale);
  const std::size_t count = (bytes.size() - header_size) / facet_size;
  for (std::size_t f = 0; f < count; ++f)
    for (int k = 0; k < 3; ++k) {
      float raw[3];
      std::memcpy(raw, bytes.data() + header_size + f * facet_size + 12 * (k + 1), sizeof raw);
      const Triple corner{raw[0], raw[1], raw[2]};
      require_finite(corner, file, f);
      builder.add_corner(corner);
    }
  return builder.take();
}

FacetSurface read_ascii(const std::string& bytes, const std::string& file, double scale) {
  Builder builder(scale);
  std::istringstream lines(bytes);
  std::string line;
  int number = 0, corners = 0;
  bool ended = false;
  while (std::getline(lines, line)) {
    ++number;
    std::istringstream words(line);
    std::string word;
    if (!(words >> word)) continue;
    if (word == "vertex") {
      Triple v;
      if (!(words >> v[0] >> v[1] >> v[2]))
        throw DeckError(fmt::format("{}:{}: expected \"vertex x y z\" with three numbers; got \"{}\"", file,
                                    number, line));
      require_finite(v, file, builder.facets());
      builder.add_corner(v), ++corners;
    } else if (word == "endloop" && corners != 3) {
      throw DeckError(fmt::format("{}:{}: facet {} has {} corners instead of 3; export triangles", file,
                                  number, builder.facets() + 1, corners));
    } else if (word == "facet") {
      corners = 0;
    } else if (word == "endsolid") {
      ended = true;
    } else if (word != "solid" && word != "outer" && word != "endloop" && word != "endfacet") {
      throw DeckError(
          fmt::format("{}:{}: \"{}\" is no word of an STL file; export the file again", file, number, word));
    }
  }
  if (!ended)
    throw DeckError(fmt::format("{}: ends after line {} without \"endsolid\": cut short", file, number));
  return builder.take();
}

} // namespace

FacetSurface read_stl(const std::string& file, double metres_per_unit) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw DeckError(file + ": cannot be read; give tool.file as a path relative to the deck");
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.good() && !stream.eof()) throw DeckError(file + ": cannot be read to its end; is it a file?");
  std::uint32_t count = 0;
  if (bytes.size() >= header_size) std::memcpy(&count, bytes.data() + 80, sizeof count);
  const std::size_t expected = header_size + facet_size * count;
  if (bytes.size() >= header_size && bytes.size() == expected)
    return read_binary(bytes, file, metres_per_unit);
  if (bytes.compare(0, 5, "solid") == 0) return read_ascii(bytes, file, metres_per_unit);
  throw DeckError(
      fmt::format("{}: neither an ASCII STL (begins with \"solid\") nor a whole binary one ({} facets need "
                  "{} bytes, the file has {}); export or copy it again",
                  file, count, expected, bytes.size()));
}

void write_stl(const FacetSurface& surface, const std::string& file) {
  std::string bytes(header_size, '\0');
  const char title[] = "swarf tool, metres";
  std::memcpy(bytes.data(), title, sizeof title - 1);
  const std::uint32_t count = std::uint32_t(surface.facets.size());
  std::memcpy(bytes.data() + 80, &count, sizeof count);
  for (const auto& facet : surface.facets) {
    Triple p[3];
    for (int k = 0; k < 3; ++k) p[k] = surface.vertices[facet[k]];
    Triple u, v;
    for (int d = 0; d < 3; ++d) u[d] = p[1][d] - p[0][d], v[d] = p[2][d] - p[0][d];
    const Triple n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    float row[12];
    for (int d = 0; d < 3; ++d) {
      row[d] = float(n[d] / length);
      for (int k = 0; k < 3; ++k) row[3 + 3 * k + d] = float(p[k][d]);
    }
    bytes.append(reinterpret_cast<const char*>(row), sizeof row).append(2, '\0');
  }
  std::ofstream stream(file, std::ios::binary);
  stream.write(bytes.data(), std::streamsize(bytes.size()));
  stream.flush();
  if (!stream) throw DeckError(file + ": cannot be written; check the folder and the space on the disk");
}

} // namespace swarf
