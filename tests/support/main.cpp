#include <Kokkos_Core.hpp>

#include <gtest/gtest.h>

#include <cstdlib>

// One Kokkos for all tests of a program. Two threads, enough for a race, unless the environment says
// otherwise.
int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  if (::testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS(); // quick: no threads are started

  Kokkos::InitializationSettings settings;
  settings.set_disable_warnings(true);
  if (!std::getenv("OMP_NUM_THREADS")) settings.set_num_threads(2);
  const Kokkos::ScopeGuard kokkos(settings);
  return RUN_ALL_TESTS();
}
