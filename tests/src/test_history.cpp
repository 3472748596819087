#include "src/files/results.hpp"
#include "src/output/history.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <hdf5.h>

#include <cmath>
#include <complex>
#include <fstream>

namespace fs = std::filesystem;
using namespace swarf;
using ::testing::HasSubstr;

namespace {

HistorySample sample_at(double t) {
  HistorySample s;
  s.time = t, s.immersion = 60000 * t, s.step = 100 * t, s.dt = 1e-9;
  s.force = {3.0 + t, 4.0 / 3, -1e-17}, s.torque = 0.1;
  s.tooth_force[1] = {1, 2, 3};
  s.max_temperature = 987.654321012345678;
  return s;
}

// Of the middle half of the record, by least squares on cos and sin of the known frequency (amplitude,
// phase).
std::complex<double> fit_sine(const std::vector<double>& t, const std::vector<double>& v, double frequency) {
  double cc = 0, ss = 0, cs = 0, vc = 0, vs = 0;
  for (std::size_t i = t.size() / 4; i < 3 * t.size() / 4; ++i) {
    const double c = std::cos(2 * M_PI * frequency * t[i]), s = std::sin(2 * M_PI * frequency * t[i]);
    cc += c * c, ss += s * s, cs += c * s, vc += v[i] * c, vs += v[i] * s;
  }
  const double det = cc * ss - cs * cs;
  return {(vs * cc - vc * cs) / det, (vc * ss - vs * cs) / det}; // phase 0: real
}

std::vector<double> grid(std::size_t n, double step) {
  std::vector<double> t(n);
  for (std::size_t i = 0; i < n; ++i) t[i] = double(i) * step;
  return t;
}

} // namespace

// Forward and backward Butterworth of order 2 by the bilinear transform: |H|^2 = 1 / (1 + r^4),
// r = tan(pi f T) / tan(pi fc T) (Oppenheim & Schafer, Discrete-Time Signal Processing, 7.1), phase 0.
TEST(LowPass, attenuates_as_butterworth_without_phase) {
  const double step = 1e-6, cut = 1e4;
  const auto t = grid(4001, step);
  for (const double f : {1e3, 5e3, 1e4, 2e4, 5e4, 2e5}) {
    std::vector<double> v(t.size());
    for (std::size_t i = 0; i < t.size(); ++i) v[i] = std::sin(2 * M_PI * f * t[i]);
    const auto fitted = fit_sine(t, low_pass(t, v, cut), f);
    const double r = std::tan(M_PI * f * step) / std::tan(M_PI * cut * step);
    EXPECT_NEAR(fitted.real(), 1 / (1 + std::pow(r, 4)), 1e-6) << f;
    EXPECT_NEAR(fitted.imag(), 0, 1e-6) << f;
  }
}

// Straight lines have no high frequencies, ends included.
TEST(LowPass, keeps_a_straight_line) {
  const auto t = grid(200, 1e-6);
  std::vector<double> v;
  for (const double x : t) v.push_back(2 + 3e5 * x);
  const auto out = low_pass(t, v, 5e3);
  for (std::size_t i = 0; i < v.size(); ++i) EXPECT_NEAR(out[i], v[i], 1e-10 * v.back());
}

// Uneven samples of a slow sine (step varied by a half) come back within the error of linear interpolation,
// (2 pi f step)^2 / 8 for each of the two resamplings.
TEST(LowPass, takes_uneven_samples) {
  std::vector<double> t{0}, v{0};
  const double f = 1e3;
  for (int i = 1; i < 4000; ++i) {
    t.push_back(t.back() + 1e-6 * (1 + 0.5 * std::sin(0.1 * i)));
    v.push_back(std::sin(2 * M_PI * f * t.back()));
  }
  const auto out = low_pass(t, v, 1e5);
  for (std::size_t i = 200; i + 200 < t.size(); ++i)
    EXPECT_NEAR(out[i], v[i], 2 * std::pow(2 * M_PI * f * 1.5e-6, 2) / 8 + 1e-7);
}

TEST(LowPass, refuses_what_it_cannot_filter_and_leaves_what_needs_no_filter) {
  EXPECT_THROW(low_pass({0, 1, 1}, {1, 2, 3}, 0.1), std::invalid_argument);
  EXPECT_THROW(low_pass({0, 1}, {1, 2, 3}, 0.1), std::invalid_argument);
  EXPECT_EQ(low_pass({0, 1, 2, 3}, {1, 5, 2, 3}, 0.5), (std::vector<double>{1, 5, 2, 3})); // Nyquist
  EXPECT_EQ(low_pass({0, 1}, {1, 5}, 0.1), (std::vector<double>{1, 5}));
  EXPECT_TRUE(low_pass({}, {}, 1).empty());
}

