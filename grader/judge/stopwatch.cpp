// stopwatch JSON
//
// Measures speed against accuracy. A submission's runner built for speed, the solution's runner and
// the simulator that uses the least model for each step take turns, with smaller and smaller steps,
// in the scenes that the assignment's model can simulate. JSON is {"scenes": folder, "timed":
// command, "solution": command}; a command, a list of words, starts a runner. Prints {"dt": [...],
// "scenes": [{"scene", "title", "seconds", "submission", "solution", "least"}], "cut"}; a curve is
// a list of {"dt", "ns", "error"}, with ns of CPU time for a simulated second and an error in m, or
// null if it isn't finite. cut says where and why the submission's curves end early: {"dt",
// "sentence", "ended"}, with how its program ended (termination.hpp), if it did; else it is null.
//
// The error is that of the first round, which starts as the scene does. The time is the least of
// the other rounds', whose initial velocities are changed at random by about a thousandth, so that
// answers which were kept or computed beforehand are wrong there. If a timed column is wrong, the
// times mean nothing, and only {"wrong": place} is printed.
//
// A runner is timed from outside, by the system's count of its CPU time, from the question to the
// last column of its answer, both included.
//
// Exit status 3 if the solution's runner ends, or if CPU time can't be measured.
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>

#include "../../solution/exact/simulate_scene.hpp"
#include "../../solution/exact/truth.hpp"
#include "../../tests/parts/checks.hpp"
#include "../../tests/parts/submission.hpp"
#include "../runner/messages.hpp"
#include "right_columns.hpp"
#include "session.hpp"

namespace bounce::judge {
namespace {

using nlohmann::json;

const std::vector<double> kSteps{1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5};  // s
constexpr double kBudget = 2e9;  // ns of CPU time for all curves of a program
// delta over dt, m/s: the assignment's 0.001 m for 0.01 s. With a fixed delta, the error of any
// correct program stops falling at some multiple of delta, which says nothing about the program.
constexpr double kDeltaSpeed = 0.1;
constexpr double kNudge = 1e-3;  // m/s and rad/s: a thousandth of typical velocities
constexpr int kFewest = 2, kMost = 5;
constexpr long kStepsInAll = 25'000;  // of all rounds of a point, roughly

// --- programs ---

struct Timed {
  Trajectory trajectory = {};
  double ns = 0;  // of CPU time
};

// A runner whose CPU time is measured. Throws Termination where it ends.
class Timer {
 public:
  explicit Timer(const std::vector<std::string>& command)
      : session_(command, Limits{.cpu_seconds = 4, .busy_wall_seconds = 20}, 4, false) {}

  Timed run(Parameters params, const State& start) {
    if (session_.cpu_ns() == 0) {  // else the first question would include the program's start
      const int T = std::exchange(params.T, 1);
      ask(params, start);
      params.T = T;
    }
    return ask(params, start);
  }

 private:
  Timed ask(const Parameters& params, const State& start) {
    Timed answer;
    const double before = session_.cpu_ns();
    try {
      const frames::Frame shape =
          session_.ask(frames::question(4, params, start.q, start.v), &answer.trajectory);
      submission::require_columns(shape.q_columns, shape.v_columns, params.T);
    } catch (const tests::Ended& ended) {
      if (const auto end = session_.take_end()) throw *end;
      throw std::runtime_error(ended.why);
    }
    answer.ns = std::max(1.0, session_.cpu_ns() - before);
    return answer;
  }

  Session session_;
};

// CPU time of this thread. That of the process only advances in ticks if it has a limit.
double cpu_ns() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e9 + static_cast<double>(time.tv_nsec);
}

Timed run_least_model(const Parameters& params, const State& start) {
  const double before = cpu_ns();
  Trajectory trajectory = study::simulate_scene(params, start);
  return {std::move(trajectory), std::max(1.0, cpu_ns() - before)};
}

// --- rounds ---

// A scene at one dt.
struct Setting {
  const study::Scene& scene;
  const study::Motions& truth;
  Parameters params = scene.params;
  long between = 0;  // steps, from one sample to the next

  Setting(const study::Scene& of, const study::Motions& its_truth, double dt)
      : scene(of), truth(its_truth) {
    params.dt = study::fitting_step(scene, dt);
    params.delta = kDeltaSpeed * params.dt;
    between = std::lround(scene.until / study::kSamples / params.dt);
    params.T = static_cast<int>(study::kSamples * between) + 1;
  }

