// stopwatch --scenes FOLDER TIMED... :: SOLUTION... :: GRADED...
//
// Measures, for each dt, the scenes that the assignment's model can simulate (speed_curves.hpp),
// with a submission's runner built for speed, the solution's runner, and the simulator that uses
// the least model for each step. Prints {"dt": [...], "scenes": [{"scene", "title", "seconds",
// "submission", "solution", "least"}], "cut": sentence or ""}; a curve is a list of {"dt", "ns",
// "error"}, with ns of CPU time for a simulated second and an error in m, or null if it isn't
// finite.
//
// If a timed column is wrong (right_steps.hpp), the submission's graded runner is asked the same,
// and only one sentence is printed: {"otherwise": place} if that one's answer is right, so that the
// two builds are different programs and the times mean nothing, and else {"wrong": place}.
//
// A runner is timed from outside, by the system's count of its CPU time, from the question to the
// last column of its answer. The cost of communication is measured with the solution's runner,
// which is trusted, and subtracted from both.
//
// Exit status 3 if the solution's runner ends, or if CPU time can't be measured.
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <nlohmann/json.hpp>

#include "../../solution/exact/simulate_scene.hpp"
#include "../../tests/parts/cases.hpp"
#include "../../tests/parts/submission.hpp"
#include "../runner/messages.hpp"
#include "right_steps.hpp"
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

constexpr double kBudget = 2e9;  // ns of CPU time for all curves
constexpr int kManyColumns = 20'001;

// The cost of communication, without computing: ns per question, and ns per column.
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

  // The CPU time of an answer, ns; without sending columns if `columns` is null.
  double ask(const Parameters& params, const State& start, Trajectory* columns) {
    frames::Frame question = frames::question(4, params, start.q, start.v);
    question.silent = columns == nullptr;
    const double before = session_.cpu_ns();
    const frames::Frame answer = session_.ask(question, columns);
    if (columns) submission::require_columns(answer.q_columns, answer.v_columns, params.T);
    return session_.cpu_ns() - before;
  }

 private:
  static Limits limits() {
    Limits limits;
    limits.cpu_seconds = 4;
    limits.wall_seconds = 20;
    return limits;
  }

  Session session_;
  bool started_ = false;  // else the first question would include the program's start
  Handover handover_;
};

// Some column isn't a step of the solution's from the one before: the time of such answers says
// nothing.
struct Wrong {
  bool right_as_graded;  // the graded build answers right there
  std::string place;
};

// A submission: its timed runner, and its graded one.
class Submitted : public Contender {
 public:
  Submitted(const std::vector<std::string>& timed, const std::vector<std::string>& graded,
            const Handover& handover)
      : timed_(timed), graded_(graded) {
    timed_.take_off(handover);
  }

  // Throws Wrong.
  Timed run(const Parameters& params, const State& start) override {
    Timed timed = timed_.run(params, start);
    if (const auto wrong = wrong_column(timed.trajectory, start, params)) {
      char words[80];
      std::snprintf(words, sizeof words, "at dt = %.2g s, column %td of %d", params.dt, *wrong,
                    params.T);
      throw Wrong{is_right_as_graded(params, start), words};
    }
    return timed;
  }

 private:
  bool is_right_as_graded(const Parameters& params, const State& start) try {
    return !wrong_column(graded_.run(params, start).trajectory, start, params);
  } catch (const std::runtime_error&) {
    return false;  // it gave no answer
  }

  InRunner timed_, graded_;
};

// CPU time of this thread. That of the process only advances in ticks if it has a limit.
double cpu_ns() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e9 + static_cast<double>(time.tv_nsec);
}

class Least : public Contender {
 public:
  Timed run(const Parameters& params, const State& start) override {
    const double before = cpu_ns();
    Trajectory trajectory = exact::simulate_scene(params, start);
    return {std::move(trajectory), std::max(1.0, cpu_ns() - before)};
  }
};

// The least of several measurements, because disturbances only add time.
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

using Command = std::vector<std::string>;

json measured(const std::vector<exact::Scene>& scenes, const Command& timed,
              const Command& reference, const Command& graded) {
  auto solution = std::make_unique<InRunner>(reference);
  InRunner known(reference);  // its own runner, so that the solution starts cold, too
  const Handover handover = handover_of(known);
  solution->take_off(handover);
  std::vector<std::unique_ptr<Contender>> contenders;
  contenders.push_back(std::make_unique<Submitted>(timed, graded, handover));
  contenders.push_back(std::move(solution));
  contenders.push_back(std::make_unique<Least>());
  const std::vector<Curves> curves = speed_curves(scenes, contenders, kBudget);
  if (!curves[1].cut.empty()) throw std::runtime_error("the solution: " + curves[1].cut);

  json answer = {{"dt", measured_steps()}, {"scenes", json::array()}, {"cut", curves[0].cut}};
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

int run(const std::string& folder, const Command& timed, const Command& reference,
        const Command& graded) {
  json answer;
  try {
    const auto scenes = scenes_of_one_corner(exact::read_scenes(folder));
    answer = measured(scenes, timed, reference, graded);
  } catch (const Wrong& wrong) {
    answer = {{wrong.right_as_graded ? "otherwise" : "wrong", wrong.place}};
  }
  std::cout << answer.dump(-1, ' ', false, json::error_handler_t::replace) << std::endl;
  return std::cout ? 0 : 3;
}

// The commands, which "::" separates.
std::vector<Command> commands_in(const std::vector<std::string>& words) {
  std::vector<Command> commands(1);
  for (const std::string& word : words) {
    if (word == "::") {
      commands.emplace_back();
    } else {
      commands.back().push_back(word);
    }
  }
  return commands;
}

int run(const std::vector<std::string>& words) {
  if (words.size() >= 2 && words[0] == "--scenes") {
    const auto commands = commands_in({words.begin() + 2, words.end()});
    const auto is_empty = [](const Command& command) { return command.empty(); };
    if (commands.size() == 3 && std::none_of(commands.begin(), commands.end(), is_empty)) {
      return run(words[1], commands[0], commands[1], commands[2]);
    }
  }
  throw std::runtime_error("usage: stopwatch --scenes FOLDER TIMED... :: SOLUTION... :: GRADED...");
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
