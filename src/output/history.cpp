#include "src/output/history.hpp"

#include "src/files/results.hpp"
#include "src/output/write_hdf5.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>

namespace swarf {
namespace fs = std::filesystem;
namespace {

// One declaration per column: its name, unit and value.
template <class Visitor>
void for_each_column(const HistorySample& s, int teeth, Visitor&& visit) {
  visit("time", "s", s.time), visit("immersion", "deg", s.immersion), visit("step", "1", s.step);
  visit("dt", "s", s.dt);
  visit("force_x", "N", s.force[0]), visit("force_y", "N", s.force[1]), visit("force_z", "N", s.force[2]);
  visit("force_planar", "N", std::hypot(s.force[0], s.force[1])), visit("torque", "N m", s.torque);
  for (int k = 0; k < teeth; ++k)
    for (int c = 0; c < 3; ++c)
      visit(fmt::format("tooth{}_force_{}", k + 1, "xyz"[c]), "N",
            s.tooth_force[std::size_t(k)][std::size_t(c)]);
  visit("kinetic_energy", "J", s.kinetic), visit("elastic_energy", "J", s.elastic);
  visit("plastic_work", "J", s.plastic), visit("friction_work", "J", s.frictional);
  visit("viscous_work", "J", s.viscous), visit("hourglass_work", "J", s.hourglass);
  visit("contact_energy", "J", s.contact), visit("tie_work", "J", s.tie);
  visit("shifting_work", "J", s.shifting);
  visit("external_work", "J", s.external), visit("energy_residual", "J", s.residual);
  visit("plastic_heat", "J", s.plastic_heat), visit("work_heat", "J", s.work_heat);
  visit("tool_heat", "J", s.tool_heat), visit("heat_out", "J", s.heat_out);
  visit("heat_residual", "J", s.heat_residual);
  visit("tool_max_temperature", "K", s.tool_hottest);
  for (int c = 0; c < 3; ++c)
    visit(fmt::format("tool_hottest_{}", "xyz"[c]), "m", s.tool_hottest_at[std::size_t(c)]);
  visit("max_temperature", "K", s.max_temperature), visit("max_plastic_strain", "1", s.max_plastic_strain);
  visit("max_velocity", "m/s", s.max_velocity);
  visit("particles_in_contact", "1", s.particles_in_contact);
}

std::string header_line(const std::vector<HistoryColumn>& columns) {
  std::string line;
  for (const auto& column : columns)
    line += fmt::format("{}{} [{}]", line.empty() ? "" : ",", column.name, column.unit);
  return line + '\n';
}

// fmt's "{}" is the shortest text that reads back to the same double.
std::string row_line(const std::vector<double>& row) { return fmt::format("{}\n", fmt::join(row, ",")); }

HistoryColumn parse_column(std::string_view text, const fs::path& file) {
  const auto open = text.find(" [");
  if (open == text.npos || text.back() != ']')
    throw ResultsError(
        fmt::format("{}:1: column '{}' has no unit, expected 'name [unit]'; this is no history of swarf",
                    file.string(), text));
  return {std::string(text.substr(0, open)), std::string(text.substr(open + 2, text.size() - open - 3))};
}

// Calls part(text) for each field of a comma separated line.
template <class Part>
void split(std::string_view line, Part&& part) {
  for (std::size_t start = 0; start <= line.size();) {
    const auto comma = std::min(line.find(',', start), line.size());
    part(line.substr(start, comma - start));
    start = comma + 1;
  }
}

void parse_row(std::string_view line, long number, const fs::path& file, HistoryTable& table) {
  std::size_t column = 0;
  split(line, [&](std::string_view field) {
    double value = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc{} || end != field.data() + field.size() || column >= table.columns.size())
      throw ResultsError(
          fmt::format("{}:{}: expected {} numbers, found '{}' as number {}; the file was damaged after "
                      "the run, copy it again or start the run anew with --overwrite",
                      file.string(), number, table.columns.size(), field, column + 1));
    table.values[column++].push_back(value);
  });
  if (column != table.columns.size())
    throw ResultsError(
        fmt::format("{}:{}: expected {} numbers, found {}; the file was damaged after the run, "
                    "copy it again or start the run anew with --overwrite",
                    file.string(), number, table.columns.size(), column));
}

} // namespace

std::vector<HistoryColumn> history_columns(int teeth) {
  std::vector<HistoryColumn> columns;
  for_each_column({}, teeth, [&](const std::string& name, const char* unit, double) {
    columns.push_back({name, unit});
  });
  return columns;
}

