#include "bench/support/bench.hpp"

// One Kokkos for all benchmarks of a program; threads by OMP_NUM_THREADS.
int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  Kokkos::InitializationSettings settings;
  settings.set_disable_warnings(true);
  const Kokkos::ScopeGuard kokkos(settings);
  benchmark::AddCustomContext("threads", std::to_string(Kokkos::num_threads()));
  benchmark::AddCustomContext("real_bytes", std::to_string(sizeof(swarf::Real)));
  benchmark::AddCustomContext("pack_width", std::to_string(swarf::pack_width));
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
