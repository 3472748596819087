// The resolved deck and the reference page, from the same rows that a deck is read by.
#include "src/deck/section.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace swarf {
namespace {

template <class Section>
std::string write_keys(const Keys<Section>& keys, const Section& section) {
  std::string text;
  for (const auto& key : keys) {
    if (!applies(keys, key, section)) continue;
    const std::string value = write_field(key, section);
    if (!value.empty()) text += fmt::format("{} = {}\n", key.name, value);
  }
  return text;
}

bool is_bare(const std::string& name) {
  return name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
         std::string::npos;
}

// Names of users may need quotes.
std::string key_of(const std::string& name) {
  return is_bare(name) ? name : write_value(name, {"", Dimension::none, Text{}});
}

std::string write_body(const BodyDeck& body) {
  std::string text = "\n[[body]]\n" + write_keys(body_keys(), body);
  if (!body.faces.empty()) text += "[body.faces]\n";
  for (const FaceDeck& face : body.faces) {
    std::vector<std::string> entries;
    if (face.kind == FaceKind::velocity)
      entries.push_back("velocity = " + write_value(face.velocity, {"", Dimension::velocity, Bounds{}}));
    if (face.kind == FaceKind::fixed && face.temperature) entries.push_back("fixed = true");
    if (face.temperature)
      entries.push_back("temperature = " +
                        write_value(*face.temperature, {"", Dimension::temperature, Bounds{}}));
    if (face.film)
      entries.push_back("film = " + write_value(*face.film, {"", Dimension::conductance, Bounds{}}));
    const std::string name = key_of(face.face);
    text += entries.empty() ? fmt::format("{} = \"{}\"\n", name, word_of(face.kind))
                            : fmt::format("{} = {{ {} }}\n", name, fmt::join(entries, ", "));
  }
  return text;
}

std::string write_published(const std::vector<LabelledForce>& published) {
  std::string text;
  for (const LabelledForce& row : published)
    text += "\n[[output.published]]\n" + write_keys(published_keys(), row);
  return text;
}

template <class Section>
std::string describe_conditions(const Key<Section>& key) {
  std::string text;
  for (const Condition& condition : key.when)
    text +=
        fmt::format("{}{} = {}", text.empty() ? "" : ", ", condition.key, fmt::join(condition.values, ", "));
  return text;
}

template <class Section>
std::string describe_values(const Key<Section>& key) {
  const auto* range = std::get_if<Bounds>(&key.allowed);
  if (std::holds_alternative<bool Section::*>(key.field)) return "true or false";
  if (std::holds_alternative<std::monostate>(key.field)) return "table or list";
  std::string what = describe_expected(key.dimension, key.allowed);
  if (std::holds_alternative<int Section::*>(key.field)) what = "a whole number";
  if (std::holds_alternative<std::optional<std::array<double, 5>> Section::*>(key.field))
    what = "five numbers";
  if (std::holds_alternative<std::vector<double> Section::*>(key.field)) what = "list, each " + what;
  if (std::holds_alternative<OverTemperature Section::*>(key.field)) what += " or a table";
  if (range && std::holds_alternative<Triple Section::*>(key.field)) what = "three, each " + what;
  const std::string bounds = range ? describe_bounds(*range, key.dimension) : "";
  return bounds.empty() ? what : what + ", " + bounds;
}

template <class Section>
std::string write_reference(const std::string& heading, const std::string& help, const Keys<Section>& keys) {
  std::string text = fmt::format("\n## {}\n\n{}\n\n| key | value | default | applies to | meaning |\n"
                                 "|---|---|---|---|---|\n",
                                 heading, help);
  for (const auto& key : keys) {
    std::string row =
        fmt::format("`{}` \x01 {} \x01 {} \x01 {} \x01 {}", key.name, describe_values(key),
                    has_default(key) ? "`" + key.value + "`" : key.value, describe_conditions(key), key.help);
    std::string escaped;
    for (char c : row)
      escaped += c == '|' ? std::string("\\|") : c == '\x01' ? std::string("|") : std::string(1, c);
    text += "| " + escaped + " |\n";
  }
  return text;
}

} // namespace

