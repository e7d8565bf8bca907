// stopwatch JSON
//
// JSON is {"scenes": folder, "timed": command, "solution": command}, where a command, a list of
// words, starts a runner. Measures, for each dt, the scenes that the
// assignment's model can simulate (speed_curves.hpp), with a submission's runner built for speed,
// the solution's runner, and the simulator that uses the least model for each step. Prints {"dt":
// [...], "scenes": [{"scene", "title", "seconds", "submission", "solution", "least"}], "cut"};
// a curve is a list of {"dt", "ns", "error"}, with ns of CPU time for a simulated
// second and an error in m, or null if it isn't finite. cut says where and why the submission's
// curves end early: {"dt", "sentence", "ended"}, with how its program ended (termination.hpp), if
// it did; else it is null.
//
// If a timed column is wrong, the times mean nothing, and only {"wrong": place} is printed.
//
// A runner is timed from outside, by the system's count of its CPU time, from the question to the
// last column of its answer, both included.
//
// Exit status 3 if the solution's runner ends, or if CPU time can't be measured.
#include <algorithm>
#include <bounce/part3_step.hpp>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <nlohmann/json.hpp>

#include "../../solution/exact/simulate_scene.hpp"
#include "../../solution/fixtures/decidable.hpp"
#include "../../tests/parts/cases.hpp"
#include "../../tests/parts/submission.hpp"
#include "../runner/messages.hpp"
#include "facts.hpp"
#include "session.hpp"
#include "speed_curves.hpp"

namespace bounce {

// The stopwatch reads no fixtures.
std::vector<std::filesystem::path> tests::fixture_folders() { return {}; }
void tests::about_to_ask(const Case&) {}
void tests::found_wrong(const Case&, const Problem&) {}
std::string tests::in_words(const Failure&) { return {}; }

namespace judge {
namespace {

using nlohmann::json;
using Command = std::vector<std::string>;

constexpr double kBudget = 2e9;  // ns of CPU time for all curves

// --- whether columns are right, each as the step from the one before: over a whole trajectory
// rounding errors grow too much for a comparison ---

constexpr double kTolerance = 1e-9;  // that of the fixtures
// What rounding decides may go either way within decidable.hpp's margin of 1e-6; the answers for
// starts so near differ by some hundred times that, or belong to another contact.
constexpr double kAside = 2e-6;
constexpr double kLoose = 2e-4;
// Columns of a trajectory that may come about in this way. A program that rounds otherwise has one
// now and then; more of them in a row would be a motion of its own.
constexpr int kMostAside = 3;

// As tests/parts/cases.cpp compares; NaN is never right.
bool is_near(const Vector3& expected, const Vector3& got, double tolerance) {
  return ((got - expected).array().abs() <= tolerance * expected.array().abs().max(1.0)).all();
}

bool are_same(const State& expected, const State& got, double tolerance = kTolerance) {
  return is_near(expected.q, got.q, tolerance) && is_near(expected.v, got.v, tolerance);
}

// Whether some start beside this one leads there: a little higher or lower, so that it touches or
// not, or turned a little, so that another corner is the lowest.
bool may_lead_to(const State& now, const State& from, const Parameters& params) {
  for (const double up : {0.0, kAside, -kAside}) {
    for (const double turn : {0.0, kAside, -kAside}) {
      const Vector3 aside = from.q + Vector3(0, up, turn / params.l);
      if (are_same(step(aside, from.v, params), now, kLoose)) return true;
    }
  }
  return false;
}

// The first column that isn't the solution's step from the column before, or for column 0 not
// `start`. Where rounding decides what happens in a step (decidable.hpp), a column is also right if
// it is the solution's step from a state that differs by as little.
std::optional<Eigen::Index> wrong_column(const Trajectory& trajectory, const State& start,
                                         const Parameters& params) {
  State before = start;
  int aside = 0;
  for (Eigen::Index column = 0; column < trajectory.q.cols(); ++column) {
    const State now{trajectory.q.col(column), trajectory.v.col(column)};
    const State expected = column == 0 ? start : step(before.q, before.v, params);
    if (!now.q.allFinite() || !now.v.allFinite()) return column;
    if (!are_same(expected, now)) {
      const bool may_be = column > 0 && !fixtures::mode_of_step(before.q, before.v, params) &&
                          may_lead_to(now, before, params) && ++aside <= kMostAside;
      if (!may_be) return column;
    }
    before = now;
  }
  return std::nullopt;
}

// --- the contenders ---

// A runner whose CPU time is measured.
class Timer {
 public:
  explicit Timer(const Command& command) : session_(command, limits(), 4, false) {}

  Timed run(const Parameters& params, const State& start) {
    if (!started_) {  // else the first question would include the program's start
      Parameters one = params;
      one.T = 1;
      ask(one, start);
      started_ = true;
    }
    return ask(params, start);
  }

