// A body that an STL surface encloses: those cells of the lattice in its box whose centres lie inside.
#include "src/geometry/body_file.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace swarf {
namespace {

using Index = std::array<int, 3>;
constexpr double most_off = 0.1;     // of the surface's volume: coarser cells make another body
constexpr double most_strays = 0.01; // of all cells: the tips of sharp edges

class StlLattice {
 public:
  explicit StlLattice(const Shape& s) : shape(s), n(s.cells), low(s.file->box.min()) {
    for (int d = 0; d < 3; ++d) pitch[d] = s.file->box.sizes()[d] / n[d];
    find_inside();
    leave_out_strays();
    check_volume();
  }

  PointSet points() const {
    PointSet set;
    const double volume = shape.volume() / double(filled()); // of the surface, whatever its cells have
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (row[c] < 0) continue;
      const Index i = index_of(c);
      mark_faces(set, i);
      set.position.push_back(centre(i)), set.volume.push_back(volume),
          set.gap.push_back(0.5 * pitch.minCoeff());
    }
    set.spacing = std::cbrt(volume);
    check_faces(set.faces);
    return set;
  }

  HexSet hexes() const {
    HexSet set;
    std::vector<int> node(std::size_t(n[0] + 1) * std::size_t(n[1] + 1) * std::size_t(n[2] + 1), -1);
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (row[c] < 0) continue;
      const auto [a, b, k] = index_of(c);
      std::array<int, 8> hex{};
      const Index corners[8] = {{a, b, k},     {a + 1, b, k},     {a + 1, b + 1, k},     {a, b + 1, k},
                                {a, b, k + 1}, {a + 1, b, k + 1}, {a + 1, b + 1, k + 1}, {a, b + 1, k + 1}};
      for (std::size_t q = 0; q < 8; ++q) hex[q] = add_node(set, node, corners[q]);
      set.hex.push_back(hex);
    }
    check_faces(set.faces);
    return set;
  }

 private:
  const Shape& shape;
  Index n;
  Point low, pitch;
  std::vector<int> row; // of each cell, z fastest; -1: outside

  std::size_t cell(const Index& i) const {
    return (std::size_t(i[0]) * std::size_t(n[1]) + std::size_t(i[1])) * std::size_t(n[2]) +
           std::size_t(i[2]);
  }
  Index index_of(std::size_t c) const {
    const std::size_t y = std::size_t(n[1]), z = std::size_t(n[2]);
    return {int(c / (y * z)), int(c / z % y), int(c % z)};
  }
  Point centre(const Index& i) const {
    return low + pitch.cwiseProduct(Point(i[0] + 0.5, i[1] + 0.5, i[2] + 0.5));
  }
  std::size_t filled() const {
    return std::size_t(std::count_if(row.begin(), row.end(), [](int r) { return r >= 0; }));
  }
  [[noreturn]] void refuse(const std::string& text) const {
    reject(*shape.deck, *shape.body, "spacing", text);
  }

  void number() {
    for (int next = 0; int& r : row)
      if (r >= 0) r = next++;
  }

  void find_inside() {
    row.assign(std::size_t(n[0]) * std::size_t(n[1]) * std::size_t(n[2]), -1);
    for (std::size_t c = 0; c < row.size(); ++c)
      if (shape.signed_distance(centre(index_of(c))) < 0) row[c] = 0;
    if (filled() == 0)
      refuse(fmt::format(
          "holds the centre of no cell: expected cells smaller than the body, whose box is {:.4g} m "
          "by {:.4g} m by {:.4g} m. Make it smaller, or look at file_scale",
          shape.file->box.sizes().x(), shape.file->box.sizes().y(), shape.file->box.sizes().z()));
    number();
  }

  // Cells that faces join, largest piece first.
  std::vector<std::vector<std::size_t>> find_pieces() const {
    std::vector<std::vector<std::size_t>> pieces;
    std::vector<bool> seen(row.size(), false);
    for (std::size_t seed = 0; seed < row.size(); ++seed) {
      if (row[seed] < 0 || seen[seed]) continue;
      std::vector<std::size_t>& piece = pieces.emplace_back();
      piece.push_back(seed), seen[seed] = true;
      for (std::size_t k = 0; k < piece.size(); ++k)
        for (std::size_t d = 0; d < 3; ++d)
          for (const int step : {-1, 1}) {
            Index i = index_of(piece[k]);
            i[d] += step;
            if (i[d] < 0 || i[d] >= n[d] || row[cell(i)] < 0 || seen[cell(i)]) continue;
            seen[cell(i)] = true, piece.push_back(cell(i));
          }
    }
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return pieces;
  }

  // Cells at sharp tips may hang on others by an edge or a corner, where they would turn like on a hinge.
  void leave_out_strays() {
    const auto pieces = find_pieces();
    const std::size_t parts = std::size_t(shape.file->surface->parts());
    if (pieces.size() < parts)
      refuse(
          fmt::format("makes {} piece(s) of cells of the {} parts of the surface: expected one each. Make it "
                      "smaller, or give parts that touch, or are as small as a cell, as bodies of their own",
                      pieces.size(), parts));
    std::size_t strays = 0;
    for (std::size_t p = parts; p < pieces.size(); ++p) strays += pieces[p].size();
    if (double(strays) > most_strays * double(filled()))
      refuse(
          fmt::format("makes {} pieces of cells, and the surface has {} part(s): expected as many. Make it "
                      "smaller, so that at least two cells lie across the thinnest place",
                      pieces.size(), parts));
    for (std::size_t p = parts; p < pieces.size(); ++p)
      for (const std::size_t c : pieces[p]) row[c] = -1;
    number();
  }

  void check_volume() const {
    const double off = double(filled()) * pitch.prod() / shape.volume() - 1;
    if (std::abs(off) > most_off)
      refuse(fmt::format(
          "makes cells whose volume is {:+.1f} % off that of the surface: expected at most {:.0f} %. "
          "Make it smaller",
          100 * off, 100 * most_off));
  }

  void mark_faces(PointSet& set, const Index& i) const {
    const auto names = shape.face_names();
    for (std::size_t d = 0; d < 3; ++d)
      for (const bool high : {false, true}) {
        if (i[d] != (high ? n[d] - 1 : 0)) continue;
        Index next = i;
        next[d] += high ? -1 : 1;
        const std::string& name = names[d][high];
        set.faces[name].push_back(int(set.position.size()));
        set.behind[name].push_back(n[d] >= 3 ? row[cell(next)] : -1);
      }
  }

  int add_node(HexSet& set, std::vector<int>& nodes, const Index& i) const {
    int& at = nodes[(std::size_t(i[0]) * std::size_t(n[1] + 1) + std::size_t(i[1])) * std::size_t(n[2] + 1) +
                    std::size_t(i[2])];
    if (at >= 0) return at;
    at = int(set.node.size());
    const auto names = shape.face_names();
    for (std::size_t d = 0; d < 3; ++d) {
      if (i[d] == 0) set.faces[names[d][0]].push_back(at);
      if (i[d] == n[d]) set.faces[names[d][1]].push_back(at);
    }
    set.node.push_back(low + pitch.cwiseProduct(Point(i[0], i[1], i[2])));
    return at;
  }

  void check_faces(const FaceMembers& faces) const {
    for (const FaceDeck& face : shape.body->faces)
      if (!faces.contains(face.face))
        reject(*shape.deck, *shape.body, "faces." + face.face,
               "has no cell at that side of the box: the body comes there to a point. Make the spacing "
               "smaller, or "
               "take another side");
  }
};

} // namespace

PointSet fill_points_of_stl(const Shape& shape) { return StlLattice(shape).points(); }
HexSet fill_hexes_of_stl(const Shape& shape) { return StlLattice(shape).hexes(); }

} // namespace swarf
