#include "src/deck/deck.hpp"
#include "src/deck/checks.hpp"
#include "src/deck/library.hpp"
#include "src/deck/section.hpp"
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <numbers>
#include <sstream>

namespace swarf {
namespace {

const std::vector<std::string> section_names = {"material",  "body",   "tool",    "contact",
                                                "particles", "hexes",  "sleep",   "retire",
                                                "run",       "output", "windows", "mechanistic"};

MechanisticDeck fill_mechanistic(const toml::table& table, DeckReport& report) {
  MechanisticDeck model;
  model.line = int(table.source().begin.line);
  const double per_radian = 180 / std::numbers::pi;
  const std::size_t before = report.count();
  read_keys(table, "mechanistic", mechanistic_keys(), model, report);
  if (report.count() == before && model.exit <= model.entry)
    report.add(find_place(table, "exit"), "mechanistic.exit",
               fmt::format("expected more than entry = {:.6g} deg, got {:.6g} deg", model.entry * per_radian,
                           model.exit * per_radian));
  return model;
}

class DeckReader {
 public:
  DeckReader(const FilePlace& from, const toml::table& table) : root(table), place(from), report(from.deck) {
    deck.file = from.deck;
  }
  Deck read();

 private:
  const toml::table& root;
  const toml::table empty{};
  FilePlace place;
  DeckReport report;
  Deck deck;