TEST(History, reads_back_every_bit) {
  const TemporaryFolder folder;
  {
    HistoryFile file(folder / "history.csv", 2);
    for (int i = 0; i < 20; ++i) file.append(sample_at(i / 3.0));
  }
  const auto table = read_history(folder / "history.csv");
  const auto columns = history_columns(2);
  ASSERT_EQ(table.rows(), 20u);
  ASSERT_EQ(table.columns.size(), columns.size());
  for (int i = 0; i < 20; ++i) {
    const auto row = history_row(sample_at(i / 3.0), 2);
    for (std::size_t c = 0; c < row.size(); ++c) {
      EXPECT_EQ(table.columns[c].name, columns[c].name);
      EXPECT_EQ(table.values[c][std::size_t(i)], row[c]) << columns[c].name;
    }
  }
  EXPECT_EQ(table.at("force_planar")[0], std::hypot(3.0, 4.0 / 3));
  EXPECT_EQ(table.at("tooth2_force_y")[0], 2);
}

TEST(History, header_names_the_units) {
  const TemporaryFolder folder;
  { HistoryFile file(folder / "history.csv", 1); }
  EXPECT_THAT(read_text(folder / "history.csv"),
              HasSubstr("time [s],immersion [deg],step [1],dt [s],force_x [N],force_y [N]"));
}

TEST(History, each_sample_is_in_the_file_at_once) {
  const TemporaryFolder folder;
  HistoryFile file(folder / "history.csv", 1);
  for (std::size_t i = 0; i < 3; ++i) {
    file.append(sample_at(double(i)));
    EXPECT_EQ(read_history(folder / "history.csv").rows(), i + 1); // while it is still open
  }
}

TEST(History, restart_cuts_back_to_the_checkpoint) {
  const TemporaryFolder folder;
  const auto name = folder / "history.csv", other = folder / "other.csv";
  {
    HistoryFile file(name, 2), straight(other, 2);
    for (int i = 0; i < 10; ++i) file.append(sample_at(i)), straight.append(sample_at(i));
  }
  std::ofstream(name, std::ios::app) << "11,0.5,3"; // killed in the middle of a line
  EXPECT_EQ(read_history(name).rows(), 10u);
  {
    HistoryFile file(name, 2, 6);
    EXPECT_EQ(file.rows(), 6);
    for (int i = 6; i < 10; ++i) file.append(sample_at(i));
  }
  EXPECT_EQ(read_text(name), read_text(other));
}

TEST(History, says_what_is_wrong_with_a_file) {
  const TemporaryFolder folder;
  const auto name = folder / "history.csv";
  { HistoryFile file(name, 2); }
  EXPECT_THAT(message_of<ResultsError>([&] { HistoryFile(name, 2, 5); }), HasSubstr("holds 0 samples"));
  EXPECT_THAT(message_of<ResultsError>([&] { HistoryFile(name, 3, 0); }), HasSubstr("columns are not those"));
  std::ofstream(name) << "time [s],force_x [N]\n1,2\n3,abc\n";
  EXPECT_THAT(message_of<ResultsError>([&] { read_history(name); }),
              HasSubstr(":3: expected 2 numbers, found 'abc'"));
  std::ofstream(name) << "time [s],force_x [N]\n1\n";
  EXPECT_THAT(message_of<ResultsError>([&] { read_history(name); }),
              HasSubstr(":2: expected 2 numbers, found 1"));
  std::ofstream(name) << "time,force\n";
  EXPECT_THAT(message_of<ResultsError>([&] { read_history(name); }), HasSubstr("'time' has no unit"));
  EXPECT_THAT(message_of<ResultsError>([&] { read_history(folder / "none.csv"); }),
              HasSubstr("No such file"));
  EXPECT_THAT(message_of<ResultsError>([&] { HistoryTable{}.at("force_q"); }),
              HasSubstr("no column 'force_q'"));
}

TEST(History, full_disk_is_an_error) {
  EXPECT_THAT(message_of<ResultsError>([] { HistoryFile("/dev/full", 1); }),
              HasSubstr("No space left on device"));
}

// The resultant of the filtered components: noise of a high frequency about a constant (3, 4) leaves 5.
TEST(History, filtered_resultant_counts_no_noise) {
  HistoryTable table;
  for (const auto& column : history_columns(0)) table.columns.push_back(column);
  table.values.resize(table.columns.size());
  for (int i = 0; i < 2000; ++i) {
    HistorySample s = sample_at(i * 1e-6);
    const double noise = 10 * std::sin(2 * M_PI * 2e5 * s.time);
    s.force = {3 + noise, 4 - noise, 0};
    const auto row = history_row(s, 0);
    for (std::size_t c = 0; c < row.size(); ++c) table.values[c].push_back(row[c]);
  }
  const auto filtered = filter_history(table, 5e3);
  EXPECT_NEAR(filtered.at("force_planar")[1000], 5, 1e-4);
}

