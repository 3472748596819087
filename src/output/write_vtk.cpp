#include "src/output/write_vtk.hpp"
#include "src/files/say.hpp"
#include "src/output/write_parts.hpp"

#include <fmt/format.h>

#include <charconv>
#include <sstream>

namespace swarf {
namespace fs = std::filesystem;
namespace {

const char* extension(const std::string& part) { return part == "tool" ? "vtp" : "vtu"; }

// Calls part(name) for each file that the frame has.
template <class Part>
void for_each_part(const FrameEntry& entry, Part&& part) {
  if (entry.hexes) part("hexes");
  if (entry.particles) part("particles");
  if (entry.tool) part("tool");
}

constexpr const char* list_header = "frame,time [s],immersion [deg],parts,checksums\n";
constexpr const char* old_list_header = "frame,time [s],immersion [deg],parts\n";

void say_what_is_missing(const ResultsFolder& results, const std::vector<FrameEntry>& entries) {
  std::string missing;
  int count = 0;
  for (const FrameEntry& entry : entries)
    for_each_part(entry, [&](const char* part) {
      const fs::path file = frame_file(results, entry.index, part);
      std::error_code ignored;
      if (fs::exists(file, ignored) || ++count > 5) return;
      missing += (missing.empty() ? "" : ", ") + file.string();
    });
  if (count > 0)
    complain("warning: {} file(s) of the earlier frames are missing: {}{}. The run goes on without them; "
             "copy them "
             "back if you need them.",
             count, missing, count > 5 ? ", ..." : "");
}

} // namespace

fs::path frame_file(const ResultsFolder& results, int index, const std::string& part) {
  return results.frames() / fmt::format("frame_{:04d}_{}.{}", index, part, extension(part));
}

FrameSeries::FrameSeries(const ResultsFolder& folder, int frames)
    : results(folder), entries(read_frame_list(folder)) {
  if (count() < frames)
    throw ResultsError(
        fmt::format("{}: lists {} frames, the checkpoint was written after {}; the frames were changed "
                    "after the run, start the run again",
                    results.frame_list().string(), count(), frames));
  while (count() > frames) {
    const FrameEntry last = entries.back();
    entries.pop_back();
    write_lists(); // first, so that no list names a file that is gone
    for_each_part(last, [&](const char* part) {
      std::error_code error;
      fs::remove(frame_file(results, last.index, part), error);
      if (error) fail_to(frame_file(results, last.index, part), "remove a frame of later", error.value());
    });
  }
  say_what_is_missing(results, entries);
}

void FrameSeries::write(const FrameData& frame) {
  if (!can_write_frames()) return;
  FrameEntry entry{count(),
                   frame.time,
                   frame.immersion,
                   !frame.particles.position.empty(),
                   !frame.hexes.connectivity.empty(),
                   !frame.tool.empty(),
                   {}};
  for_each_part(entry, [&](const std::string& part) {
    const fs::path file = frame_file(results, entry.index, part);
    entry.checksums[part] = write_part(file, part, frame);
  });
  entries.push_back(entry);
  write_lists();
}

void FrameSeries::write_lists() const {
  std::string list = list_header,
              pvd = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n"
                    "  <Collection>\n";
  for (const FrameEntry& entry : entries) {
    list += fmt::format("{},{},{},", entry.index, entry.time,
                        entry.immersion ? fmt::format("{}", *entry.immersion) : "");
    int part_number = 0;
    for_each_part(entry, [&](const std::string& part) {
      list += (part_number ? " " : "") + part;
      pvd += fmt::format("    <DataSet timestep=\"{}\" part=\"{}\" name=\"{}\" file=\"frames/{}\"/>\n",
                         entry.time, part_number++, part,
                         frame_file(results, entry.index, part).filename().string());
    });
    std::string checksums;
    for_each_part(entry, [&](const std::string& part) {
      const auto found = entry.checksums.find(part);
      if (found != entry.checksums.end()) checksums += (checksums.empty() ? "" : " ") + found->second;
    });
    list += "," + checksums + '\n';
  }
  pvd += "  </Collection>\n</VTKFile>\n";
  write_file(results.paraview(), pvd);
  write_file(results.frame_list(), list);
}

std::vector<FrameEntry> read_frame_list(const ResultsFolder& results) {
  std::error_code ignored;
  if (!fs::exists(results.frame_list(), ignored)) return {};
  const std::string text = read_text(results.frame_list());
  std::vector<FrameEntry> entries;
  const auto damaged = [&] {
    throw ResultsError(
        fmt::format("{}:{}: expected 'frame,time,immersion,parts'; the list of frames is damaged, "
                    "run again",
                    results.frame_list().string(), entries.size() + 2));
  };
  if (!text.starts_with(list_header) && !text.starts_with(old_list_header)) damaged();
  for (std::size_t start = text.find('\n') + 1; start < text.size();) {
    const auto end = std::min(text.find('\n', start), text.size());
    const char* at = text.data() + start;
    const char* const stop = text.data() + end;
    FrameEntry entry;
    const auto number = [&](auto& value) {
      const auto [next, error] = std::from_chars(at, stop, value);
      if (error != std::errc{} || next == stop || *next != ',') damaged();
      at = next + 1;
    };
    number(entry.index), number(entry.time);
    if (at != stop && *at != ',') {
      entry.immersion.emplace();
      number(*entry.immersion);
    } else {
      ++at;
    }
    const std::string_view rest(at, at < stop ? std::size_t(stop - at) : 0);
    const std::string_view parts = rest.substr(0, rest.find(','));
    std::istringstream checksums(std::string(rest.substr(std::min(rest.size(), parts.size() + 1))));
    entry.particles = parts.find("particles") != parts.npos, entry.hexes = parts.find("hexes") != parts.npos;
    entry.tool = parts.find("tool") != parts.npos;
    for_each_part(entry, [&](const char* part) {
      if (std::string sum; checksums >> sum) entry.checksums[part] = sum;
    });
    if (entry.index != int(entries.size())) damaged();
    entries.push_back(entry);
    start = end + 1;
  }
  return entries;
}

void check_frame_file(const std::filesystem::path& file, const FrameEntry& entry, const std::string& part) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    throw ResultsError(fmt::format(
        "{}: is missing, though frames.csv lists it; copy it again, or run the deck anew with --overwrite",
        file.string()));
  const std::string bytes = read_text(file);
  const auto sum = entry.checksums.find(part);
  if (sum != entry.checksums.end() && hash_text(bytes) != sum->second)
    throw ResultsError(
        fmt::format("{}: is not what the run wrote: it was changed or damaged since; copy it again, or "
                    "resume the run from its checkpoint",
                    file.string()));
}

} // namespace swarf
