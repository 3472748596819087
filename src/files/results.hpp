// The folder of one run: where each file lies, and writing that leaves only whole files behind.
#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace swarf {

// what() is a whole message: file or folder, what went wrong, what to do.
struct ResultsError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct ResultsFolder {
  std::filesystem::path path;

  std::filesystem::path deck() const { return path / "deck.toml"; } // resolved: every default written out
  std::filesystem::path history() const { return path / "history.csv"; }
  std::filesystem::path filtered_history() const { return path / "history_filtered.csv"; }
  std::filesystem::path results() const { return path / "results.h5"; }
  std::filesystem::path checkpoint() const { return path / "checkpoint.h5"; }
  std::filesystem::path summary() const { return path / "summary.json"; }
  std::filesystem::path frames() const { return path / "frames"; }
  std::filesystem::path frame_list() const { return path / "frames.csv"; }
  std::filesystem::path paraview() const { return path / "frames.pvd"; }
  std::filesystem::path pictures() const { return path / "pictures"; }
  std::filesystem::path mechanistic() const { return path / "mechanistic.csv"; } // of the deck, not of a run
  std::filesystem::path tool() const { return path / "tool.stl"; }
  // The file that a body of the deck was filled from; kind: stl or mesh.
  std::filesystem::path body(int row, const std::string& kind) const {
    return path / ("body_" + std::to_string(row + 1) + "." + kind);
  }
  std::filesystem::path tool_heat() const { return path / "tool_heat.h5"; } // at the end of the run
};

// Throws ResultsError where a new run must not write: over one of `inputs`, over a file that swarf did not
// write, or, unless `overwrite`, over the results of an earlier run. Changes nothing.
void check_free(const std::filesystem::path& folder, const std::vector<std::string>& inputs, bool overwrite);
// A folder for a new run: made if missing, and emptied of the files of an earlier run, no others. Throws
// ResultsError if it cannot be written, or as check_free does.
ResultsFolder create_results(const std::filesystem::path& folder, bool overwrite = false);
// The folder of a run that exists (restart, plot, render). Throws ResultsError if it holds no history.
ResultsFolder open_results(const std::filesystem::path& folder);
// Whether swarf wrote this deck: resolved decks say so in their first line.
inline constexpr const char* resolved_mark = "# Written by swarf:";
bool is_resolved_deck(const std::filesystem::path& file);
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b); // and both are there

// ResultsError "FILE: cannot ACTION: what the system says; what to do", for an error number of the system.
[[noreturn]] void fail_to(const std::filesystem::path& file, const std::string& action, int error);
const char* advice_on(int error);                      // the last part of it
void make_folder(const std::filesystem::path& folder); // with those above it

// Writes FILE.tmp, flushes it to the disk and renames it: at every moment FILE is absent, the old or the new
// one.
void write_file(const std::filesystem::path& file, std::string_view content);
// The same last act for a file that something else wrote as temporary_name(file).
std::filesystem::path temporary_name(const std::filesystem::path& file);
void commit_file(const std::filesystem::path& file);
// The whole text of a file. Throws ResultsError.
std::string read_text(const std::filesystem::path& file);

// 16 hex digits of FNV-1a (64 bit): tells one deck from another.
std::string hash_text(std::string_view text);

// An ordered JSON object for summary.json. Numbers keep full precision; NaN and infinity become null.
class Json {
 public:
  Json& set(const std::string& key, double value);
  Json& set(const std::string& key, int value) { return set(key, static_cast<long long>(value)); }
  Json& set(const std::string& key, long value) { return set(key, static_cast<long long>(value)); }
  Json& set(const std::string& key, long long value);
  Json& set(const std::string& key, bool value);
  Json& set(const std::string& key, const char* value) { return set(key, std::string(value)); }
  Json& set(const std::string& key, const std::string& value);
  Json& set(const std::string& key, const std::vector<double>& values);
  Json& set(const std::string& key, const Json& object);
  std::string text() const;

 private:
  Json& put(const std::string& key, std::string value);
  std::vector<std::pair<std::string, std::string>> members; // value as JSON text
};

} // namespace swarf