TEST(History, writes_hdf5_with_units_and_equal_bytes) {
  const TemporaryFolder folder;
  const ResultsFolder results = create_results(folder / "run");
  {
    HistoryFile file(results.history(), 2);
    for (int i = 0; i < 5000; ++i) file.append(sample_at(i * 1e-6));
  }
  write_history_results(results, 1e4);
  const std::string first = read_text(results.results());
  const hid_t file = H5Fopen(results.results().c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  const hid_t dataset = H5Dopen2(file, "/history/torque", H5P_DEFAULT);
  const hid_t units = H5Aopen(dataset, "units", H5P_DEFAULT), type = H5Aget_type(units);
  char text[8] = {};
  H5Aread(units, type, text);
  EXPECT_STREQ(text, "N m");
  EXPECT_GT(H5Lexists(file, "/history/force_planar_filtered", H5P_DEFAULT), 0);
  const hid_t space = H5Dget_space(dataset);
  hsize_t rows = 0, limit = 0;
  H5Sget_simple_extent_dims(space, &rows, &limit);
  EXPECT_EQ(rows, 5000u);
  EXPECT_EQ(limit, H5S_UNLIMITED);
  H5Sclose(space), H5Tclose(type), H5Aclose(units), H5Dclose(dataset), H5Fclose(file);

  sleep(1); // a time stamp would differ
  write_history_results(results, 1e4);
  EXPECT_TRUE(first == read_text(results.results()));
  EXPECT_EQ(read_history(results.filtered_history()).rows(), 5000u);
}

TEST(Results, new_run_clears_only_its_own_files) {
  const TemporaryFolder folder;
  const ResultsFolder results = create_results(folder / "a/b/run");
  write_file(results.checkpoint(), "old"), write_file(results.frames() / "frame_0003_tool.vtp", "old");
  write_file(results.path / "notes.txt", "mine"), write_file(results.pictures() / "mine.png", "mine");
  write_file(results.frames() / "frame_of_mine.vtu", "mine"), write_file(results.path / "probe", "mine");
  EXPECT_THAT(message_of<ResultsError>([&] { create_results(results.path, true); }),
              HasSubstr("checkpoint.h5: is in the way"))
      << "without a deck of swarf's beside it, it may be anybody's";
  write_file(results.deck(), std::string(resolved_mark) + " the deck\n");
  EXPECT_THAT(message_of<ResultsError>([&] { create_results(results.path); }),
              AllOf(HasSubstr("--resume"), HasSubstr("--overwrite")));
  create_results(results.path, true);
  EXPECT_FALSE(fs::exists(results.checkpoint()));
  EXPECT_FALSE(fs::exists(results.frames() / "frame_0003_tool.vtp"));
  for (const fs::path& file : {results.path / "notes.txt", results.pictures() / "mine.png",
                               results.frames() / "frame_of_mine.vtu", results.path / "probe"})
    EXPECT_EQ(read_text(file), "mine") << file;
}

TEST(Results, unwritable_folder_is_named) {
  const TemporaryFolder folder;
  write_file(folder / "file", "x");
  EXPECT_THAT(
      message_of<ResultsError>([&] { create_results(folder / "file/run"); }),
      AllOf(HasSubstr((folder / "file/run").string()), HasSubstr("Not a directory"), HasSubstr("--output")));
  EXPECT_THAT(message_of<ResultsError>([&] { create_results("/proc/run"); }),
              HasSubstr("/proc/run: cannot make"));
  EXPECT_THAT(message_of<ResultsError>([&] { open_results(folder / "none"); }),
              HasSubstr("no such results folder"));
  EXPECT_THAT(message_of<ResultsError>([&] { open_results(folder.path); }),
              HasSubstr("holds no history.csv"));
}

TEST(Results, full_disk_leaves_the_old_file) {
  const TemporaryFolder folder;
  write_file(folder / "summary.json", "old");
  fs::create_symlink("/dev/full", folder / "summary.json.tmp");
  EXPECT_THAT(message_of<ResultsError>([&] { write_file(folder / "summary.json", "new"); }),
              AllOf(HasSubstr("No space left on device"), HasSubstr("free some space")));
  EXPECT_EQ(read_text(folder / "summary.json"), "old");
}

TEST(Results, json_is_ordered_and_escaped) {
  Json json, inner;
  inner.set("b", 2).set("a", std::vector<double>{0.1, 1e-300});
  json.set("title", "a \"b\" \\ \n")
      .set("steps", 3L)
      .set("ok", true)
      .set("force", std::nan(""))
      .set("inner", Json().set("one", inner));
  json.set("steps", 4L);
  EXPECT_EQ(
      json.text(),
      "{\n  \"title\": \"a \\\"b\\\" \\\\ \\u000a\",\n  \"steps\": 4,\n  \"ok\": true,\n"
      "  \"force\": null,\n  \"inner\": {\n    \"one\": {\n      \"b\": 2,\n      \"a\": [0.1, 1e-300]\n"
      "    }\n  }\n}");
}

// FNV-1a, 64 bit: test vector of the authors (Fowler, Noll, Vo).
TEST(Results, hash_is_fnv1a) {
  EXPECT_EQ(hash_text(""), "cbf29ce484222325");
  EXPECT_EQ(hash_text("foobar"), "85944171f73967e8");
}