  const toml::table& find_section(const std::string& name);
  void read_top();
  void read_materials();
  void read_bodies();
  void read_faces(const toml::table& body, std::vector<FaceDeck>& faces);
  void read_tool();
  void read_output();
  void read_run();
  void read_windows();
  void read_mechanistic();
};

// The table, or an empty one so that the defaults are filled in.
const toml::table& DeckReader::find_section(const std::string& name) {
  const toml::node* node = root.get(name);
  if (!node) return empty;
  if (const toml::table* table = node->as_table()) return *table;
  report.add(*node, name, fmt::format("expected one section [{}]", name));
  return empty;
}

void DeckReader::read_top() {
  for (auto&& [name, node] : root) {
    const std::string word(name.str());
    if (std::find(section_names.begin(), section_names.end(), word) != section_names.end() || word == "title")
      continue;
    std::vector<std::string> known = section_names;
    known.push_back("title");
    const std::string what = node.is_table() || node.is_array_of_tables() ? "section" : "key";
    report.add(int(name.source().begin.line), word,
               fmt::format("is not a known {}.{}", what, suggest(word, known)));
  }
  const auto& title = top_keys().front();
  const toml::node* node = root.get("title");
  if (!node) return;
  const std::string error = fill_field(*node, title, deck);
  if (!error.empty()) report.add(*node, "title", error);
}

void DeckReader::read_materials() {
  const toml::table& materials = find_section("material");
  for (auto&& [name, node] : materials) {
    const std::string path = fmt::format("material.{}", name.str());
    const toml::table* table = node.as_table();
    if (!table) return report.add(materials, "material", "a material has a name: write [material.NAME]");
    MaterialDeck material{};
    material.name = name.str();
    const std::size_t before = report.count();
    read_keys(*table, path, material_keys(), material, report);
    if (report.count() == before) check_material(material, *table, report);
    deck.materials.push_back(material);
  }
}

void DeckReader::read_faces(const toml::table& body, std::vector<FaceDeck>& faces) {
  const toml::node* node = body.get("faces");
  if (!node) return;
  if (!node->is_table())
    return report.add(*node, "body.faces", "expected a table: write the faces under [body.faces]");
  const std::vector<std::string> kinds = {"fixed", "symmetric", "periodic"};
  std::vector<std::pair<toml::source_position, FaceDeck>> found;
  for (auto&& [name, value] : *node->as_table()) {
    FaceDeck face;
    face.face = name.str();
    const std::string path = "body.faces." + face.face;
    if (const toml::table* table = value.as_table()) {
      read_keys(*table, path, face_keys(), face, report);
      const bool moves = table->contains("velocity");
      face.kind = moves ? FaceKind::velocity : face.fixed ? FaceKind::fixed : FaceKind::free;
      if (moves && face.fixed)
        report.add(*table, path, "is fixed and has a velocity: expected one of the two. Leave one out");
      if (face.film && !face.temperature)
        report.add(*table, path, "has a film, but not the temperature of its surroundings. Give temperature");
      if (!moves && !face.fixed && !face.temperature)
        report.add(*table, path, "holds nothing. Give velocity, fixed = true or temperature");
      face.fixed = false; // kind has it
    } else if (value.is_string() &&
               std::find(kinds.begin(), kinds.end(), **value.as_string()) != kinds.end()) {
      face.kind = value_of_word<FaceKind>(**value.as_string());
    } else {
      const std::string hint = value.is_string() ? suggest(**value.as_string(), kinds) : "";
      report.add(
          value, path,
          R"(expected "fixed", "symmetric", "periodic", { velocity = ["0 m/s", "0 m/s", "1 m/s"] } or )"
          R"({ temperature = "300 K" }.)" +
              hint);
    }
    found.emplace_back(name.source().begin, face);
  }
  // Faces that meet are taken in the order of the deck.
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& face : found) faces.push_back(face.second);
}

void DeckReader::read_bodies() {
  const toml::node* node = root.get("body");
  if (!node) return report.add(0, "body", "the deck has no body. Add a section [[body]]");
  if (!node->is_array_of_tables())
    return report.add(*node, "body", "there can be several bodies: write [[body]], in double brackets");
  for (auto&& entry : *node->as_array()) {
    const toml::table& table = *entry.as_table();
    BodyDeck body;
    body.line = int(table.source().begin.line);
    const std::size_t before = report.count();
    read_keys(table, "body", body_keys(), body, report);
    read_faces(table, body.faces);
    if (report.count() == before) check_body(body, table, {place, int(deck.bodies.size())}, report);
    deck.bodies.push_back(body);
  }
}

void DeckReader::read_tool() {
  if (root.contains("tool")) {
    const toml::table& table = find_section("tool");
    if (&table == &empty) return; // reported
    ToolDeck tool;
    const std::size_t before = report.count();
    read_keys(table, "tool", tool_keys(), tool, report);
    if (report.count() == before) check_tool(tool, table, place, report);
    deck.tool = tool;
    if (root.contains("contact"))
      read_keys(find_section("contact"), "contact", contact_keys(), deck.contact, report);
    else
      report.add(table, "contact",
                 "is missing: the friction of the tool has no default. Write [contact] and friction");
  } else if (const toml::node* contact = root.get("contact")) {
    if (are_all_tied(deck))
      report.add(
          *contact, "contact",
          "there is no [tool] to touch, and no two bodies that no tie joins. Remove this section or add "
          "a tool");
    else
      read_keys(find_section("contact"), "contact", contact_keys(), deck.contact, report);
  }
}

void DeckReader::read_run() {
  const toml::table& table = find_section("run");
  const std::size_t before = report.count();
  read_keys(table, "run", run_keys(), deck.run, report);
  if (const toml::node* accuracy = table.get("accuracy"))
    deck.run.accuracy_line = int(accuracy->source().begin.line);
  if (report.count() > before || deck.run.end_time.has_value() != deck.run.end_immersion.has_value()) return;
  if (deck.run.end_time)
    report.add(*table.get("end_immersion"), "run.end_immersion",
               "give either end_time or end_immersion, not both");
  else
    report.add(table, "run.end_time",
               "is missing: nothing says when the run ends. Give end_time, or end_immersion");
}

void DeckReader::read_output() {
  const toml::table& table = find_section("output");
  const std::size_t before = report.count();
  read_keys(table, "output", output_keys(), deck.output, report);
  if (report.count() == before) check_output(deck.output, table, report);
  const toml::node* published = table.get("published");
  if (!published) return;
  const toml::array* rows = published->as_array();
  const bool is_list = rows && (rows->empty() || published->is_array_of_tables());
  if (!is_list)
    return report.add(*published, "output.published",
                      R"(expected a list such as [{ label = "measured", force = "10.5 N" }])");
  for (auto&& row : *rows)
    read_keys(*row.as_table(), "output.published", published_keys(), deck.output.published.emplace_back(),
              report);
}

void DeckReader::read_windows() {
  if (!root.contains("windows")) return;
  const toml::table& table = find_section("windows");
  if (&table == &empty) return; // reported
  WindowsDeck& windows = deck.windows.emplace();
  windows.line = int(table.source().begin.line);
  read_keys(table, "windows", windows_keys(), windows, report);
}

void DeckReader::read_mechanistic() {
  if (!root.contains("mechanistic")) return;
  const toml::table& table = find_section("mechanistic");
  if (&table == &empty) return; // reported
  deck.mechanistic = fill_mechanistic(table, report);
  if (!deck.tool || deck.tool->kind != ToolKind::end_mill)
    report.add(table, "mechanistic", "is a model of an end mill, and this deck has none. Remove the section");
}

Deck DeckReader::read() {
  read_top();
  read_materials();
  read_bodies();
  read_tool();
  read_keys(find_section("particles"), "particles", particles_keys(), deck.particles, report);
  read_keys(find_section("hexes"), "hexes", hexes_keys(), deck.hexes, report);
  read_keys(find_section("sleep"), "sleep", sleep_keys(), deck.sleep, report);
  read_keys(find_section("retire"), "retire", retire_keys(), deck.retire, report);
  read_run();
  read_output();
  read_windows();
  read_mechanistic();
  report.throw_if_any();
  add_library_materials(deck);
  check_deck(deck, root, report);
  report.throw_if_any();
  return deck;
}

std::string read_text(const std::string& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw DeckError(file + ": cannot read the deck: this is a folder. Give the path of a TOML file.");
  if (std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error))
    throw DeckError(file +
                    ": cannot read the deck: this is a pipe or a device, not a file. Give the path of a TOML "
                    "file.");
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (in && in.peek() != std::ifstream::traits_type::eof()) text << in.rdbuf();
  if (!in.is_open() || in.bad() || text.fail())
    throw DeckError(fmt::format("{}: cannot read the deck: {}. Give the path of a TOML file.", file,
                                std::strerror(errno)));
  return text.str();
}

} // namespace

