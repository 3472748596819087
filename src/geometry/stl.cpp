// STL: binary (80 bytes, count, 50 bytes per facet, little endian; what follows is not read) or ASCII. The
// stored normals are not read: the order of the corners tells the outside.
#include "src/files/results.hpp"
#include "src/geometry/flat_facets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

namespace swarf {
namespace {

constexpr std::size_t header_size = 84, facet_size = 50;

// Joins corners that are equal to the last bit, and leaves out facets of which two are: they bound nothing,
// and their neighbours share the edge without them.
class Builder {
 public:
  explicit Builder(double scale) : scale_(scale) {}
  void add_corner(const Triple& raw) {
    const Triple key{raw[0] + 0.0, raw[1] + 0.0, raw[2] + 0.0}; // -0 and 0 are one
    const auto [entry, is_new] = index_.try_emplace(key, int(surface_.vertices.size()));
    if (is_new) surface_.vertices.push_back({scale_ * key[0], scale_ * key[1], scale_ * key[2]});
    corner_.push_back(entry->second);
    if (corner_.size() < 3) return;
    const auto& [a, b, c] = std::array{corner_[0], corner_[1], corner_[2]};
    if (a == b || b == c || c == a)
      ++surface_.collapsed;
    else
      surface_.facets.push_back({a, b, c});
    corner_.clear();
  }
  FacetSurface take() { return std::move(surface_); }
  std::size_t facets() const {
    return surface_.facets.size() + std::size_t(surface_.collapsed);
  } // read so far

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

FacetSurface read_binary(const std::string& bytes, std::size_t count, const std::string& file, double scale) {
  Builder builder(scale);
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

// The words of an ASCII file, in lower case, with the line that each stands in. Lines may end as they like.
class TextWords {
 public:
  TextWords(const std::string& bytes, const std::string& name) : text(bytes), file(name) {}

  std::string next() { // "" at the end
    while (at < text.size() && is_blank(text[at])) step();
    std::string word;
    for (; at < text.size() && !is_blank(text[at]); ++at)
      word += char(std::tolower(static_cast<unsigned char>(text[at])));
    return word;
  }
  // Names and what else writers add: to the end of the line, or to the first facet on it.
  void skip_line() {
    while (at < text.size() && text[at] != '\n' && text[at] != '\r') {
      const std::size_t begin = at;
      if (next() == "facet") {
        at = begin;
        return;
      }
      while (at < text.size() && (text[at] == ' ' || text[at] == '\t')) ++at;
    }
  }
  double number() {
    std::string word = next();
    const std::string written = word;
    std::replace(word.begin(), word.end(), 'd', 'e'); // Fortran's double precision: 1.5D-02
    if (word.starts_with('+')) word.erase(0, 1);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_tiny = error == std::errc::result_out_of_range && word.find("e-") != word.npos;
    if (is_tiny) return 0;
    if (error != std::errc{} || end != word.data() + word.size())
      fail(fmt::format("expected \"vertex x y z\" with three numbers; got \"{}\"", written));
    return value;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw DeckError(fmt::format("{}:{}: {}", file, line, what));
  }
  int line_number() const { return line; }

 private:
  static bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
  void step() {
    if (text[at] == '\n' || (text[at] == '\r' && (at + 1 == text.size() || text[at + 1] != '\n'))) ++line;
    ++at;
  }
  const std::string& text;
  std::string file;
  std::size_t at = 0;
  int line = 1;
};

// As most readers do: upper or lower case, "end loop" for "endloop", several solids, no "endsolid" after the
// last facet. A file that is cut short is found by the facet that it cuts, or by the hole that it leaves.
FacetSurface read_ascii(const std::string& bytes, const std::string& file, double scale) {
  Builder builder(scale);
  TextWords words(bytes, file);
  int corners = 0;
  bool in_facet = false;
  for (std::string word = words.next(); !word.empty(); word = words.next()) {
    if (word == "end") word += words.next();
    if (word == "solid" || word == "endsolid" || word == "color" || word.starts_with('#')) {
      words.skip_line();
    } else if (word == "facet") {
      corners = 0, in_facet = true;
    } else if (word == "normal") { // is not read, and some write nan here
      for (int k = 0; k < 3; ++k) words.next();
    } else if (word == "vertex") {
      Triple v;
      for (double& x : v) x = words.number();
      require_finite(v, file, builder.facets());
      if (++corners > 3)
        words.fail(fmt::format("facet {} has more than 3 corners; export triangles", builder.facets() + 1));
      builder.add_corner(v);
    } else if (word == "endloop" && corners != 3) {
      words.fail(fmt::format("facet {} has {} corners instead of 3; export triangles", builder.facets() + 1,
                             corners));
    } else if (word == "endfacet") {
      in_facet = false;
    } else if (word != "outer" && word != "loop" && word != "endloop") {
      words.fail(fmt::format("\"{}\" is no word of an STL file; export the file again", word));
    }
  }
  if (in_facet)
    throw DeckError(
        fmt::format("{}: ends after line {} in the middle of a facet: cut short; export or copy it again",
                    file, words.line_number()));
  return builder.take();
}

// Where the text of an ASCII file begins, after what editors put before it; npos for a binary one, which may
// begin with "solid", too.
std::size_t find_text(const std::string& start) {
  std::size_t at = start.starts_with("\xef\xbb\xbf") ? 3 : 0;
  at = std::min(start.size(), start.find_first_not_of(" \t\r\n", at));
  while (at < start.size() && start[at] == '#') // comments
    at = std::min(start.size(), start.find_first_not_of(" \t\r\n", start.find_first_of("\r\n", at)));
  std::string word = start.substr(at, 5);
  for (char& c : word) c = char(std::tolower(static_cast<unsigned char>(c)));
  return word != "solid" || start.find('\0') != start.npos ? start.npos : at;
}

// What a file is, from its size and its first bytes: nothing else is read before that is known.
struct Kind {
  bool is_text = false;
  std::size_t begin = 0, end = 0; // bytes that matter
  std::size_t facets = 0;         // of a binary one
};
constexpr std::size_t most_bytes = 2'000'000'000; // 40 million facets

std::string read_bytes(std::ifstream& stream, const std::string& file, std::size_t count) {
  std::string bytes(count, '\0');
  stream.clear(), stream.seekg(0);
  if (!stream.read(bytes.data(), std::streamsize(count)))
    throw DeckError(file + ": cannot be read to its end; is it a file?");
  return bytes;
}

Kind find_kind(std::ifstream& stream, const std::string& file) {
  std::error_code error;
  const std::size_t size = std::filesystem::file_size(file, error);
  if (!stream || error) throw DeckError(file + ": cannot be read; give its path relative to the deck");
  const std::string start = read_bytes(stream, file, std::min<std::size_t>(size, 1024));
  std::uint32_t count = 0;
  if (size >= header_size) std::memcpy(&count, start.data() + 80, sizeof count);
  const std::size_t expected = header_size + facet_size * count, text = find_text(start);
  Kind kind{size != expected && text != start.npos, 0, expected, count};
  if (kind.is_text)
    kind.begin = text, kind.end = size;
  else if (size < header_size || size < expected || count == 0) // some pad their files
    throw DeckError(fmt::format(
        "{}: neither an ASCII STL (begins with \"solid\") nor a whole binary one ({}); export or copy it "
        "again",
        file,
        size < header_size ? "it has less than the 84 bytes of a header"
        : count == 0       ? "its header counts no facet"
        : expected > 100 * size
            ? "what would be its count of facets is none"
            : fmt::format("{} facets need {} bytes, the file has {}", count, expected, size)));
  if (kind.end > most_bytes)
    throw DeckError(
        fmt::format("{}: is {:.3g} GB of facets: expected at most {:.3g} GB; export it with coarser "
                    "facets",
                    file, 1e-9 * double(kind.end), 1e-9 * double(most_bytes)));
  return kind;
}

} // namespace

std::string read_stl_bytes(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return read_bytes(stream, file, find_kind(stream, file).end);
}

FacetSurface read_stl(const std::string& file, double metres_per_unit) {
  std::ifstream stream(file, std::ios::binary);
  const Kind kind = find_kind(stream, file);
  const std::string bytes = read_bytes(stream, file, kind.end);
  FacetSurface surface = kind.is_text ? read_ascii(bytes.substr(kind.begin), file, metres_per_unit)
                                      : read_binary(bytes, kind.facets, file, metres_per_unit);
  take_out_flat_facets(surface);
  return surface;
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
      row[d] = length > 0 ? float(n[d] / length) : 0.0f;
      for (int k = 0; k < 3; ++k) row[3 + 3 * k + d] = float(p[k][d]);
    }
    bytes.append(reinterpret_cast<const char*>(row), sizeof row).append(2, '\0');
  }
  write_file(file, bytes);
}

} // namespace swarf
