#include "src/output/write_hdf5.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <hdf5.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <fstream>
#include <random>

namespace fs = std::filesystem;
using namespace swarf;
using ::testing::AllOf;
using ::testing::HasSubstr;

namespace {

struct State {
  VectorField position;
  TensorField gradient;
  IndexField identity;
  View<unsigned*> constraints;
  View<long*> start;
  View<Real* [8][3]> corner;
  ScalarField empty;
  std::vector<double> host;
  double time = 0;
  long step = 0;

  template <class Visitor>
  void for_each_field(Visitor&& visit) {
    visit("position", position), visit("gradient", gradient), visit("identity", identity);
    visit("constraints", constraints), visit("start", start), visit("corner", corner), visit("empty", empty);
  }
};

// Random bit patterns of finite numbers; rows enough for several chunks.
State make_state(int rows, unsigned seed) {
  State s;
  std::mt19937_64 random(seed);
  s.position = VectorField("position", rows), s.gradient = TensorField("gradient", rows);
  s.identity = IndexField("identity", rows), s.constraints = View<unsigned*>("constraints", rows);
  s.start = View<long*>("start", rows + 1), s.corner = View<Real* [8][3]>("corner", rows / 10);
  s.for_each_field([&](const char*, auto& field) {
    auto host = Kokkos::create_mirror_view(field);
    using T = typename std::decay_t<decltype(field)>::non_const_value_type;
    for (std::size_t i = 0; i < host.span(); ++i) host.data()[i] = T(std::int64_t(random()) >> 40) / T(3);
    Kokkos::deep_copy(field, host);
  });
  s.host = {1, 0.1, -0.0, 1e-310};
  s.time = 0.1 * seed, s.step = 1L << 40;
  return s;
}

void write_state(const fs::path& file, State& s) {
  CheckpointWriter writer(file, "a-deck");
  s.for_each_field([&](const std::string& name, auto& field) { writer.put("particles/" + name, field); });
  writer.put("host", s.host);
  writer.put("time", s.time);
  writer.put("run/step", s.step);
  writer.finish();
}

State read_state(const fs::path& file) {
  const CheckpointReader reader(file);
  State s;
  s.for_each_field([&](const std::string& name, auto& field) { reader.get("particles/" + name, field); });
  reader.get("host", s.host);
  reader.get("time", s.time);
  reader.get("run/step", s.step);
  return s;
}

template <class V>
std::string bytes_of(const V& view) {
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view);
  return {reinterpret_cast<const char*>(host.data()), host.span() * sizeof(*host.data())};
}

std::string all_bytes(State& s) {
  std::string out;
  s.for_each_field([&](const char*, auto& field) { out += bytes_of(field); });
  out.append(reinterpret_cast<const char*>(s.host.data()), s.host.size() * sizeof(double));
  out.append(reinterpret_cast<const char*>(&s.time), sizeof s.time);
  return out.append(reinterpret_cast<const char*>(&s.step), sizeof s.step);
}

std::string read_error(const fs::path& file) {
  return message_of<ResultsError>([&] { read_state(file); });
}

} // namespace

TEST(CheckpointFile, gives_back_every_bit) {
  const TemporaryFolder folder;
  State written = make_state(50000, 7);
  write_state(folder / "c.h5", written);
  State read = read_state(folder / "c.h5");
  EXPECT_TRUE(all_bytes(written) == all_bytes(read));
  EXPECT_EQ(read.empty.extent(0), 0u);
  EXPECT_EQ(read.corner.extent(0), 5000u);
  EXPECT_EQ(CheckpointReader(folder / "c.h5").deck(), "a-deck");
}

TEST(CheckpointFile, equal_states_give_equal_files) {
  const TemporaryFolder folder;
  State s = make_state(1000, 7);
  write_state(folder / "a.h5", s);
  sleep(1); // a time stamp would differ
  write_state(folder / "b.h5", s);
  EXPECT_TRUE(read_text(folder / "a.h5") == read_text(folder / "b.h5"));
}

