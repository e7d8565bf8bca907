// stopwatch --scenes FOLDER COMMAND... :: COMMAND...
//
// Sweeps dt over the scenes that the assignment's model can do (sweep.hpp), in a submission's
// runner, the solution's runner, and the simulator that takes no more model than a step needs.
// Prints {"dt": [...], "scenes": [{"scene", "title", "seconds", "submission", "solution",
// "least"}], "cut": sentence or ""}; a curve is a list of {"dt", "ns", "error"}, with ns of CPU
// time for a simulated second and an error in m, or null where it isn't finite.
//
// A runner is timed from outside, by the system's count of its CPU time, from the question to the
// last column of its answer. What asking and handing over takes is measured with the solution's
// runner, whose code is known, and taken off both.
//
// Exit status 3 when the solution's runner ends, or CPU time can't be told.
#include <algorithm>
#include <cmath>
#include <csignal>
#include <ctime>
#include <iostream>
#include <nlohmann/json.hpp>

#include "../../solution/study/simulate_scene.hpp"
#include "../../tests/cases.hpp"
#include "../../tests/submission.hpp"
#include "session.hpp"
#include "sweep.hpp"

namespace bounce {

// It reads no fixtures.
std::vector<std::filesystem::path> tests::fixture_folders() { return {}; }
void tests::about_to_ask(const Case&) {}
std::string tests::in_words(const Case&, const Problem&) { return {}; }

namespace judge {
namespace {

using nlohmann::json;

constexpr double kBudget = 1.5e9;  // ns of CPU time for a whole sweep
constexpr int kManyColumns = 20'001;

// What a question costs that isn't the trajectory: ns, and ns a column.
struct Handover {
  double question = 0, column = 0;
};

class InRunner : public Contender {
 public:
  explicit InRunner(const std::vector<std::string>& command)
      : session_(command, limits(), 4, false) {}

  void take_off(const Handover& handover) { handover_ = handover; }

  Timed run(const Parameters& params, const State& start) override {
    Trajectory trajectory;
    if (!started_) {
      Parameters one = params;
      one.T = 1;
      ask(one, start, &trajectory);
      started_ = true;
    }
    const double ns = ask(params, start, &trajectory);
    return {trajectory, std::max(1.0, ns - handover_.question - handover_.column * params.T)};
  }

  // CPU time of an answer, ns; of one without its columns where none are wanted.
  double ask(const Parameters& params, const State& start, Trajectory* columns) {
    frames::Frame question;
    question.part = 4;
    question.silent = columns == nullptr;
    frames::put(params, question);
    frames::put(question, start.q, start.v);
    const double before = session_.cpu_ns();
    const frames::Frame answer = session_.ask(question, columns);
    if (columns) submission::require_columns(answer.q_columns, answer.v_columns, params.T);
    return session_.cpu_ns() - before;
  }

 private:
  static Limits limits() {
    Limits limits;
    limits.cpu_seconds = 3;
    limits.wall_seconds = 20;
    return limits;
  }

  Session session_;
  bool started_ = false;  // the first question takes the program's start, too
  Handover handover_;
};

// CPU time of this thread: that of the process stands still between ticks where it has a limit.
double cpu_ns() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e9 + static_cast<double>(time.tv_nsec);
}

class Least : public Contender {
 public:
  Timed run(const Parameters& params, const State& start) override {
    const double before = cpu_ns();
    Trajectory trajectory = study::simulate_scene(params, start);
    return {std::move(trajectory), std::max(1.0, cpu_ns() - before)};
  }
};

// The least of several askings: what is more is a disturbance.
Handover handover_of(InRunner& known) {
  const State in_flight{{0, 1e9, 0}, {0, 0, 0}};
  const auto least = [&](int T, bool with_columns) {
    Parameters params;
    params.T = T;
    Trajectory columns;
    double ns = INFINITY;
    for (int i = 0; i < 9; ++i) {
      ns = std::min(ns, known.ask(params, in_flight, with_columns ? &columns : nullptr));
    }
    return ns;
  };
  const double bare = least(kManyColumns, false), whole = least(kManyColumns, true);
  return {least(1, true), std::max(0.0, whole - bare) / kManyColumns};
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

int run(const std::string& folder, const std::vector<std::string>& submitted,
        const std::vector<std::string>& reference) {
  const auto scenes = scenes_of_one_corner(study::read_scenes(folder));
  auto submission = std::make_unique<InRunner>(submitted);
  auto solution = std::make_unique<InRunner>(reference);
  InRunner known(reference);  // one of its own: the solution begins as cold as the submission
  const Handover handover = handover_of(known);
  solution->take_off(handover);
  submission->take_off(handover);
  std::vector<std::unique_ptr<Contender>> contenders;
  contenders.push_back(std::move(submission));
  contenders.push_back(std::move(solution));
  contenders.push_back(std::make_unique<Least>());
  const std::vector<Curves> curves = sweep(scenes, contenders, kBudget);
  if (!curves[1].cut.empty()) throw std::runtime_error("the solution: " + curves[1].cut);

  json answer = {{"dt", sweep_steps()}, {"scenes", json::array()}, {"cut", curves[0].cut}};
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    answer["scenes"].push_back({{"scene", scenes[i].name},
                                {"title", scenes[i].title},
                                {"seconds", scenes[i].until},
                                {"submission", as_json(curves[0].points[i])},
                                {"solution", as_json(curves[1].points[i])},
                                {"least", as_json(curves[2].points[i])}});
  }
  std::cout << answer.dump(-1, ' ', false, json::error_handler_t::replace) << std::endl;
  return std::cout ? 0 : 3;
}

int run(const std::vector<std::string>& words) {
  const auto split = std::find(words.begin(), words.end(), "::");
  if (words.size() < 5 || words[0] != "--scenes" || split < words.begin() + 3 ||
      split >= words.end() - 1) {
    throw std::runtime_error("usage: stopwatch --scenes FOLDER COMMAND... :: COMMAND...");
  }
  return run(words[1], {words.begin() + 2, split}, {split + 1, words.end()});
}

}  // namespace
}  // namespace judge
}  // namespace bounce

int main(int argc, char** argv) try {
  std::signal(SIGPIPE, SIG_IGN);
  bounce::judge::stay_on_this_cpu();
  return bounce::judge::run({argv + 1, argv + argc});
} catch (const std::exception& e) {
  std::cerr << "stopwatch: " << e.what() << std::endl;
  return 3;
}
