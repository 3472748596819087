// What Kokkos is asked for: bytes of Views by their label, and launches by theirs.
#pragma once
#include <Kokkos_Core.hpp>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace swarf::bench {

struct Watch {
  using Bytes = std::map<std::string, long>;
  Bytes live, at_most; // now; when all Views together were largest
  long total = 0, most = 0;
  std::map<std::string, long> launches;

  static Watch& instance() {
    static Watch watch;
    return watch;
  }
  void begin() {
    namespace tools = Kokkos::Tools::Experimental;
    tools::set_allocate_data_callback([](Kokkos::Tools::SpaceHandle, const char* label, const void*,
                                         uint64_t size) { instance().change(label, long(size)); });
    tools::set_deallocate_data_callback([](Kokkos::Tools::SpaceHandle, const char* label, const void*,
                                           uint64_t size) { instance().change(label, -long(size)); });
    const auto launch = [](const char* label, uint32_t, uint64_t*) { ++instance().launches[label]; };
    tools::set_begin_parallel_for_callback(launch);
  }
  // From here on: what lives now, and the most of what is to come.
  void restart() { at_most = live, most = total, launches.clear(); }

 private:
  void change(const std::string& label, long bytes) {
    live[label] += bytes, total += bytes;
    if (total > most) at_most = live, most = total;
  }
};

// Of the process, in bytes: the most so far, and now.
inline double most_resident() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * double(usage.ru_maxrss);
}
inline double resident() {
  long size = 0, pages = 0;
  if (FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%ld %ld", &size, &pages) != 2) pages = 0;
    std::fclose(file);
  }
  return double(pages) * double(sysconf(_SC_PAGESIZE));
}

} // namespace swarf::bench
