#include "timing.hpp"

#include <sched.h>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace bounce::study {
namespace {

struct Turn {
  long repeats;
  int every;
};

Turn turn_of(const Job& job, const Extent& extent) {
  double once = job.time(1);
  if (once < kLongNs) once = std::max(job.time(1), 20.0);  // the first found caches cold
  return {std::max(1L, std::lround(extent.least_ns / once)), once > kLongNs ? kLongEvery : 1};
}

}  // namespace

double cpu_ns() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) * 1e9 + double(time.tv_nsec);
}

Job job_of(const std::function<void()>& run) {
  return {[run](long repeats) {
    const double start = cpu_ns();
    for (long i = 0; i < repeats; ++i) run();
    return cpu_ns() - start;
  }};
}

void time_in_turn(std::vector<Job>& jobs, const Extent& extent) {
  std::vector<Turn> turns;
  turns.reserve(jobs.size());
  for (const Job& job : jobs) turns.push_back(turn_of(job, extent));
  for (int round = 0; round < extent.rounds; ++round) {
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      const auto [repeats, every] = turns[i];
      if (round % every == 0) jobs[i].ns.push_back(jobs[i].time(repeats) / double(repeats));
    }
  }
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
