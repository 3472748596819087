// Inputs that chance has spoilt, the same ones in every run: each is refused by a message or taken, never
// more. After Miller, Fredriksen & So, An empirical study of the reliability of UNIX utilities, CACM 33
// (1990) 32.
#include "src/files/results.hpp"
#include "src/geometry/body_file.hpp"
#include "src/scene/scene.hpp"
#include "src/tool/geometry.hpp"
#include "tests/support/chance.hpp"
#include "tests/support/small_deck.hpp"
#include "tests/support/temporary_folder.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;

namespace {

const std::vector<std::string> odd_words = {
    "0",          "-1",          "1e308",    "1e-308",  "nan",
    "inf",        "\"\"",        "\"-1 m\"", "\"0 s\"", "\"1e300 m\"",
    "\"nan Pa\"", "[]",          "{}",       "true",    "9223372036854775807",
    "\"fixed\"",  "\"\\u0000\"", "[[1]]"};

// A value, a line or a character of a text becomes another, goes, or comes twice.
std::string spoil(std::string text, Chance& chance) {
  const std::size_t at = chance.below(text.size());
  const auto begin = text.rfind('\n', at) + 1, end = std::min(text.find('\n', at), text.size());
  switch (chance.below(6)) {
  case 0:
    text[at] = char(chance.below(256));
    break;
  case 1:
    text.erase(begin, end - begin);
    break;
  case 2:
    text.insert(begin, text.substr(begin, end - begin) + "\n");
    break;
  case 3:
    text.resize(at);
    break;
  default:
    if (const auto equals = text.find(" = ", begin); equals < end)
      text.replace(equals + 3, end - equals - 3, chance.of(odd_words));
  }
  return text;
}

double count_all_cells(const Deck& deck) {
  double cells = 0;
  for (const BodyDeck& body : deck.bodies) cells += count_cells(deck, body);
  return cells;
}

} // namespace

TEST(Mutations, of_decks) {
  const TemporaryFolder folder;
  Chance chance(1);
  Tally tally;
  int built = 0;
  for (int k = 0; k < 1000; ++k) {
    std::string text = small_deck;
    for (std::size_t n = 1 + chance.below(2); n > 0; --n) text = spoil(text.empty() ? " " : text, chance);
    SCOPED_TRACE(k);
    tally.count<DeckError>([&] {
      const Deck deck = read_deck(folder.write("deck.toml", text));
      if (built < 40 && count_all_cells(deck) < 3000) ++built, build_scene(deck);
    });
  }
  EXPECT_GT(tally.refused, 200);
  EXPECT_GT(tally.taken, 50);
  EXPECT_EQ(built, 40);
}

TEST(Mutations, of_stl_files) {
  const TemporaryFolder folder;
  Chance chance(2);
  ToolDeck wall(ToolKind::wall);
  wall.size = 1e-3;
  const FacetSurface surface = make_wall(wall);
  write_stl(surface, (folder / "binary.stl").string());
  std::string text = "solid wall\n";
  for (const auto& facet : surface.facets) {
    text += "facet normal 0 0 1\nouter loop\n";
    for (const int v : facet)
      text += fmt::format("vertex {} {} {}\n", surface.vertices[std::size_t(v)][0],
                          surface.vertices[std::size_t(v)][1], surface.vertices[std::size_t(v)][2]);
    text += "endloop\nendfacet\n";
  }
  const std::string wholes[] = {read_text(folder / "binary.stl"), text + "endsolid wall\n"};
  Tally tally;
  for (int k = 0; k < 800; ++k) {
    const std::string file = folder.write("t.stl", spoil(wholes[k % 2], chance));
    SCOPED_TRACE(k);
    tally.count<DeckError>([&] { check_surface(read_stl(file, 1), file); });
  }
  EXPECT_GT(tally.refused, 200);
  EXPECT_GT(tally.taken, 10);
}

TEST(Mutations, of_mesh_files) {
  const TemporaryFolder folder;
  Chance chance(3);
  const std::string hexes = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 0, 0, 1\n6, 1, 0, 1\n"
                            "7, 1, 1, 1\n8, 0, 1, 1\n*ELEMENT, TYPE=C3D8R\n1, 1, 2, 3, 4,\n5, 6, 7, 8\n"
                            "*NSET, NSET=LEFT, GENERATE\n1, 8, 3\n";
  const std::string particles = "# x, y, z, volume\n0, 0, 0, 1, left\n1, 0, 0, 1\n1.0E0, 1., 0, 1.5D0\n";
  Tally tally;
  for (int k = 0; k < 800; ++k) {
    BodyDeck body(BodyShape::mesh, k % 2 ? Fill::particles : Fill::hexes);
    body.file = folder.write("m.txt", spoil(k % 2 ? particles : hexes, chance)), body.file_scale = 1e-3;
    SCOPED_TRACE(k);
    tally.count<DeckError>([&] { read_mesh(body, body.file); });
  }
  EXPECT_GT(tally.refused, 200);
  EXPECT_GT(tally.taken, 100);
}
