// CPU time of several jobs, taken in turn: each round runs every job once, so that a temporary
// disturbance affects all of them. Medians over the rounds; two jobs are compared by the median of
// their ratios within a round.
#pragma once

#include <functional>
#include <vector>

namespace bounce::study {

// How much a question measures. The charts of ./kit study use the whole extent.
struct Extent {
  int rounds = 21;
  double least_ns = 1e6;  // a timing repeats its job for at least this long
  bool is_quick = false;
};
inline constexpr Extent kQuick{3, 1e5, true}, kBesidePeers{9};

// A job that takes longer than this runs in one round of kLongEvery.
inline constexpr double kLongNs = 5e7;
inline constexpr int kLongEvery = 4;

struct Job {
  std::function<double(long repeats)> time;  // of all repeats together, ns
  std::vector<double> ns{};                  // of one run, by round
};

// The whole of a function is timed.
Job job_of(const std::function<void()>& run);

// Fills `ns`. Each job is run once before it is timed.
void time_in_turn(std::vector<Job>& jobs, const Extent& extent);

// The value below which a share of the sorted values lies; 0.5 is the median.
double quantile(std::vector<double> values, double share = 0.5);

// For each round, how many times as long the job took as the other.
std::vector<double> ratios(const Job& job, const Job& other);

// CPU time of this process, ns.
double cpu_ns();

// Pins this process to its current core; returns -1 if the system doesn't allow it.
int pin_to_one_core();

}  // namespace bounce::study