std::string write_mechanistic(const MechanisticDeck& model) {
  return "[mechanistic]\n" + write_keys(mechanistic_keys(), model);
}

std::string resolved_deck(const Deck& deck) {
  std::string text = "# Written by swarf: the deck with every default, in SI units.\n";
  if (deck.picked) {
    text += fmt::format("# accuracy = \"{} %\": {}. It has set:\n", deck.picked->asked, deck.picked->why);
    for (const std::string& change : deck.picked->changes) text += "#   " + change + "\n";
  }
  text += write_keys(top_keys(), deck);
  for (const MaterialDeck& material : deck.materials) {
    text += fmt::format("\n[material.{}]\n{}", key_of(material.name), write_keys(material_keys(), material));
  }
  for (const BodyDeck& body : deck.bodies) text += write_body(body);
  if (deck.tool) text += "\n[tool]\n" + write_keys(tool_keys(), *deck.tool);
  if (deck.tool || !are_all_tied(deck)) text += "\n[contact]\n" + write_keys(contact_keys(), deck.contact);
  text += "\n[particles]\n" + write_keys(particles_keys(), deck.particles);
  text += "\n[hexes]\n" + write_keys(hexes_keys(), deck.hexes);
  text += "\n[sleep]\n" + write_keys(sleep_keys(), deck.sleep);
  if (deck.retire.distance) text += "\n[retire]\n" + write_keys(retire_keys(), deck.retire);
  text += "\n[run]\n" + write_keys(run_keys(), deck.run);
  if (deck.windows) text += "\n[windows]\n" + write_keys(windows_keys(), *deck.windows);
  if (deck.mechanistic) text += "\n" + write_mechanistic(*deck.mechanistic);
  text += "\n[output]\n" + write_keys(output_keys(), deck.output);
  return text + write_published(deck.output.published);
}

std::string key_reference() {
  std::string text =
      "# Keys of a deck\n\n"
      "A deck is a TOML file. Values with units are text, such as \"10 um\", \"10000 rpm\", \"25.2 deg\", "
      "\"4430 kg/m3\", \"110 GPa\", \"25 degC\", \"30 m/min\", \"1 1/s\"; numbers without a unit are bare. "
      "Units are "
      "m g s K rad N Pa J W Hz with the prefixes n u m c k M G, and deg, rev, rpm, min, h, degC, %, joined "
      "by / "
      "and * "
      "with powers, such as N/mm2. Unknown keys are errors. `required` keys have no default; `optional` ones "
      "may be "
      "left out.\n";
  text += write_reference("Top of the file", "Before the first section.", top_keys());
  text += write_reference("[material.NAME]", "One section per material.", material_keys());
  text += write_reference("[[body]]", "One section per body, in double brackets; at least one.", body_keys());
  text += write_reference("[body.faces]", "Follows its [[body]]. A face in braces holds:", face_keys());
  text += write_reference("[tool]", "The rigid tool, if there is one.", tool_keys());
  text += write_reference("[contact]",
                          "Between the tool and the bodies, and between bodies; required with [tool].",
                          contact_keys());
  text += write_reference("[particles]", "Method of the particles.", particles_keys());
  text += write_reference("[hexes]", "Method of the hexes.", hexes_keys());
  text += write_reference("[sleep]", "Points far from the active region that take no part.", sleep_keys());
  text += write_reference("[retire]", "Spent chip that leaves the computation.", retire_keys());
  text += write_reference("[run]", "Exactly one of end_time and end_immersion.", run_keys());
  text += write_reference("[output]", "What is written, and how often.", output_keys());
  text += write_reference("output.published", "Each entry of the list:", published_keys());
  text += write_reference("[windows]",
                          "Optional: runs short windows spread over the pass instead of the whole of it, as "
                          "swarf run --windows first:last:step does. An end mill and rings only.",
                          windows_keys());
  return text +
         write_reference("[mechanistic]",
                         "Optional: coefficients of the mechanistic model of the mill, drawn beside the "
                         "run's forces (swarf mechanistic).",
                         mechanistic_keys());
}

} // namespace swarf
