#include "src/output/write_hdf5.hpp"

#include "src/output/hdf5_handle.hpp"
#include "src/output/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace swarf {
namespace fs = std::filesystem;
namespace {

constexpr const char* format_name = "swarf checkpoint";

hid_t memory_type(NumberType type) {
  switch (type) {
  case NumberType::float32:
    return H5T_NATIVE_FLOAT;
  case NumberType::float64:
    return H5T_NATIVE_DOUBLE;
  case NumberType::int32:
    return H5T_NATIVE_INT32;
  case NumberType::uint32:
    return H5T_NATIVE_UINT32;
  case NumberType::int64:
    return H5T_NATIVE_INT64;
  case NumberType::uint64:
    return H5T_NATIVE_UINT64;
  }
  return -1;
}

std::string describe(const Extents& shape, std::uint64_t any) {
  std::string text;
  for (const auto n : shape)
    text += (text.empty() ? "" : " x ") + (n == any ? std::string("any") : fmt::format("{}", n));
  return text.empty() ? "a number" : text;
}

// Chunks of about 1 MiB, each with its checksum. Empty arrays have no chunk.
Hdf5Handle checksummed_layout(const Extents& shape, std::size_t bytes_per_number) {
  Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation, false);
  std::uint64_t total = 1;
  for (const auto n : shape) total *= n;
  if (total == 0 || shape.empty()) return creation;
  const std::uint64_t row = std::max<std::uint64_t>(1, total / shape[0] * bytes_per_number);
  std::vector<hsize_t> chunk(shape.begin(), shape.end());
  chunk[0] = std::clamp<hsize_t>((1 << 20) / row, 1, shape[0]);
  H5Pset_chunk(creation, int(chunk.size()), chunk.data());
  H5Pset_fletcher32(creation);
  return creation;
}

// One column of the history: extendible, so that other programs may append.
bool write_column(hid_t file, const std::string& name, const std::string& unit,
                  const std::vector<double>& values) {
  const hsize_t rows = values.size(), limit = H5S_UNLIMITED, chunk = 4096;
  const Hdf5Handle space(H5Screate_simple(1, &rows, &limit), H5Sclose);
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation, false);
  H5Pset_chunk(creation, 1, &chunk);
  H5Pset_shuffle(creation);
  H5Pset_deflate(creation, 4);
  const Hdf5Handle dataset(
      H5Dcreate2(file, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose);
  if (!dataset.ok()) return false;
  if (rows > 0 && H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    return false;
  return write_attribute(dataset, "units", unit);
}

} // namespace

void write_history_hdf5(const fs::path& name, const HistoryTable& raw, const HistoryTable& filtered) {
  silence_hdf5();
  const fs::path temporary = temporary_name(name);
  bool good = false;
  {
    Hdf5Handle file = create_hdf5(temporary);
    good = file.ok() && create_groups(file, "history/x");
    for (std::size_t c = 0; good && c < raw.columns.size(); ++c)
      good = write_column(file, "history/" + raw.columns[c].name, raw.columns[c].unit, raw.values[c]);
    for (std::size_t c = 0; good && c < filtered.columns.size(); ++c) {
      const auto& [column, unit] = filtered.columns[c];
      if (column == "time" || column == "immersion") continue;
      good = write_column(file, "history/" + column + "_filtered", unit, filtered.values[c]);
    }
    good = good && H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0;
  }
  if (!good)
    throw ResultsError(
        fmt::format("{}: cannot write the history: {}; free some space on that disk, or choose another "
                    "folder with --output",
                    name.string(), hdf5_system_error()));
  commit_file(name);
}

bool Hdf5File::close() {
  const hid_t open = std::exchange(id, -1);
  return open < 0 || H5Fclose(open) >= 0;
}

CheckpointWriter::CheckpointWriter(const fs::path& name, const std::string& deck) : name_of_file(name) {
  silence_hdf5();
  file.id = create_hdf5(temporary_name(name)).release();
  if (file.id < 0) fail("cannot be written");
  if (!write_attribute(file.id, "format", format_name) ||
      !write_attribute(file.id, "version", checkpoint_version) ||
      !write_attribute(file.id, "bytes_of_real", int(sizeof(Real))) ||
      !write_attribute(file.id, "deck", deck))
    fail("cannot be written");
}

CheckpointWriter::~CheckpointWriter() {
  if (file.id < 0) return;
  file.close();
  std::error_code ignored;
  fs::remove(temporary_name(name_of_file), ignored);
}

void CheckpointWriter::fail(const std::string& what) {
  const std::string reason = hdf5_system_error();
  file.close();
  std::error_code ignored;
  fs::remove(temporary_name(name_of_file), ignored);
  const bool is_limit = reason == std::strerror(EFBIG);
  throw ResultsError(fmt::format("{}: the checkpoint {}{}{}; {}. The checkpoint before this one is as it was",
                                 name_of_file.string(), what, reason.empty() ? "" : ": ", reason,
                                 advice_on(is_limit ? EFBIG : ENOSPC)));
}

