#include "src/files/results.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

namespace swarf {
namespace fs = std::filesystem;

void fail_to(const fs::path& file, const std::string& action, int error) {
  throw ResultsError(
      fmt::format("{}: cannot {}: {}; {}", file.string(), action, std::strerror(error), advice_on(error)));
}

const char* advice_on(int error) {
  return error == ENOSPC || error == EDQUOT
             ? "free some space on that disk, or choose another folder with --output"
         : error == EFBIG  ? "raise the limit on file sizes (ulimit -f)"
         : error == ENOENT ? "check the path"
                           : "choose a folder that you may write with --output";
}

namespace {

void write_all(int fd, std::string_view content, const fs::path& file) {
  while (!content.empty()) {
    const ssize_t written = ::write(fd, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int error = errno;
      ::close(fd);
      ::unlink(temporary_name(file).c_str());
      fail_to(file, "write the results", error);
    }
    content.remove_prefix(static_cast<std::size_t>(written));
  }
}

void flush(const fs::path& file, int flags) {
  const int fd = ::open(file.c_str(), flags);
  if (fd < 0) fail_to(file, "open the results", errno);
  const int rc = ::fsync(fd);
  const int error = errno;
  ::close(fd);
  if (rc != 0 && error != EINVAL && error != EROFS) fail_to(file, "flush the results to the disk", error);
}

bool ends_in_number(const std::string& name, std::size_t from) { // at least four digits, then any suffix
  const auto end = name.find_first_not_of("0123456789", from);
  return end != name.npos && end >= from + 4;
}
bool is_frame(const std::string& name) {
  const bool part =
      name.ends_with("_particles.vtu") || name.ends_with("_hexes.vtu") || name.ends_with("_tool.vtp");
  return name.starts_with("frame_") && part && ends_in_number(name, 6);
}
bool is_picture(const std::string& name) {
  return name == "force.png" || name == "energy.png" || name == "heat.png" || name == "chip.png" ||
         name == "chip.mp4" ||
         ((name.starts_with("tool_") || name.starts_with("surface_")) && name.ends_with(".png")) ||
         (name.starts_with("chip_") && name.ends_with(".png") && ends_in_number(name, 5));
}

bool is_body(const std::string& name) {
  const auto end = name.find_first_not_of("0123456789", 5);
  return name.starts_with("body_") && end != name.npos && end > 5 &&
         (name.substr(end) == ".stl" || name.substr(end) == ".mesh");
}

void add_files(const fs::path& folder, bool (*ours)(const std::string&), std::vector<fs::path>& files) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (ours(entry->path().filename().string())) files.push_back(entry->path());
}

// What is there of the files that a run writes, by their names.
std::vector<fs::path> list_files(const ResultsFolder& results) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const fs::path& file :
       {results.history(), results.filtered_history(), results.results(), results.checkpoint(),
        results.summary(), results.frame_list(), results.paraview(), results.tool(), results.tool_heat()})
    if (fs::exists(file, ignored)) files.push_back(file);
  for (const char* name : {"surface.csv", "surface_heights.csv", "surface_history.csv", "surface.json"})
    if (fs::exists(results.path / name, ignored)) files.push_back(results.path / name);
  add_files(results.path, is_body, files);
  add_files(results.frames(), is_frame, files);
  add_files(results.pictures(), is_picture, files);
  return files;
}

} // namespace

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return fs::exists(a, error) && fs::exists(b, error) && fs::equivalent(a, b, error) && !error;
}

bool is_resolved_deck(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return false;
  std::string line;
  std::ifstream stream(file, std::ios::binary);
  return bool(std::getline(stream, line)) && line.starts_with(resolved_mark);
}

void check_free(const fs::path& folder, const std::vector<std::string>& inputs, bool overwrite) {
  const ResultsFolder results{folder};
  std::vector<fs::path> files = list_files(results);
  std::error_code ignored;
  bool has_results = false; // not only what was written before the first step
  for (const fs::path& file :
       {results.history(), results.checkpoint(), results.summary(), results.frame_list()})
    has_results = has_results || fs::exists(file, ignored);
  if (fs::exists(results.deck(), ignored)) files.insert(files.begin(), results.deck());
  for (const fs::path& file : files)
    for (const std::string& input : inputs)
      if (is_same_file(file, input))
        throw ResultsError(
            fmt::format("{}: the results would be written over this file, which the run reads; "
                        "choose another folder with --output",
                        file.string()));
  if (files.empty()) return;
  if (!is_resolved_deck(results.deck()))
    throw ResultsError(
        fmt::format("{}: is in the way: the results would be written over it, and nothing says "
                    "that swarf wrote it (no deck.toml of a run beside it); move it, or choose "
                    "another folder with --output",
                    files.front().string()));
  if (has_results && !overwrite)
    throw ResultsError(fmt::format("{}: holds the results of a run; go on from its checkpoint with --resume, "
                                   "replace them with --overwrite, or choose another folder with --output",
                                   folder.string()));
}

