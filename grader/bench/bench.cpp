// kit_bench RUNNER: times a question to a runner, the same call within this process, and the solver
// alone. RUNNER is a runner of the solution.
#include <benchmark/benchmark.h>

#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <csignal>
#include <iostream>

#include "../judge/runner_process.hpp"
#include "../runner/messages.hpp"

namespace bounce {
namespace {

// A sliding contact of the assignment's square.
const Vector3 kQ(0.5, 0.1255, 0.3);
const Vector3 kV(3.0, -1.0, 2.0);
const Parameters kParams;

void question(benchmark::State& state, const std::string& runner) {
  judge::Limits limits;
  limits.cpu_seconds = limits.wall_seconds = 60;
  judge::RunnerProcess process({runner}, limits);
  const frames::Frame frame = frames::question(3, kParams, kQ, kV);
  for ([[maybe_unused]] auto _ : state) {
    process.send(frame);
    benchmark::DoNotOptimize(process.receive());
  }
  state.SetItemsProcessed(state.iterations());
}

void step_linked(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(step(kQ, kV, kParams));
}

void lcp_alone(benchmark::State& state) {
  const Lcp lcp = form_lcp(get_contacts(kQ, kParams).J, kV, kParams);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(solve_lcp(lcp.V, lcp.p));
}

}  // namespace
}  // namespace bounce

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  bounce::judge::stay_on_this_cpu();
  benchmark::Initialize(&argc, argv);
  if (argc != 2) {
    std::cerr << "usage: kit_bench RUNNER\n";
    return 2;
  }
  const std::string runner = argv[1];
  benchmark::RegisterBenchmark("step, asked of a runner", [runner](benchmark::State& state) {
    bounce::question(state, runner);
  })->UseRealTime();
  benchmark::RegisterBenchmark("step, linked", bounce::step_linked);
  benchmark::RegisterBenchmark("solve_lcp, linked", bounce::lcp_alone);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
