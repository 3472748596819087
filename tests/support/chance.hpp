// Chance that is the same in every run and on every machine, and a count of what came of it.
#pragma once
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

namespace swarf::test {

class Chance {
 public:
  explicit Chance(unsigned seed) : random(seed) {}
  std::size_t below(std::size_t count) { return random() % count; } // the same on every machine
  template <class T>
  const T& of(const std::vector<T>& all) {
    return all[below(all.size())];
  }

 private:
  std::mt19937 random;
};

struct Tally {
  int refused = 0, taken = 0;
  template <class Error, class Work>
  void count(const Work& work) {
    try {
      work();
      ++taken;
    } catch (const Error& error) {
      ++refused;
      EXPECT_GT(std::string(error.what()).size(), 20u) << "a message says what to do";
    }
  }
};

} // namespace swarf::test
