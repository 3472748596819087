// Checkpoints that chance has spoilt, with checksums that are right: refused by a message or taken, never
// more.
#include "src/output/write_hdf5.hpp"
#include "src/simulation/simulation.hpp"
#include "tests/support/chance.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/small_deck.hpp"
#include <hdf5.h>

using namespace swarf;
using namespace swarf::test;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> list_datasets(const fs::path& file) {
  std::vector<std::string> names;
  const hid_t open = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  H5Ovisit(
      open, H5_INDEX_NAME, H5_ITER_INC,
      [](hid_t, const char* name, const H5O_info_t* info, void* to) -> herr_t {
        if (info->type == H5O_TYPE_DATASET) static_cast<std::vector<std::string>*>(to)->push_back(name);
        return 0;
      },
      &names);
  H5Fclose(open);
  return names;
}

// The dataset gets another number of rows, or values that chance has made, with a checksum that is right.
void spoil_dataset(const fs::path& file, const std::string& name, Chance& chance) {
  const hid_t open = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT),
              old = H5Dopen2(open, name.c_str(), H5P_DEFAULT);
  const hid_t type = H5Dget_type(old), old_space = H5Dget_space(old);
  std::vector<hsize_t> extent(std::size_t(H5Sget_simple_extent_ndims(old_space)));
  H5Sget_simple_extent_dims(old_space, extent.data(), nullptr);
  H5Sclose(old_space), H5Dclose(old);
  const std::size_t kind = chance.below(4);
  if (kind == 0 && !extent.empty()) extent[0] += 1 + chance.below(1000);
  if (kind == 1 && !extent.empty() && extent[0] > 0) extent[0] -= 1;
  if (kind == 2) extent.push_back(2);
  hsize_t count = 1;
  for (const hsize_t n : extent) count *= n;
  std::vector<unsigned char> bytes(std::max<std::size_t>(1, std::size_t(count) * H5Tget_size(type)));
  for (unsigned char& byte : bytes) byte = static_cast<unsigned char>(chance.below(256));
  H5Ldelete(open, name.c_str(), H5P_DEFAULT);
  const hid_t space = H5Screate_simple(int(extent.size()), extent.data(), nullptr);
  const hid_t made = H5Dcreate2(open, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  if (count > 0) H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data());
  H5Dclose(made), H5Sclose(space), H5Tclose(type), H5Fclose(open);
}

} // namespace

// What counts or indexes is spoilt most often: anything else is a number of the state, whatever it is.
TEST(Mutations, of_checkpoints) {
  const TemporaryFolder folder;
  const std::string deck_file = write_deck(folder, small_deck);
  const Ended end = run_program(run_arguments(deck_file, folder / "r"));
  ASSERT_EQ(end.status, 0) << end.output;
  const Deck deck = read_deck(deck_file);
  std::vector<std::string> names = list_datasets(folder / "r/checkpoint.h5");
  for (const char* index :
       {"active", "active_tied", "listed", "particles/identity", "particles/body", "particles/material",
        "particles/constraints", "hexes/active", "hexes/material", "steps", "next_check", "tool_load",
        "lists/build_position", "heat_step", "heat_time"})
    names.insert(names.end(), 4, index);
  Chance chance(3);
  Tally tally;
  for (int k = 0; k < 120; ++k) {
    const fs::path file = folder / "spoilt.h5";
    fs::copy_file(folder / "r/checkpoint.h5", file, fs::copy_options::overwrite_existing);
    const std::string name = chance.of(names);
    spoil_dataset(file, name, chance);
    SCOPED_TRACE(name);
    tally.count<ResultsError>([&] { Simulation(deck).read_state(CheckpointReader(file)); });
  }
  EXPECT_GT(tally.refused, 60);
  EXPECT_GT(tally.taken, 5);
}
