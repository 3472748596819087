// The keys of a deck, each declared once: type (of the field it fills), dimension, bounds, default, where it
// applies, help. Reading, checking, the resolved deck and the reference page all follow these rows.
#pragma once
#include "src/deck/deck.hpp"
#include "src/units/units.hpp"
#include <limits>
#include <variant>

namespace swarf {

// Bounds in the unit of the resolved deck, angles in degrees.
struct Bounds {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;
};
using Choices = std::vector<std::string>;
struct Direction {}; // three numbers, not all zero
struct Text {};      // any non-empty text
struct Counts {      // of cells; two are [across, axial] and fill (across, across, axial)
  int entries;
};
using Allowed = std::variant<Bounds, Choices, Direction, Text, Counts>;

// The key applies only where the key `key`, a word, of the same table is one of `values`.
struct Condition {
  std::string key;
  std::vector<std::string> values;
};

// A field that is one of the words of an enum.
template <class Section>
struct WordField {
  const Words* known;
  int (*get)(const Section&);
  void (*set)(Section&, int);
};
template <auto field, class Section, class Enum>
WordField<Section> word_field(Enum Section::*) {
  return {&words<Enum>(), [](const Section& section) { return int(section.*field); },
          [](Section& section, int value) { section.*field = Enum(value); }};
}
template <auto field>
auto word() {
  return word_field<field>(field);
}

template <class Section>
struct Key {
  // monostate: a table or a list that deck.cpp reads by code of its own.
  using Field = std::variant<std::monostate, WordField<Section>, std::string Section::*, bool Section::*,
                             int Section::*, double Section::*, OverTemperature Section::*,
                             std::optional<double> Section::*, Triple Section::*,
                             std::vector<double> Section::*, std::optional<std::array<int, 3>> Section::*,
                             std::optional<std::array<double, 5>> Section::*>;
  std::string name;
  Field field;
  Dimension dimension;
  Allowed allowed;
  std::string value; // default as TOML, or "required", or "optional"
  std::vector<Condition> when;
  std::string help;
};

template <class Section>
using Keys = std::vector<Key<Section>>;

const Keys<Deck>& top_keys();
const Keys<MaterialDeck>& material_keys();
const Keys<BodyDeck>& body_keys();
const Keys<FaceDeck>& face_keys();
const Keys<ToolDeck>& tool_keys();
const Keys<ContactDeck>& contact_keys();
const Keys<ParticlesDeck>& particles_keys();
const Keys<HexesDeck>& hexes_keys();
const Keys<SleepDeck>& sleep_keys();
const Keys<RetireDeck>& retire_keys();
const Keys<RunDeck>& run_keys();
const Keys<OutputDeck>& output_keys();
const Keys<LabelledForce>& published_keys();
const Keys<WindowsDeck>& windows_keys();
const Keys<MechanisticDeck>& mechanistic_keys();

template <class Section>
const std::string* text_of(const Keys<Section>& keys, const std::string& name, const Section& section) {
  for (const auto& key : keys)
    if (key.name == name)
      if (auto* field = std::get_if<WordField<Section>>(&key.field))
        return &(*field->known)[std::size_t(field->get(section))];
  return nullptr;
}

// Does the key apply, given the shape, law or kind that the section already holds?
template <class Section>
bool applies(const Keys<Section>& keys, const Key<Section>& key, const Section& section) {
  for (const Condition& condition : key.when) {
    const std::string* text = text_of(keys, condition.key, section);
    bool is_met = false;
    for (const std::string& value : condition.values) is_met = is_met || (text && *text == value);
    if (!is_met) return false;
  }
  return true;
}

} // namespace swarf