 private:
  static Limits limits() {
    Limits limits;
    limits.cpu_seconds = 4;
    limits.wall_seconds = 20;
    return limits;
  }

  Timed ask(const Parameters& params, const State& start) {
    Timed answer;
    const double before = session_.cpu_ns();
    try {
      const frames::Frame shape =
          session_.ask(frames::question(4, params, start.q, start.v), &answer.trajectory);
      submission::require_columns(shape.q_columns, shape.v_columns, params.T);
    } catch (const tests::Ended&) {
      if (const auto end = session_.take_end()) throw *end;
      throw;
    }
    answer.ns = std::max(1.0, session_.cpu_ns() - before);
    return answer;
  }

  Session session_;
  bool started_ = false;
};

// Some column isn't a step of the solution's from the one before: the time of such answers says
// nothing.
struct Wrong {
  std::string place;
};

// Throws Wrong.
Timed run_submission(Timer& timed, const Parameters& params, const State& start) {
  Timed result = timed.run(params, start);
  if (const auto wrong = wrong_column(result.trajectory, start, params)) {
    char words[80];
    std::snprintf(words, sizeof words, "at dt = %.2g s, column %td of %d", params.dt, *wrong,
                  params.T);
    throw Wrong{words};
  }
  return result;
}

// CPU time of this thread. That of the process only advances in ticks if it has a limit.
double cpu_ns() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e9 + static_cast<double>(time.tv_nsec);
}

Timed run_least_model(const Parameters& params, const State& start) {
  const double before = cpu_ns();
  Trajectory trajectory = exact::simulate_scene(params, start);
  return {std::move(trajectory), std::max(1.0, cpu_ns() - before)};
}

// --- the answer ---

json as_json(const Cut& cut) {
  return {
      {"dt", cut.dt}, {"sentence", cut.sentence}, {"ended", cut.end ? facts(*cut.end) : json()}};
}

json as_json(const std::vector<Point>& points) {
  json list = json::array();
  for (const Point& point : points) {
    list.push_back({{"dt", point.dt},
                    {"ns", std::round(point.ns_per_second)},
                    {"error", std::isfinite(point.error) ? json(point.error) : json(nullptr)}});
  }
  return list;
}

// Those that need at most one corner with friction: the assignment's model has no two corners at
// once, as in a square that rests on a face.
std::vector<exact::Scene> scenes_of_one_corner(const std::string& folder) {
  std::vector<exact::Scene> scenes;
  for (const exact::Scene& scene : exact::read_scenes(folder)) {
    const bool asleep = scene.least == exact::ModelLevel::asleep;
    if (!asleep && scene.least <= exact::ModelLevel::one_friction) scenes.push_back(scene);
  }
  return scenes;
}

json measured(const json& asked) {
  const std::vector<exact::Scene> scenes = scenes_of_one_corner(asked.at("scenes"));
  const auto command = [&](const char* name) { return asked.at(name).get<Command>(); };
  Timer timed(command("timed")), solution(command("solution"));
  const auto run = [&](const Parameters& params, const State& start) {
    return run_submission(timed, params, start);
  };
  const auto run_solution = [&](const Parameters& params, const State& start) {
    return solution.run(params, start);
  };
  const auto curves = speed_curves(scenes, {run, run_solution, run_least_model}, kBudget);
  if (const auto& cut = curves[1].cut) {
    throw std::runtime_error("the solution: " + cut->sentence + (cut->end ? cut->end->what : ""));
  }
  const auto& cut = curves[0].cut;
  json answer = {{"dt", kMeasuredSteps}, {"scenes", json::array()}};
  answer["cut"] = cut ? as_json(*cut) : json();
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    answer["scenes"].push_back({{"scene", scenes[i].name},
                                {"title", scenes[i].title},
                                {"seconds", scenes[i].until},
                                {"submission", as_json(curves[0].points[i])},
                                {"solution", as_json(curves[1].points[i])},
                                {"least", as_json(curves[2].points[i])}});
  }
  return answer;
}

json answer_to(const json& asked) try { return measured(asked); } catch (const Wrong& wrong) {
  return {{"wrong", wrong.place}};
}

}  // namespace
}  // namespace judge
}  // namespace bounce

int main(int argc, char** argv) try {
  std::signal(SIGPIPE, SIG_IGN);
  bounce::judge::stay_on_this_cpu();
  if (argc != 2) throw std::runtime_error("usage: stopwatch JSON, as in its stopwatch.cpp");
  const auto answer = bounce::judge::answer_to(nlohmann::json::parse(argv[1]));
  std::cout << answer.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
  return std::cout ? 0 : 3;
} catch (const std::exception& e) {
  std::cerr << "stopwatch: " << e.what() << std::endl;
  return 3;
}
