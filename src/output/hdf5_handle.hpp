// HDF5 objects that close themselves. Only for the .cpp files that talk to HDF5.
#pragma once
#include <hdf5.h>

#include <cstring>
#include <string>
#include <utility>

namespace swarf {

class Hdf5Handle {
 public:
  Hdf5Handle(hid_t object, herr_t (*closer)(hid_t)) : id(object), close(closer) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id(std::exchange(other.id, -1)), close(other.close) {}
  Hdf5Handle& operator=(Hdf5Handle&&) = delete;
  ~Hdf5Handle() {
    if (id >= 0) close(id);
  }
  operator hid_t() const { return id; }
  bool ok() const { return id >= 0; }
  hid_t release() { return std::exchange(id, -1); }

 private:
  hid_t id;
  herr_t (*close)(hid_t);
};

// What the system said in the last failed call ("No space left on device"), or "".
inline std::string& hdf5_system_error() {
  static thread_local std::string text;
  return text;
}

// HDF5 prints nothing: the reason is kept for our messages.
inline void silence_hdf5() {
  // At exit HDF5 would try again to write what a full disk refused, and complain. We close our files
  // ourselves.
  static const herr_t no_exit_handler = H5dont_atexit();
  static_cast<void>(no_exit_handler);
  hdf5_system_error().clear();
  const auto take = [](unsigned, const H5E_error2_t* error, void*) -> herr_t {
    const std::string text = error->desc ? error->desc : "";
    const auto start = text.find("error message = '");
    if (start == text.npos) return 0;
    const auto from = start + 17;
    hdf5_system_error() = text.substr(from, text.find('\'', from) - from);
    return 0;
  };
  static constexpr H5E_walk2_t take_function = take;
  H5Eset_auto2(
      H5E_DEFAULT,
      [](hid_t stack, void*) -> herr_t { return H5Ewalk2(stack, H5E_WALK_DOWNWARD, take_function, nullptr); },
      nullptr);
}

// A new file without time stamps, whose structure carries checksums.
inline Hdf5Handle create_hdf5(const std::string& name) {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose),
      creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST);
  H5Pset_obj_track_times(creation, false);
  return {H5Fcreate(name.c_str(), H5F_ACC_TRUNC, creation, access), H5Fclose};
}

// Makes the groups of "a/b/name" that are not there yet.
inline bool create_groups(hid_t file, const std::string& name) {
  const Hdf5Handle creation(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation, false);
  for (auto slash = name.find('/', 1); slash != name.npos; slash = name.find('/', slash + 1)) {
    const std::string group = name.substr(0, slash);
    if (H5Lexists(file, group.c_str(), H5P_DEFAULT) > 0) continue;
    const Hdf5Handle made(H5Gcreate2(file, group.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT), H5Gclose);
    if (!made.ok()) return false;
  }
  return true;
}

inline bool write_attribute(hid_t object, const char* name, const std::string& text) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
  H5Tset_size(type, text.size() + 1);
  const Hdf5Handle attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.ok() && H5Awrite(attribute, type, text.c_str()) >= 0;
}
inline bool write_attribute(hid_t object, const char* name, int value) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(H5Acreate2(object, name, H5T_STD_I32LE, space, H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose);
  return attribute.ok() && H5Awrite(attribute, H5T_NATIVE_INT, &value) >= 0;
}

// One value and no more: others would be read past the end of ours.
inline bool is_single(hid_t attribute) {
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
  return space.ok() && H5Sget_simple_extent_npoints(space) == 1;
}

// "" and -1 stand for: not there, or not of this kind.
inline std::string read_text_attribute(hid_t object, const char* name) {
  const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  if (!attribute.ok() || !is_single(attribute)) return "";
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
  if (!type.ok() || H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0) return "";
  std::string text(H5Tget_size(type), '\0');
  if (H5Aread(attribute, type, text.data()) < 0) return "";
  return std::string(text.c_str(), strnlen(text.data(), text.size()));
}
inline int read_int_attribute(hid_t object, const char* name) {
  const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  if (!attribute.ok() || !is_single(attribute)) return -1;
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
  int value = -1;
  if (!type.ok() || H5Tget_class(type) != H5T_INTEGER || H5Aread(attribute, H5T_NATIVE_INT, &value) < 0)
    return -1;
  return value;
}

} // namespace swarf
