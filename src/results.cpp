#include "src/results.hpp"

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
namespace {

[[noreturn]] void fail(const fs::path& file, const std::string& action, int error) {
  const char* advice = error == ENOSPC
                           ? "free some space on that disk, or choose another folder with --output"
                       : error == EFBIG  ? "raise the limit on file sizes (ulimit -f)"
                       : error == ENOENT ? "check the path"
                                         : "choose a folder that you may write with --output";
  throw ResultsError(
      fmt::format("{}: cannot {}: {}; {}", file.string(), action, std::strerror(error), advice));
}

void write_all(int fd, std::string_view content, const fs::path& file) {
  while (!content.empty()) {
    const ssize_t written = ::write(fd, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int error = errno;
      ::close(fd);
      fail(file, "write the results", error);
    }
    content.remove_prefix(static_cast<std::size_t>(written));
  }
}

void flush(const fs::path& file, int flags) {
  const int fd = ::open(file.c_str(), flags);
  if (fd < 0) fail(file, "open the results", errno);
  const int rc = ::fsync(fd);
  const int error = errno;
  ::close(fd);
  if (rc != 0 && error != EINVAL && error != EROFS) fail(file, "flush the results to the disk", error);
}

bool is_frame(const std::string& name) { return name.starts_with("frame_") && name.find(".v") != name.npos; }
bool is_picture(const std::string& name) { return name.ends_with(".png"); }

void remove_files(const fs::path& folder, bool (*ours)(const std::string&)) {
  if (!fs::is_directory(folder)) return;
  for (const auto& entry : fs::directory_iterator(folder))
    if (ours(entry.path().filename().string())) fs::remove(entry.path());
}

} // namespace

ResultsFolder create_results(const fs::path& folder) {
  const ResultsFolder results{folder};
  try {
    fs::create_directories(results.frames());
    fs::create_directories(results.pictures());
    for (const fs::path& file :
         {results.deck(), results.history(), results.filtered_history(), results.results(),
          results.checkpoint(), results.summary(), results.frame_list(), results.paraview()})
      fs::remove(file);
    remove_files(results.frames(), is_frame);
    remove_files(results.pictures(), is_picture);
    write_file(folder / "probe", "can this folder be written?\n");
    fs::remove(folder / "probe");
  } catch (const fs::filesystem_error& error) {
    fail(folder, "make the results folder", error.code().value());
  }
  return results;
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
  if (::rename(temporary.c_str(), file.c_str()) != 0) fail(file, "rename the finished file", errno);
  const fs::path folder = file.parent_path();
  flush(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY);
}

void write_file(const fs::path& file, std::string_view content) {
  const fs::path temporary = temporary_name(file);
  const int fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (fd < 0) fail(file, "write the results", errno);
  write_all(fd, content, file);
  if (::close(fd) != 0) fail(file, "write the results", errno);
  commit_file(file);
}

std::string read_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
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