ResultsFolder create_results(const fs::path& folder, bool overwrite) {
  const ResultsFolder results{folder};
  check_free(folder, {}, overwrite);
  make_folder(folder), make_folder(results.frames()), make_folder(results.pictures());
  for (const fs::path& file : list_files(results)) {
    std::error_code error;
    fs::remove(file, error);
    if (error) fail_to(file, "remove the earlier results", error.value());
  }
  return results;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder, error)) error = std::make_error_code(std::errc::not_a_directory);
  if (error) fail_to(folder, "make the results folder", error.value());
}

ResultsFolder open_results(const fs::path& folder) {
  const ResultsFolder results{folder};
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    throw ResultsError(fmt::format("{}: no such results folder; give the folder that a run wrote, "
                                   "for example results/micro_milling_quick",
                                   folder.string()));
  if (!fs::exists(results.history(), ignored))
    throw ResultsError(fmt::format(
        "{}: holds no history.csv, so no run of swarf wrote it; give the folder of a run", folder.string()));
  return results;
}

fs::path temporary_name(const fs::path& file) { return file.string() + ".tmp"; }

void commit_file(const fs::path& file) {
  const fs::path temporary = temporary_name(file);
  flush(temporary, O_WRONLY);
  if (::rename(temporary.c_str(), file.c_str()) != 0) fail_to(file, "rename the finished file", errno);
  const fs::path folder = file.parent_path();
  flush(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY);
}

void write_file(const fs::path& file, std::string_view content) {
  const fs::path temporary = temporary_name(file);
  const int fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (fd < 0) fail_to(file, "write the results", errno);
  write_all(fd, content, file);
  if (::close(fd) != 0) fail_to(file, "write the results", errno);
  commit_file(file);
}

std::string read_text(const fs::path& file) {
  errno = 0; // of something else
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  const bool is_empty = stream && stream.peek() == std::ifstream::traits_type::eof() && errno == 0;
  if (is_empty) return ""; // of which << makes an error
  if (!stream || !(text << stream.rdbuf()))
    throw ResultsError(fmt::format("{}: cannot read it: {}; give the folder of a finished or stopped run",
                                   file.string(), std::strerror(errno)));
  return text.str();
}

std::string hash_text(std::string_view text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return fmt::format("{:016x}", hash);
}

namespace {

std::string quote(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out += '\\', out += c;
    else if (static_cast<unsigned char>(c) < 0x20)
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      out += c;
  }
  return out + '"';
}
std::string number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : "null"; }

} // namespace

Json& Json::put(const std::string& key, std::string value) {
  for (auto& [name, old] : members)
    if (name == key) {
      old = std::move(value);
      return *this;
    }
  members.emplace_back(key, std::move(value));
  return *this;
}
Json& Json::set(const std::string& key, double value) { return put(key, number(value)); }
Json& Json::set(const std::string& key, long long value) { return put(key, fmt::format("{}", value)); }
Json& Json::set(const std::string& key, bool value) { return put(key, value ? "true" : "false"); }
Json& Json::set(const std::string& key, const std::string& value) { return put(key, quote(value)); }
Json& Json::set(const std::string& key, const std::vector<double>& values) {
  std::string list;
  for (const double value : values) list += (list.empty() ? "" : ", ") + number(value);
  return put(key, "[" + list + "]");
}
Json& Json::set(const std::string& key, const Json& object) {
  std::string inner;
  for (const char c : object.text()) inner += c == '\n' ? std::string("\n  ") : std::string(1, c);
  return put(key, inner);
}

std::string Json::text() const {
  std::string out;
  for (const auto& [key, value] : members)
    out += fmt::format("{}\n  {}: {}", out.empty() ? "" : ",", quote(key), value);
  return out.empty() ? "{}" : "{" + out + "\n}";
}

} // namespace swarf