void CheckpointWriter::write(const std::string& name, const void* data, NumberType type,
                             const Extents& shape) {
  const std::vector<hsize_t> extent(shape.begin(), shape.end());
  const Hdf5Handle space(H5Screate_simple(int(extent.size()), extent.data(), nullptr), H5Sclose);
  const hid_t number = memory_type(type);
  const Hdf5Handle layout = checksummed_layout(shape, H5Tget_size(number));
  if (!create_groups(file.id, name)) fail(fmt::format("cannot hold the dataset '{}'", name));
  const Hdf5Handle dataset(H5Dcreate2(file.id, name.c_str(), number, space, H5P_DEFAULT, layout, H5P_DEFAULT),
                           H5Dclose);
  if (!dataset.ok()) fail(fmt::format("cannot hold the dataset '{}'", name));
  if (H5Sget_simple_extent_npoints(space) > 0 &&
      H5Dwrite(dataset, number, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0)
    fail(fmt::format("cannot hold the dataset '{}'", name));
}

void CheckpointWriter::finish() {
  if (!write_attribute(file.id, "complete", 1) || H5Fflush(file.id, H5F_SCOPE_GLOBAL) < 0)
    fail("cannot be completed");
  if (!file.close()) fail("cannot be completed");
  commit_file(name_of_file);
}

CheckpointReader::CheckpointReader(const fs::path& name) : name_of_file(name) {
  silence_hdf5();
  std::error_code ignored;
  if (!fs::exists(name, ignored))
    throw ResultsError(
        fmt::format("{}: there is no such checkpoint; give the folder of a run that wrote one, or start "
                    "the run anew with --overwrite",
                    name.string()));
  file.id = H5Fopen(name.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (file.id < 0) fail("is cut short or damaged: HDF5 cannot open it");
  if (read_text_attribute(file.id, "format") != format_name)
    fail("is not a checkpoint of swarf, or its header is damaged");
  const int version = read_int_attribute(file.id, "version"),
            bytes = read_int_attribute(file.id, "bytes_of_real");
  if (version != checkpoint_version)
    fail(fmt::format("has format version {}, expected {}: another version of swarf wrote it", version,
                     checkpoint_version));
  if (bytes != int(sizeof(Real)))
    fail(fmt::format(
        "holds numbers of {} bytes, this build of swarf computes with {} ({})", bytes, sizeof(Real),
        sizeof(Real) == 8 ? "double; use the build in single precision" : "float; use the release build"));
  if (read_int_attribute(file.id, "complete") != 1) fail("was not written to its end");
  deck_text = read_text_attribute(file.id, "deck");
}

void CheckpointReader::fail(const std::string& what) const {
  throw ResultsError(fmt::format(
      "{}: the checkpoint {}; restart from another checkpoint, or start the run anew with --overwrite",
      name_of_file.string(), what));
}

void CheckpointReader::require(bool is_possible, const std::string& name) const {
  if (!is_possible) fail(fmt::format("has values of '{}' that cannot be", name));
}

bool CheckpointReader::has(const std::string& name) const {
  for (auto slash = name.find('/', 1); slash != name.npos; slash = name.find('/', slash + 1))
    if (H5Lexists(file.id, name.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) return false;
  return H5Lexists(file.id, name.c_str(), H5P_DEFAULT) > 0;
}

Extents CheckpointReader::shape(const std::string& name) const {
  if (!has(name)) fail(fmt::format("has no dataset '{}'", name));
  const Hdf5Handle dataset(H5Dopen2(file.id, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset.ok()) fail(fmt::format("is damaged: dataset '{}' cannot be opened", name));
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  std::vector<hsize_t> extent(std::size_t(std::max(0, H5Sget_simple_extent_ndims(space))));
  H5Sget_simple_extent_dims(space, extent.data(), nullptr);
  return {extent.begin(), extent.end()};
}

Extents CheckpointReader::check(const std::string& name, NumberType type, const Extents& expected) const {
  const Extents found = shape(name);
  bool fits = found.size() == expected.size();
  for (std::size_t r = 0; fits && r < found.size(); ++r) fits = expected[r] == any || expected[r] == found[r];
  if (!fits)
    fail(fmt::format("has dataset '{}' of shape {}, expected {}", name, describe(found, any),
                     describe(expected, any)));
  const Hdf5Handle dataset(H5Dopen2(file.id, name.c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Handle stored(H5Dget_type(dataset), H5Tclose);
  if (H5Tequal(stored, memory_type(type)) <= 0)
    fail(fmt::format("has dataset '{}' of another type of number than expected", name));
  return found;
}

void CheckpointReader::read(const std::string& name, void* data, NumberType type) const {
  const Hdf5Handle dataset(H5Dopen2(file.id, name.c_str(), H5P_DEFAULT), H5Dclose);
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  if (H5Sget_simple_extent_npoints(space) == 0) return;
  if (H5Dread(dataset, memory_type(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0)
    fail(fmt::format("is damaged: the checksum of dataset '{}' is wrong", name));
}

} // namespace swarf
