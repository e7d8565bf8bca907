#include "timing.hpp"

#include <sched.h>

#include <algorithm>
#include <cmath>

#include "catalog.hpp"

namespace bounce::study {
namespace {

double time_once(const Job& job) {
  const double start = cpu_ns();
  for (long i = 0; i < job.repeats; ++i) job.run();
  return (cpu_ns() - start) / double(job.repeats);
}

}  // namespace

void time_in_turn(std::vector<Job>& jobs, const Extent& extent) {
  for (Job& job : jobs) {
    job.repeats = 1;
    time_once(job);
    job.repeats = std::max(1L, std::lround(extent.least_ns / std::max(time_once(job), 20.0)));
  }
  for (int round = 0; round < extent.rounds; ++round)
    for (Job& job : jobs) job.ns.push_back(time_once(job));
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[std::size_t(std::lround(share * double(values.size() - 1)))];
}

std::vector<double> ratios(const Job& job, const Job& other) {
  std::vector<double> all;
  for (std::size_t i = 0; i < job.ns.size(); ++i) all.push_back(job.ns[i] / other.ns[i]);
  return all;
}

int pin_to_one_core() {
  const int core = sched_getcpu();
  if (core < 0) return -1;
  cpu_set_t cores;
  CPU_ZERO(&cores);
  CPU_SET(std::size_t(core), &cores);
  return sched_setaffinity(0, sizeof cores, &cores) == 0 ? core : -1;
}

}  // namespace bounce::study
