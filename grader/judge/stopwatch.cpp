// stopwatch COMMAND... :: COMMAND...
//
// Asks two runners the same trajectories in turn and prints what a step costs each, measured
// here, outside of both: {"ns_per_step": [first, second], "ratio": first / second}.
// The ratio is what can be compared between machines. Exit status 3 when a runner ends.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

#include "runner_process.hpp"

namespace bounce::judge {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kSteps = 1000;
constexpr int kRounds = 15;

// Seconds for a trajectory of so many columns; the columns stay with the runner.
double ask(RunnerProcess& runner, int columns) {
  Parameters params;
  params.T = columns;
  frames::Frame question;
  question.part = 4;
  question.silent = 1;
  frames::put(params, question);
  frames::put(question, Vector3(0, 1.5, std::numbers::pi / 6), Vector3(0, -0.2, 0));
  const auto start = Clock::now();
  runner.send(question);
  if (runner.receive().kind != frames::Kind::answer) throw std::runtime_error("no trajectory");
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Nanoseconds a step of each runner: the rounds of the two alternate, so that what disturbs one
// disturbs the other; the round trip of a question, T = 1, is taken off.
std::vector<double> compare(std::vector<std::unique_ptr<RunnerProcess>>& runners) {
  std::vector<std::vector<double>> ns(runners.size());
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < runners.size(); ++i) {
      const double empty = ask(*runners[i], 1);
      const double whole = ask(*runners[i], kSteps + 1);
      ns[i].push_back(std::max(whole - empty, 1e-9) / kSteps * 1e9);
    }
  }
  std::vector<double> medians(ns.size());
  std::transform(ns.begin(), ns.end(), medians.begin(), median);
  return medians;
}

int run(const std::vector<std::string>& arguments) {
  const auto split = std::find(arguments.begin(), arguments.end(), "::");
  if (split == arguments.begin() || split >= arguments.end() - 1) {
    throw std::runtime_error("usage: stopwatch COMMAND... :: COMMAND...");
  }
  Limits limits;
  limits.cpu_seconds = 5;
  std::vector<std::unique_ptr<RunnerProcess>> runners;
  runners.push_back(
      std::make_unique<RunnerProcess>(std::vector<std::string>(arguments.begin(), split), limits));
  runners.push_back(std::make_unique<RunnerProcess>(
      std::vector<std::string>(split + 1, arguments.end()), limits));
  const std::vector<double> ns = compare(runners);
  std::cout << nlohmann::json{{"ns_per_step", ns}, {"ratio", ns[0] / ns[1]}} << std::endl;
  return 0;
}

}  // namespace
}  // namespace bounce::judge

int main(int argc, char** argv) try {
  std::signal(SIGPIPE, SIG_IGN);
  bounce::judge::stay_on_this_cpu();
  return bounce::judge::run({argv + 1, argv + argc});
} catch (const std::exception& e) {
  std::cerr << "stopwatch: " << e.what() << std::endl;
  return 3;
}
