// What a test prints as bits, by this program run anew: the number of threads is fixed at a program's start.
#pragma once
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>

namespace swarf::test {

// The line "bits ..." of one test. A program that runs a shard of its tests must not run a shard of this one.
inline std::string bits_with_threads(const std::string& test, int threads) {
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string command =
      "env -u GTEST_TOTAL_SHARDS -u GTEST_SHARD_INDEX OMP_NUM_THREADS=" + std::to_string(threads) + " '" +
      self + "' --gtest_filter=" + test;
  FILE* pipe = popen(command.c_str(), "r");
  std::string bits;
  char line[4096];
  while (pipe && std::fgets(line, sizeof line, pipe))
    if (std::strncmp(line, "bits ", 5) == 0) bits = line;
  if (pipe) pclose(pipe);
  return bits;
}

} // namespace swarf::test
