// One process writes to a results folder at a time.
#pragma once
#include <filesystem>
#include <string>

namespace swarf {

// Holds the folder, which it makes if it is missing, until it is destroyed. The lock is the process's own
// (flock), so a killed run leaves none, and swarf.lock in the folder says who holds it. Throws ResultsError
// that names the holder, or says why the folder cannot be written.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::filesystem::path file;
  int descriptor = -1;
};

} // namespace swarf
