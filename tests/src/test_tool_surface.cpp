// Faults of surfaces and STL files, each with the facet named; and files that come back as they went.
#include "src/files/results.hpp"
#include "src/geometry/flat_facets.hpp"
#include "tool_shapes.hpp"

#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cctype>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>

namespace swarf::test {
namespace {

// Facets 1 to 4 of a tetrahedron with corners 0, e_x, e_y, e_z.
FacetSurface make_tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

std::string fault_of(const FacetSurface& s) {
  return message_of<DeckError>([&] { check_surface(s, "tool.stl"); });
}
void expect_text(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << part << "\n" << message;
}

TEST(CheckSurface, AcceptsAClosedOutwardSurface) { EXPECT_EQ(fault_of(make_tetrahedron()), ""); }

TEST(CheckSurface, NamesTheInvertedFacet) {
  // In a cube of 12 facets every neighbour of the inverted one disagrees with it alone.
  ToolDeck wall = make_wall_deck();
  for (int f = 0; f < 12; ++f) {
    FacetSurface s = make_wall(wall);
    std::swap(s.facets[f][1], s.facets[f][2]);
    expect_text(fault_of(s),
                {"tool.stl: facet " + std::to_string(f + 1) + " with corners (",
                 "is inverted: it is turned against 3 of its 3 neighbours", "counter-clockwise"});
  }
}

TEST(CheckSurface, NamesAFacetAtAnOpenEdge) {
  FacetSurface s = make_tetrahedron();
  s.facets.pop_back();
  expect_text(fault_of(s), {"facet 1 with corners (0, 0, 0), (0, 1, 0), (1, 0, 0) m",
                            "its edge (1, 0, 0) to (0, 1, 0) m is open", "close the hole"});
}

TEST(CheckSurface, RefusesASurfaceInsideOut) {
  FacetSurface s = make_tetrahedron();
  for (auto& f : s.facets) std::swap(f[1], f[2]);
  expect_text(fault_of(s),
              {"facet 1 with corners", "is inside out (volume -0.167 m3)", "turn all its facets"});
}

TEST(CheckSurface, NamesThePartThatIsInsideOut) {
  FacetSurface s = make_tetrahedron();
  for (const Triple& v : make_tetrahedron().vertices) s.vertices.push_back({v[0] + 5, v[1], v[2]});
  for (const auto& [a, b, c] : make_tetrahedron().facets) s.facets.push_back({a + 4, c + 4, b + 4});
  expect_text(fault_of(s), {"facet 5 with corners (5, 0, 0)", "inside out"});
}

TEST(CheckSurface, NamesAFacetWithoutArea) {
  FacetSurface s = make_tetrahedron();
  s.facets.push_back({1, 1, 2});
  expect_text(fault_of(s), {"facet 5 with corners (1, 0, 0), (1, 0, 0), (0, 1, 0) m has no area"});
  s = make_tetrahedron();
  s.vertices.push_back({0.5, 0.5, 0});
  s.facets.push_back({1, 4, 2}); // three corners in line
  expect_text(fault_of(s), {"facet 5", "has no area"});
}

TEST(CheckSurface, NamesAnEdgeOfMoreThanTwoFacets) {
  FacetSurface s = make_tetrahedron(); // a second one that shares the edge from 0 to e_z
  s.vertices.push_back({-1, 0, 0}), s.vertices.push_back({0, -1, 0});
  for (const auto& f : {std::array{0, 5, 4}, {0, 4, 3}, {0, 3, 5}, {4, 5, 3}}) s.facets.push_back(f);
  expect_text(fault_of(s), {"facet 3", "(0, 0, 0) to (0, 0, 1) m is shared by 4 facets instead of 2"});
}

TEST(CheckSurface, RefusesNoFacetsAndInfiniteCorners) {
  expect_text(fault_of({}), {"no facets"});
  FacetSurface s = make_tetrahedron();
  s.vertices[3][1] = INFINITY;
  expect_text(fault_of(s), {"facet 2", "not finite"});
}

// --- files
std::string read_bytes(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}
void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

// A tetrahedron as a program might write it.
const char* const ascii_tetrahedron = R"(solid a tool
facet normal 0 0 -1
 outer loop
  vertex 0 0 0
  vertex 0 1 0
  vertex 1 0 0
 endloop
endfacet
facet normal 0 -1 0
 outer loop
  vertex 0 0 0
  vertex 1 0 0
  vertex -0 0 1e0
 endloop
endfacet
facet normal -1 0 0
 outer loop
  vertex 0 0 0
  vertex 0 0 1
  vertex 0 1 0
 endloop
endfacet
facet normal 1 1 1
 outer loop
  vertex 1 0 0
  vertex 0 1 0
  vertex 0 0 1
 endloop
endfacet
endsolid a tool
)";

double enclosed_volume(const FacetSurface& s) { // by the divergence theorem
  double sum = 0;
  for (const auto& f : s.facets) {
    const Triple &a = s.vertices[std::size_t(f[0])], &b = s.vertices[std::size_t(f[1])],
                 &c = s.vertices[std::size_t(f[2])];
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

std::string replace_all(std::string text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

// Each is read by other programs (numpy-stl, MeshLab, Gmsh, ParaView), and is the same body.
TEST(Stl, DialectsOfAsciiAreTheSameBody) {
  const TemporaryFolder folder;
  const std::string plain = ascii_tetrahedron;
  std::string upper = plain;
  for (char& c : upper) c = char(std::toupper(static_cast<unsigned char>(c)));
  const std::map<std::string, std::string> dialects = {
      {"plain", plain},
      {"upper case", upper},
      {"end loop", replace_all(replace_all(plain, "endloop", "end loop"), "endfacet", "end facet")},
      {"end of the solid in upper case", replace_all(plain, "endsolid", "ENDSOLID")},
      {"byte order mark", "\xef\xbb\xbf" + plain},
      {"blank lines before", "\n  \n" + plain},
      {"Windows", replace_all(plain, "\n", "\r\n")},
      {"old Macintosh", replace_all(plain, "\n", "\r")},
      {"Fortran", replace_all(replace_all(plain, " 1 0", " 1.0D+00 0.0d-00"), "1e0", "1.0D00")},
      {"signs", replace_all(plain, "1e0", "+1.0")},
      {"a facet a line",
       replace_all(replace_all(plain, "\n  vertex", " vertex"), "\n endloop\n", " endloop ")},
      {"colours", replace_all(plain, "facet normal 0", "color 0.5 0.5 0.5\nfacet normal 0")},
      {"normals that are none", replace_all(plain, "normal 0 0 -1", "normal nan nan nan")},
      {"nothing after the last facet", replace_all(plain, "endsolid a tool\n", "")},
  };
  for (const auto& [name, text] : dialects) {
    SCOPED_TRACE(name);
    write_bytes(folder / "t.stl", text);
    FacetSurface s;
    EXPECT_NO_THROW(s = read_stl((folder / "t.stl").string(), 1));
    EXPECT_EQ(s.facets.size(), 4u);
    EXPECT_EQ(s.vertices.size(), 4u);
    EXPECT_EQ(fault_of(s), "");
    EXPECT_NEAR(enclosed_volume(s), 1.0 / 6, 1e-12);
  }
}

TEST(Stl, BinaryWithMoreBytesThanItsFacets) {
  const TemporaryFolder folder;
  const std::string file = (folder / "t.stl").string();
  write_stl(make_tetrahedron(), file);
  std::string bytes = read_bytes(file);
  bytes.replace(0, 6, "solid "); // as some programs begin their header
  write_bytes(file, bytes + std::string(2, '\0'));
  const FacetSurface s = read_stl(file, 1);
  EXPECT_EQ(s.facets.size(), 4u);
  EXPECT_NEAR(enclosed_volume(s), 1.0 / 6, 1e-7);
}

TEST(Stl, CollapsedFacetsAreLeftOutAndCounted) {
  const TemporaryFolder folder;
  FacetSurface with = make_tetrahedron();
  with.facets.insert(with.facets.begin() + 1, {1, 1, 1});
  with.facets.push_back({2, 3, 2});
  const std::string file = (folder / "t.stl").string();
  write_stl(with, file);
  const FacetSurface s = read_stl(file, 1);
  EXPECT_EQ(s.facets.size(), 4u);
  EXPECT_EQ(s.collapsed, 2);
  EXPECT_EQ(fault_of(s), "");
}

// As some programs write where a long side meets two short ones: (1, m, 2) lies in a line, m in the middle.
TEST(Stl, FlatFacetsGoIntoTheirNeighbours) {
  const TemporaryFolder folder;
  FacetSurface with = make_tetrahedron();
  with.vertices.push_back({0.5, 0.5, 0});
  with.facets[0] = {0, 2, 4}; // (0, 2, 1) in two, with m; (1, 2, 3) stays whole and the flat one lies between
  with.facets.push_back({0, 4, 1});
  with.facets.push_back({1, 4, 2});
  const std::string file = (folder / "t.stl").string();
  write_stl(with, file);
  const FacetSurface s = read_stl(file, 1);
  EXPECT_EQ(fault_of(s), "");
  EXPECT_EQ(s.collapsed, 1);
  EXPECT_EQ(s.facets.size(), 6u) << "(1, 2, 3) is now two";
  EXPECT_NEAR(enclosed_volume(s), 1.0 / 6, 1e-7);
}

// Two flat facets in a row, and two that lie on each other.
TEST(Stl, SeveralFlatFacetsInARow) {
  FacetSurface s = make_tetrahedron();
  s.vertices.push_back({0.5, 0.5, 0}), s.vertices.push_back({0.25, 0.75, 0});
  s.facets[0] = {0, 2, 5};
  for (const auto& f : {std::array{0, 5, 4}, {0, 4, 1}, {1, 4, 2}, {4, 5, 2}}) s.facets.push_back(f);
  take_out_flat_facets(s);
  EXPECT_EQ(fault_of(s), "");
  EXPECT_EQ(s.collapsed, 2);
  EXPECT_NEAR(enclosed_volume(s), 1.0 / 6, 1e-12);
  s = make_tetrahedron();
  s.vertices.push_back({0.5, 0.5, 0});
  s.facets.push_back({1, 4, 2}), s.facets.push_back({2, 4, 1});
  take_out_flat_facets(s);
  EXPECT_EQ(s.facets.size(), 4u);
  EXPECT_EQ(fault_of(s), "");
}

// 20 GB that are mostly holes: only what the header counts is read.
TEST(Stl, ReadsNoMoreThanTheHeaderCounts) {
  const TemporaryFolder folder;
  const std::string file = (folder / "t.stl").string();
  write_stl(make_tetrahedron(), file);
  std::error_code error;
  std::filesystem::resize_file(file, 20'000'000'000, error);
  if (error) GTEST_SKIP() << "this disk makes no sparse files";
  EXPECT_EQ(read_stl(file, 1).facets.size(), 4u);
  EXPECT_EQ(read_stl_bytes(file).size(), 84u + 4 * 50);
  std::string header(84, '\0');
  header[83] = 23; // 386 million facets, 19.3 GB
  std::fstream(file, std::ios::binary | std::ios::in | std::ios::out) << header;
  expect_text(message_of<DeckError>([&] { read_stl(file, 1); }), {"t.stl: is 19.3 GB of facets", "coarser"});
}

TEST(ToolSurface, SizesThatMakeNeedlesNameTheirKey) {
  ToolDeck mill = make_mill();
  mill.length = 1, mill.edge_radius = 1e-9;
  const std::string fault = message_of<DeckError>([&] { make_tool_surface(mill, ""); });
  expect_text(fault, {"tool.edge_radius: 1e-09 m makes facets of ", "Take at least ", "or a smaller length"});
  mill.edge_radius = std::stod(fault.substr(fault.find("at least ") + 9));
  EXPECT_NO_THROW(make_tool_surface(mill, "")) << "advice that works";
  ToolDeck wedge = make_wedge_deck();
  wedge.edge_radius = 0, wedge.width = 1e-9, wedge.height = 1;
  expect_text(message_of<DeckError>([&] { make_tool_surface(wedge, ""); }), {"tool.width: makes facets of "});
}

TEST(Stl, EveryGeneratedToolComesBackWholeAndTwiceTheSame) {
  const TemporaryFolder folder;
  for (const ToolDeck& deck : {make_mill(), make_wedge_deck(), make_wall_deck()}) {
    const FacetSurface s = make_tool_surface(deck, "");
    const std::string one = (folder / "one.stl").string(), two = (folder / "two.stl").string();
    write_stl(s, one);
    const FacetSurface back = read_stl(one, 1);
    EXPECT_NO_THROW(check_surface(back, "back"));
    ASSERT_EQ(back.facets.size(), s.facets.size());
    ASSERT_EQ(back.vertices.size(), s.vertices.size()); // merged exactly
    for (std::size_t f = 0; f < s.facets.size(); ++f)
      for (int k = 0; k < 3; ++k)
        for (int d = 0; d < 3; ++d)
          ASSERT_EQ(float(back.vertices[back.facets[f][k]][d]), float(s.vertices[s.facets[f][k]][d]));
    write_stl(back, two);
    EXPECT_EQ(read_bytes(one).size(), 84 + 50 * s.facets.size());
    write_stl(s, two);
    EXPECT_EQ(read_bytes(one), read_bytes(two));
  }
}

TEST(Stl, ReadsAsciiWithItsUnit) {
  const TemporaryFolder folder;
  write_bytes(folder / "t.stl", ascii_tetrahedron);
  ToolDeck deck(ToolKind::stl);
  deck.file = "t.stl", deck.file_scale = 1e-3;
  const FacetSurface s = make_tool_surface(deck, folder.path.string());
  EXPECT_EQ(s.facets.size(), 4u);
  EXPECT_EQ(s.vertices.size(), 4u);
  EXPECT_EQ(s.vertices[1], (Triple{0, 1e-3, 0}));
}

std::string fault_of_file(const std::string& bytes) {
  const TemporaryFolder folder;
  write_bytes(folder / "t.stl", bytes);
  return message_of<DeckError>([&] { read_stl((folder / "t.stl").string(), 1); });
}

TEST(Stl, FaultsOfFilesAreNamed) {
  expect_text(message_of<DeckError>([] { read_stl("no/such/tool.stl", 1); }),
              {"no/such/tool.stl: cannot be read", "relative to the deck"});
  expect_text(fault_of_file(""), {"neither an ASCII STL"});
  expect_text(fault_of_file("PNG and so on"), {"t.stl: neither an ASCII STL", "export or copy it again"});
  const std::string ascii = ascii_tetrahedron;
  expect_text(fault_of_file(ascii.substr(0, ascii.find("vertex 0 0 1"))),
              {"in the middle of a facet: cut short"});
  const TemporaryFolder folder; // cut between two facets: the hole shows it
  write_bytes(folder / "t.stl", ascii.substr(0, ascii.rfind("facet normal")));
  expect_text(fault_of(read_stl((folder / "t.stl").string(), 1)), {"is open: no other facet shares it"});
  std::string bad = ascii;
  bad.replace(bad.find("vertex 0 1 0"), 12, "vertex 0 x 0");
  expect_text(fault_of_file(bad), {"t.stl:5: expected \"vertex x y z\" with three numbers"});
  bad = ascii, bad.replace(bad.find("vertex 0 1 0"), 12, "            ");
  expect_text(fault_of_file(bad), {"t.stl:7: facet 1 has 2 corners instead of 3"});
  bad = ascii, bad.replace(bad.find("outer loop"), 10, "outre loop");
  expect_text(fault_of_file(bad), {"t.stl:3: \"outre\" is no word"});
}

TEST(Stl, FaultsOfBinaryFilesAreNamed) {
  const TemporaryFolder folder;
  write_stl(make_wall(make_wall_deck()), (folder / "t.stl").string());
  const std::string whole = read_bytes(folder / "t.stl");
  expect_text(fault_of_file(whole.substr(0, whole.size() - 20)),
              {"12 facets need 684 bytes, the file has 664"});
  std::string bad = whole;
  const float nan = NAN;
  std::memcpy(bad.data() + 84 + 3 * 50 + 12, &nan, sizeof nan);
  expect_text(fault_of_file(bad), {"facet 4 has a corner that is not a finite number"});
}

TEST(Stl, UnwritableFileIsAnError) {
  expect_text(
      message_of<ResultsError>([] { write_stl(make_wall(make_wall_deck()), "/no/such/folder/t.stl"); }),
      {"/no/such/folder/t.stl: cannot write"});
}

} // namespace
} // namespace swarf::test