TEST(CheckpointFile, unfinished_one_leaves_the_one_before) {
  const TemporaryFolder folder;
  State first = make_state(1000, 1), second = make_state(1000, 2);
  write_state(folder / "c.h5", first);
  {
    CheckpointWriter writer(folder / "c.h5", "a-deck");
    writer.put("particles/position", second.position);
  }
  State read = read_state(folder / "c.h5");
  EXPECT_TRUE(all_bytes(first) == all_bytes(read));
  EXPECT_FALSE(fs::exists(folder / "c.h5.tmp"));
}

// A child writes checkpoints of alternating states until kill -9 at a random time.
TEST(CheckpointFile, survives_kill_at_any_moment) {
  const TemporaryFolder folder;
  const auto file = folder / "c.h5";
  State states[2] = {make_state(20000, 1), make_state(20000, 2)};
  write_state(file, states[0]);
  const std::string bytes[2] = {all_bytes(states[0]), all_bytes(states[1])};
  std::mt19937 random(3);
  for (int round = 0; round < 15; ++round) {
    const pid_t child = fork();
    if (child == 0) {
      // Only host copies: a forked child has none of the parent's threads.
      for (int k = 1;; ++k) {
        CheckpointWriter writer(file, "a-deck");
        State& s = states[k % 2];
        s.for_each_field([&](const std::string& name, auto& field) {
          std::vector<typename std::decay_t<decltype(field)>::non_const_value_type> flat(
              field.data(), field.data() + field.span());
          writer.put("particles/" + name, flat);
        });
        writer.put("time", s.time);
        writer.finish();
      }
    }
    usleep(2000 + random() % 60000);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const CheckpointReader reader(file);
    double time = 0;
    reader.get("time", time);
    const int which = time == states[0].time ? 0 : 1;
    EXPECT_EQ(time, states[which].time);
    if (reader.shape("particles/position").size() == 2) continue; // the first, from before the kills
    std::vector<Real> position;
    reader.get("particles/position", position);
    ASSERT_EQ(position.size(), 60000u);
    EXPECT_EQ(std::string(reinterpret_cast<char*>(position.data()), position.size() * sizeof(Real)),
              bytes[which].substr(0, position.size() * sizeof(Real)));
  }
}

