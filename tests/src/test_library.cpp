// The library of materials: each is a whole material with a source, and a deck that names one is a deck that
// writes it out.
#include "src/deck/library.hpp"
#include "tests/decks/good_deck.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace swarf;
using namespace swarf::test;
using testing::HasSubstr;

namespace {

std::string named(const std::string& material) {
  return edit_deck("material = \"ti64\"", "material = \"" + material + "\"");
}

} // namespace

TEST(Library, every_material_is_listed_with_its_source) {
  const std::string text = list_materials();
  for (const char* name :
       {"ti64-demiral", "ti64-seo", "ti64-lesuer", "ti64-meyer", "ti64-klippel", "steel-4340", "steel-1045",
        "steel-42crmo4", "al-6061-t6", "al-7075-t6", "copper-ofhc", "carbide-wc-co", "hss-m2"})
    EXPECT_THAT(text, HasSubstr("\nlibrary:" + std::string(name) + "\n"));
  for (const LibraryMaterial& entry : material_library()) {
    EXPECT_THAT(text, HasSubstr("source: " + entry.source)) << entry.material.name;
    EXPECT_THAT(entry.source, testing::ContainsRegex("[12][0-9][0-9][0-9]|data sheet"))
        << entry.material.name;
  }
}

// Seo, Min & Yang (2005): A 997.9, B 653.1 MPa, n 0.45, C 0.0198, m 0.7.
TEST(Library, a_body_may_name_one) {
  const Deck deck = read_text(named("library:ti64-seo"));
  const MaterialDeck* m = find_material(deck, deck.bodies[0].material);
  ASSERT_NE(m, nullptr);
  EXPECT_EQ(m->A, 997.9e6);
  EXPECT_EQ(m->B, 653.1e6);
  EXPECT_EQ(m->n, 0.45);
  EXPECT_EQ(m->C, 0.0198);
  EXPECT_EQ(m->m, 0.7);
  EXPECT_EQ(deck.materials.size(), 2u) << "the other body has the deck's own";
}

TEST(Library, the_resolved_deck_writes_the_constants_out) {
  Deck deck = read_text(named("library:steel-4340"));
  const std::string text = resolved_deck(deck);
  EXPECT_THAT(text, HasSubstr("[material.\"library:steel-4340\"]"));
  Deck again = read_text(text);
  again.file = deck.file;
  for (std::size_t b = 0; b < again.bodies.size(); ++b) again.bodies[b].line = deck.bodies[b].line;
  EXPECT_TRUE(again == deck) << "also the order of the materials, by which restarts compare";
}

TEST(Library, a_material_of_the_same_name_in_the_deck_goes_before) {
  const std::string own = "[material.\"library:ti64-seo\"]\nlaw = \"elastic\"\ndensity = \"1000 kg/m3\"\n"
                          "youngs_modulus = \"1 GPa\"\npoissons_ratio = 0.3\n[[body]]\nname = \"cut zone\"";
  const Deck deck = read_text(edit_deck("[[body]]\nname = \"cut zone\"", own, named("library:ti64-seo")));
  EXPECT_EQ(find_material(deck, "library:ti64-seo")->law, Law::elastic);
}

TEST(Library, what_it_has_not_is_an_error) {
  try {
    read_text(named("library:ti64-soe"));
    FAIL();
  } catch (const DeckError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("body.material: there is no \"library:ti64-soe\": swarf materials lists"));
    EXPECT_THAT(error.what(), HasSubstr("Did you mean \"library:ti64-seo\"?"));
  }
}
