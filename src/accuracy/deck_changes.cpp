// What differs between two decks, by the rows of their keys, so that none can be forgotten.
#include "src/accuracy/chart_settings.hpp"
#include "src/deck/section.hpp"
#include <fmt/format.h>

namespace swarf {
namespace {

constexpr int digits = 6; // what differs beyond is round-off of what was set

struct Changes {
  std::vector<KeyChange> all;

  template <class Section>
  void compare(const std::string& name, const Keys<Section>& keys, const Section& before,
               const Section& after) {
    for (const auto& key : keys) {
      if (key.name == "accuracy") continue; // asks for changes, and is none
      const std::string was = applies(keys, key, before) ? write_field(key, before, digits) : "";
      const std::string now = applies(keys, key, after) ? write_field(key, after, digits) : "";
      if (now != was) all.push_back({name, key.name, now, was});
    }
  }

  // Sections that a deck may have or not: pointers, null for none.
  template <class Section>
  void compare_if_there(const std::string& name, const Keys<Section>& keys, const Section* before,
                        const Section* after) {
    if (before && after)
      compare(name, keys, *before, *after);
    else if (before)
      all.push_back({name, "", "", ""});
    else if (after)
      for (const auto& key : keys)
        if (applies(keys, key, *after))
          if (const std::string now = write_field(key, *after, digits); !now.empty())
            all.push_back({name, key.name, now, ""});
  }

  void compare_faces(const BodyDeck& before, const BodyDeck& after);
};

std::string show(const FaceDeck& face) {
  std::string text = word_of(face.kind);
  for (const auto& key : face_keys())
    if (const std::string value = write_field(key, face, digits); !value.empty() && key.name != "fixed")
      text += fmt::format(", {} = {}", key.name, value);
  return text;
}

template <class Section>
const Section* find_named(const std::vector<Section>& sections, const std::string& name) {
  for (const Section& section : sections)
    if (section.name == name) return &section;
  return nullptr;
}

const FaceDeck* find_face(const BodyDeck& body, const std::string& name) {
  for (const FaceDeck& face : body.faces)
    if (face.face == name) return &face;
  return nullptr;
}

void Changes::compare_faces(const BodyDeck& before, const BodyDeck& after) {
  const std::string name = fmt::format("[body \"{}\" faces]", after.name);
  for (const FaceDeck& face : after.faces) {
    const FaceDeck* old = find_face(before, face.face);
    const std::string now = show(face), was = old ? show(*old) : "";
    if (now != was) all.push_back({name, face.face, now, was});
  }
  for (const FaceDeck& face : before.faces)
    if (!find_face(after, face.face)) all.push_back({name, face.face, "", show(face)});
}

template <class Section>
const Section* pointer_to(const std::optional<Section>& section) {
  return section ? &*section : nullptr;
}

} // namespace

std::vector<KeyChange> list_changes(const Deck& before, const Deck& after) {
  Changes changes;
  const auto material = [](const std::string& name) { return fmt::format("[material.{}]", name); };
  const auto body = [](const std::string& name) { return fmt::format("[body \"{}\"]", name); };
  changes.compare("", top_keys(), before, after);
  for (const MaterialDeck& old : before.materials)
    if (!find_named(after.materials, old.name)) changes.all.push_back({material(old.name), "", "", ""});
  for (const BodyDeck& old : before.bodies)
    if (!find_named(after.bodies, old.name)) changes.all.push_back({body(old.name), "", "", ""});
  for (const MaterialDeck& now : after.materials)
    changes.compare_if_there(material(now.name), material_keys(), find_named(before.materials, now.name),
                             &now);
  for (const BodyDeck& now : after.bodies) {
    const BodyDeck* old = find_named(before.bodies, now.name);
    changes.compare_if_there(body(now.name), body_keys(), old, &now);
    if (old) changes.compare_faces(*old, now);
  }
  changes.compare_if_there("[tool]", tool_keys(), pointer_to(before.tool), pointer_to(after.tool));
  if (before.tool && after.tool) changes.compare("[contact]", contact_keys(), before.contact, after.contact);
  changes.compare("[particles]", particles_keys(), before.particles, after.particles);
  changes.compare("[hexes]", hexes_keys(), before.hexes, after.hexes);
  changes.compare("[sleep]", sleep_keys(), before.sleep, after.sleep);
  changes.compare("[retire]", retire_keys(), before.retire, after.retire);
  changes.compare("[run]", run_keys(), before.run, after.run);
  changes.compare_if_there("[windows]", windows_keys(), pointer_to(before.windows),
                           pointer_to(after.windows));
  changes.compare_if_there("[mechanistic]", mechanistic_keys(), pointer_to(before.mechanistic),
                           pointer_to(after.mechanistic));
  changes.compare("[output]", output_keys(), before.output, after.output);
  return changes.all;
}

std::string describe(const KeyChange& change) {
  if (change.key.empty()) return change.section + " left out";
  if (change.now.empty()) return fmt::format("{} {} left out", change.section, change.key);
  const std::string now = fmt::format("{} {} = {}", change.section, change.key, change.now);
  return change.was.empty() ? now : fmt::format("{}, was {}", now, change.was);
}

} // namespace swarf