  // The largest distance to the truth over the samples, m.
  double error_of(const Trajectory& trajectory) const {
    study::Motions samples;
    for (int i = 1; i <= study::kSamples; ++i) {
      const State state{trajectory.q.col(i * between), trajectory.v.col(i * between)};
      samples.push_back(study::motion_of<double>(state));
    }
    return study::error_of(scene, samples, truth);
  }
};

// The scene's start with random changes to the velocities.
State nudged(State start) {
  static std::random_device random;
  std::uniform_real_distribution<double> change(-kNudge, kNudge);
  for (double& x : start.v) x += change(random);
  return start;
}

// A program that takes turns, and what it has reached.
struct Contender {
  const char* name;
  std::function<Timed(const Parameters& params, const State& start)> run;
  json cut = nullptr;  // where and why its curves end early
  double left_ns = kBudget;
  double ns = 0, error = 0;  // of the rounds at the present setting

  // The first round is the scene itself, which could be known by heart. Of the others' times the
  // least counts, because disturbances only add time.
  void take_turn(const Setting& setting, const State& start, int round) {
    const auto end = [&](const std::string& why, const json& ended) {
      cut = {{"dt", setting.params.dt}, {"sentence", why}, {"ended", ended}};
    };
    if (cut.is_null() && left_ns < 0) {
      end("it takes more CPU time than there is for all of this", nullptr);
    }
    if (!cut.is_null()) return;
    try {
      const Timed timed = run(setting.params, start);
      if (round == 0) error = setting.error_of(timed.trajectory);
      ns = round <= 1 ? timed.ns : std::min(ns, timed.ns);
      left_ns -= timed.ns;
    } catch (const Termination& ended) {
      end("", facts_of(ended));
    } catch (const std::runtime_error& failed) {
      end(failed.what(), nullptr);
    }
  }

  void add_point(const Setting& setting, json& curve) const {
    if (!cut.is_null()) return;
    curve.push_back({{"dt", setting.params.dt},
                     {"ns", std::round(ns / setting.scene.until)},
                     {"error", std::isfinite(error) ? json(error) : json()}});
  }
};

// Adds a point to each one's curve in a scene.
void measure(std::vector<Contender>& contenders, const Setting& setting, json& curves) {
  const auto rounds = std::clamp<long>(kStepsInAll / setting.params.T, kFewest, kMost);
  for (int round = 0; round < rounds; ++round) {
    const State start = round == 0 ? setting.scene.start : nudged(setting.scene.start);
    for (Contender& one : contenders) one.take_turn(setting, start, round);
  }
  for (const Contender& one : contenders) one.add_point(setting, curves[one.name]);
}

json measured(const json& asked) try {
  Timer timed(asked.at("timed")), solution(asked.at("solution"));
  const auto run_right = [&](const Parameters& params, const State& start) {
    Timed result = timed.run(params, start);
    const auto wrong = wrong_column(result.trajectory, start, params);
    if (!wrong) return result;
    char words[80];
    std::snprintf(words, sizeof words, "at dt = %.2g s, column %td of %d", params.dt, *wrong,
                  params.T);
    throw json::object({{"wrong", words}});  // in place of all times
  };
  std::vector<Contender> contenders{{"submission", run_right},
                                    {"solution", std::bind_front(&Timer::run, &solution)},
                                    {"least", run_least_model}};
  std::vector<study::Scene> scenes = study::read_scenes(asked.at("scenes").get<std::string>());
  // The assignment's model has no two corners at once, as in a square that rests on a face; after a
  // second of impacts any step's error has grown beyond use.
  using enum study::ModelLevel;
  std::erase_if(scenes, [](const study::Scene& s) {
    return s.least == asleep || s.least > one_friction || s.until > 1;
  });
  std::vector<study::Motions> truths;
  json all = json::array();
  for (const study::Scene& scene : scenes) {
    truths.push_back(study::truth_of(scene));
    all.push_back({{"scene", scene.name}, {"title", scene.title}, {"seconds", scene.until}});
    for (const Contender& one : contenders) all.back()[one.name] = json::array();
  }
  for (const double dt : kSteps) {
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      measure(contenders, Setting(scenes[i], truths[i], dt), all[i]);
    }
  }
  const json& cut = contenders[1].cut;
  if (!cut.is_null()) throw std::runtime_error("the solution was cut: " + cut.dump());
  return {{"dt", kSteps}, {"scenes", all}, {"cut", contenders[0].cut}};
} catch (const json& wrong) {
  return wrong;
}

}  // namespace
}  // namespace bounce::judge

int main(int argc, char** argv) try {
  std::signal(SIGPIPE, SIG_IGN);
  bounce::judge::stay_on_this_cpu();
  if (argc != 2) throw std::runtime_error("usage: stopwatch JSON, as in its stopwatch.cpp");
  const auto answer = bounce::judge::measured(nlohmann::json::parse(argv[1]));
  std::cout << answer.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
  return std::cout ? 0 : 3;
} catch (const std::exception& e) {
  std::cerr << "stopwatch: " << e.what() << std::endl;
  return 3;
}