TEST(CheckpointFile, truncated_anywhere_is_an_error) {
  const TemporaryFolder folder;
  State s = make_state(2000, 5);
  write_state(folder / "c.h5", s);
  const std::string whole = read_text(folder / "c.h5");
  testing::internal::CaptureStderr();
  for (int k = 0; k < 40; ++k) {
    std::ofstream(folder / "cut.h5", std::ios::binary) << whole.substr(0, whole.size() * std::size_t(k) / 40);
    EXPECT_THAT(read_error(folder / "cut.h5"),
                AllOf(HasSubstr("cut.h5: the checkpoint"), HasSubstr("start the run anew")));
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "HDF5 must not print";
}

// One flipped bit anywhere: an error, or (in a gap of the file) the same state. Never another state.
TEST(CheckpointFile, no_flipped_bit_passes_silently) {
  const TemporaryFolder folder;
  State s = make_state(500, 5);
  write_state(folder / "c.h5", s);
  const std::string whole = read_text(folder / "c.h5"), truth = all_bytes(s);
  std::mt19937_64 random(11);
  int refused = 0, tries = 400;
  testing::internal::CaptureStderr();
  for (int k = 0; k < tries; ++k) {
    std::string damaged = whole;
    const std::size_t at = k < 100 ? std::size_t(k) * 20 : random() % whole.size();
    damaged[at] = char(damaged[at] ^ (1 << (random() % 8)));
    std::ofstream(folder / "d.h5", std::ios::binary) << damaged;
    try {
      State read = read_state(folder / "d.h5");
      EXPECT_TRUE(all_bytes(read) == truth) << "byte " << at;
    } catch (const ResultsError& error) {
      ++refused;
      EXPECT_THAT(error.what(), HasSubstr("d.h5: the checkpoint"));
    }
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_GT(refused, tries / 2);
}

TEST(CheckpointFile, says_what_it_misses) {
  const TemporaryFolder folder;
  const auto file = folder / "c.h5";
  State s = make_state(100, 5);
  write_state(file, s);
  const CheckpointReader reader(file);
  EXPECT_TRUE(reader.has("particles/position"));
  EXPECT_FALSE(reader.has("nobody/position"));
  EXPECT_THAT(message_of<ResultsError>([&] { reader.get("hexes/position", s.position); }),
              AllOf(HasSubstr(file.string()), HasSubstr("no dataset 'hexes/position'")));
  EXPECT_THAT(message_of<ResultsError>([&] { reader.get("particles/gradient", s.position); }),
              HasSubstr("dataset 'particles/gradient' of shape 100 x 9, expected any x 3"));
  EXPECT_THAT(message_of<ResultsError>([&] { reader.get("particles/identity", s.position); }),
              HasSubstr("of shape 100, expected any x 3"));
  EXPECT_THAT(message_of<ResultsError>([&] { reader.get("particles/identity", s.host); }),
              HasSubstr("'particles/identity' of another type"));
  EXPECT_THAT(read_error(folder / "none.h5"), HasSubstr("there is no such checkpoint"));
  write_file(folder / "text.h5", "not HDF5 at all");
  EXPECT_THAT(read_error(folder / "text.h5"), HasSubstr("cut short or damaged"));
}

// Attributes of another size, count or kind would be read past the end of what takes them.
TEST(CheckpointFile, attributes_of_another_size_are_refused) {
  const TemporaryFolder folder;
  State s = make_state(100, 5);
  const auto spoil = [&](const char* name, hid_t type, hsize_t count) {
    write_state(folder / "c.h5", s);
    const hid_t file = H5Fopen((folder / "c.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t space = H5Screate_simple(1, &count, nullptr);
    H5Adelete(file, name);
    const hid_t attribute = H5Acreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    const std::vector<char> bytes(H5Tget_size(type) * count, 1);
    H5Awrite(attribute, type, bytes.data());
    H5Aclose(attribute), H5Sclose(space), H5Fclose(file);
    return read_error(folder / "c.h5");
  };
  const hid_t text = H5Tcopy(H5T_C_S1);
  H5Tset_size(text, 64);
  EXPECT_THAT(spoil("version", H5T_NATIVE_INT, 4096), HasSubstr("has format version -1"));
  EXPECT_THAT(spoil("version", H5T_NATIVE_DOUBLE, 1), HasSubstr("has format version -1"));
  EXPECT_THAT(spoil("format", text, 4096), HasSubstr("its header is damaged"));
  EXPECT_THAT(spoil("complete", text, 1), HasSubstr("was not written to its end"));
  H5Tclose(text);
}

TEST(CheckpointFile, rows_are_counted_before_they_are_read) {
  const TemporaryFolder folder;
  State s = make_state(100, 5);
  write_state(folder / "c.h5", s);
  const CheckpointReader reader(folder / "c.h5");
  EXPECT_THAT(message_of<ResultsError>([&] { reader.get("particles/position", s.position, 99); }),
              HasSubstr("of shape 100 x 3, expected 99 x 3"));
  EXPECT_THAT(message_of<ResultsError>([&] { reader.get("host", s.host, 3); }),
              HasSubstr("of shape 4, expected 3"));
  EXPECT_THAT(message_of<ResultsError>([&] { reader.require(false, "steps"); }),
              HasSubstr("has values of 'steps' that cannot be"));
}

TEST(CheckpointFile, full_disk_keeps_the_one_before) {
  const TemporaryFolder folder;
  const auto file = folder / "c.h5";
  State s = make_state(20000, 5);
  write_state(file, s);
  testing::internal::CaptureStderr();
  // A limit on the size of files stands for the full disk: write() fails in the middle.
  const auto old = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{200000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string message = message_of<ResultsError>([&] { write_state(file, s); });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_THAT(message, AllOf(HasSubstr(file.string()), HasSubstr("File too large"), HasSubstr("ulimit -f")));
  State read = read_state(file);
  EXPECT_TRUE(all_bytes(read) == all_bytes(s));
  EXPECT_THAT(message_of<ResultsError>([&] { write_state(folder / "no/c.h5", s); }),
              HasSubstr("No such file or directory"));
}