std::vector<double> history_row(const HistorySample& sample, int teeth) {
  std::vector<double> row;
  for_each_column(sample, teeth,
                  [&](const std::string&, const char*, double value) { row.push_back(value); });
  return row;
}

HistoryFile::HistoryFile(const fs::path& file, int number_of_teeth) : name(file), teeth(number_of_teeth) {
  descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor < 0) fail_to(file, "write the history", errno);
  write(header_line(history_columns(teeth)));
}

HistoryFile::HistoryFile(const fs::path& file, int number_of_teeth, long rows)
    : name(file), teeth(number_of_teeth), count(rows) {
  const std::string text = read_text(file);
  if (!text.starts_with(header_line(history_columns(teeth))))
    throw ResultsError(
        fmt::format("{}:1: the columns are not those of this run; restart in the folder that the "
                    "checkpoint was written in",
                    file.string()));
  std::size_t end = 0;
  HistoryTable kept; // read now: a damaged row would otherwise be found when the run has ended
  kept.columns = history_columns(teeth), kept.values.resize(kept.columns.size());
  for (long line = 0; line <= rows; ++line) {
    const auto newline = text.find('\n', end);
    if (newline == text.npos)
      throw ResultsError(
          fmt::format("{}: holds {} samples, the checkpoint was written after {}; the history was "
                      "changed after the run, start the run again",
                      file.string(), line - 1, rows));
    if (line > 0) parse_row(std::string_view(text).substr(end, newline - end), line + 1, file, kept);
    end = newline + 1;
  }
  descriptor = ::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (descriptor < 0 || ::ftruncate(descriptor, static_cast<off_t>(end)) != 0)
    throw ResultsError(fmt::format("{}: cannot continue the history: {}; make the file writable",
                                   file.string(), std::strerror(errno)));
}

HistoryFile::~HistoryFile() {
  if (descriptor >= 0) ::close(descriptor);
}

void HistoryFile::write(const std::string& line) {
  std::string_view rest = line;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail_to(name, "write the history", errno);
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
}

void HistoryFile::append(const HistorySample& sample) {
  write(row_line(history_row(sample, teeth)));
  ++count;
}

bool HistoryTable::has(const std::string& column) const {
  for (const auto& c : columns)
    if (c.name == column) return true;
  return false;
}

const std::vector<double>& HistoryTable::at(const std::string& column) const {
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].name == column) return values[c];
  throw ResultsError(
      fmt::format("the history has no column '{}'; it was written by another version of swarf", column));
}

HistoryTable read_history(const fs::path& file) {
  const std::string text = read_text(file);
  HistoryTable table;
  long number = 0;
  for (std::size_t start = 0; start < text.size();) {
    const auto end = text.find('\n', start);
    if (end == text.npos) break;
    const std::string_view line(text.data() + start, end - start);
    if (++number == 1) {
      split(line, [&](std::string_view field) { table.columns.push_back(parse_column(field, file)); });
      table.values.resize(table.columns.size());
    } else {
      parse_row(line, number, file, table);
    }
    start = end + 1;
  }
  if (number == 0)
    throw ResultsError(fmt::format("{}: is empty; the run stopped before it wrote anything", file.string()));
  return table;
}

void write_table(const HistoryTable& table, const fs::path& file) {
  std::string text = header_line(table.columns);
  std::vector<double> row(table.columns.size());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    for (std::size_t c = 0; c < row.size(); ++c) row[c] = table.values[c][i];
    text += row_line(row);
  }
  write_file(file, text);
}

HistoryTable filter_history(const HistoryTable& history, double frequency) {
  const auto& time = history.at("time");
  if (frequency <= 0) frequency = default_filter_frequency(time);
  HistoryTable out;
  const auto add = [&](const char* name, const char* unit, std::vector<double> values) {
    out.columns.push_back({name, unit}), out.values.push_back(std::move(values));
  };
  const auto filter = [&](const char* name) { return low_pass(time, history.at(name), frequency); };
  const auto x = filter("force_x"), y = filter("force_y");
  std::vector<double> planar(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) planar[i] = std::hypot(x[i], y[i]);
  add("time", "s", time), add("immersion", "deg", history.at("immersion"));
  add("force_x", "N", x), add("force_y", "N", y), add("force_z", "N", filter("force_z"));
  add("force_planar", "N", planar), add("torque", "N m", filter("torque"));
  return out;
}

void write_history_results(const ResultsFolder& results, double filter_frequency) {
  const HistoryTable history = read_history(results.history());
  const HistoryTable filtered = filter_history(history, filter_frequency);
  write_history_hdf5(results.results(), history, filtered);

  write_table(filtered, results.filtered_history());
}

} // namespace swarf