bool conducts_heat(const Deck& deck) {
  return std::any_of(deck.materials.begin(), deck.materials.end(), [](const MaterialDeck& m) {
    return m.conductivity.greatest() > 0 && m.law != Law::rigid;
  });
}

bool heats_faces(const Deck& deck) {
  return std::any_of(deck.bodies.begin(), deck.bodies.end(), [](const BodyDeck& body) {
    return std::any_of(body.faces.begin(), body.faces.end(),
                       [](const FaceDeck& face) { return face.temperature.has_value(); });
  });
}

bool stress_knows_heat(const Deck& deck) {
  return std::any_of(deck.materials.begin(), deck.materials.end(), [](const MaterialDeck& m) {
    return m.law != Law::rigid && (m.thermal_expansion > 0 || !m.youngs_modulus.points.empty());
  });
}

namespace {

double extreme(const OverTemperature& table, bool greatest) {
  double found = table.points.empty() ? table.value : table.points.front()[1];
  for (const auto& [T, value] : table.points)
    found = greatest ? std::max(found, value) : std::min(found, value);
  return found;
}

} // namespace

double OverTemperature::least() const { return extreme(*this, false); }
double OverTemperature::greatest() const { return extreme(*this, true); }

const MaterialDeck* find_material(const Deck& deck, const std::string& name) {
  const auto at = std::find_if(deck.materials.begin(), deck.materials.end(),
                               [&](const MaterialDeck& m) { return m.name == name; });
  return at == deck.materials.end() ? nullptr : &*at;
}

double end_time_of(const Deck& deck) {
  if (deck.run.end_time) return *deck.run.end_time;
  return (*deck.run.end_immersion - deck.tool->start_angle) / deck.tool->spindle_speed;
}

// Hands the parsed file to `use`.
template <class Use>
auto with_table(const std::string& file, const Use& use) {
  const std::string text = read_text(file);
  try {
    const toml::table table = toml::parse(text, file);
    return use(table);
  } catch (const toml::parse_error& error) {
    const std::string description(error.description());
    const bool is_after_value = description.find("expected a comment or whitespace") != std::string::npos;
    const std::string advice = is_after_value ? " Values with units are text in quotes: \"10 um\"." : "";
    throw DeckError(
        fmt::format("{}:{}: this is not TOML: {}.{}", file, error.source().begin.line, description, advice));
  }
}

Deck read_deck(const std::string& file, const std::string& kept) {
  return with_table(file, [&](const toml::table& table) { return DeckReader({file, kept}, table).read(); });
}

MechanisticDeck read_mechanistic(const std::string& file) {
  return with_table(file, [&](const toml::table& table) {
    const toml::table* section = table["mechanistic"].as_table();
    if (!section)
      throw DeckError(file + ": mechanistic: is missing. Give a file with a section [mechanistic], as swarf "
                             "identify writes it.");
    DeckReport report(file);
    const MechanisticDeck model = fill_mechanistic(*section, report);
    report.throw_if_any();
    return model;
  });
}

} // namespace swarf
