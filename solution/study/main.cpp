// bounce_study [--quick] SCENES FILE.csv QUESTION: reads the scenes of a folder, and writes the
// table that answers the question. --quick measures fewer rounds, and fewer random scenes.
//
// bounce_study simulate SCENE.json TOLERANCE: see simulate.hpp.
#include <algorithm>
#include <functional>
#include <iostream>
#include <map>

#include "../exact/simulate_to.hpp"
#include "questions.hpp"
#include "simulate.hpp"
#include "speed_accuracy.hpp"

namespace bounce::study {
namespace {

struct Question {
  std::function<Table(const Scenes&, const Extent&)> answer;
  std::string times{};
};

std::map<std::string, Question> questions(int core, const Extent& extent) {
  const std::string timed = times_taken(core, extent);
  const auto of_scenes = [](Table (*answer)(const Scenes&)) {
    return Question{[answer](const Scenes& scenes, const Extent&) { return answer(scenes); }};
  };
  const auto alone = [](Table (*answer)()) {
    return Question{[answer](const Scenes&, const Extent&) { return answer(); }};
  };
  return {{"speed_accuracy",
           {[](const Scenes& scenes, const Extent& asked) {
              return speed_accuracy(scenes, all_methods(), asked);
            },
            timed}},
          {"truth", of_scenes(truths)},
          {"energy_gain", alone(energy_gain)},
          {"solution_count", alone(solution_count)},
          {"gauss_seidel", alone(gauss_seidel_sweeps)},
          {"depth", alone(depth)},
          {"almost_flat", alone(almost_flat)},
          {"flat_landing", alone(flat_landing)},
          {"rest_and_drift", of_scenes(rest_and_drift)},
          {"scaling", alone(scaling)},
          {"examples", alone(examples)},
          {"least_model", {least_model, timed}},
          {"chosen_model", {chosen_model, timed}},
          {"random_models", alone(random_models)},
          {"tolerance",
           {[](const Scenes&, const Extent& asked) {
              return tolerance(asked.rounds > kQuick.rounds ? 4000 : 400);
            },
            times_taken(core)}}};
}

void run(const std::string& scenes, const std::string& file, const std::string& name,
         const Extent& extent) {
  const auto all = questions(pin_to_one_core(), extent);
  const auto question = all.find(name);
  if (question == all.end()) throw std::invalid_argument("there is no question \"" + name + "\"");
  const Table table = question->second.answer(read_scenes(scenes), extent);
  table.write(file, origin(question->second.times));
}

}  // namespace
}  // namespace bounce::study

int main(int argc, char** argv) try {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 3 && words[0] == "simulate") {
    bounce::study::simulate(words[1], words[2], std::cout);
    return 0;
  }
  const bool quick = !words.empty() && words[0] == "--quick";
  if (quick) words.erase(words.begin());
  if (words.size() != 3) throw std::invalid_argument("usage: [--quick] SCENES FILE.csv QUESTION");
  bounce::study::run(words[0], words[1], words[2],
                     quick ? bounce::study::kQuick : bounce::study::Extent());
  return 0;
} catch (const bounce::exact::Refusal& refusal) {
  std::cerr << "bounce_study: " << refusal.what() << "\n";
  return 1;
} catch (const std::invalid_argument& problem) {
  std::cerr << "bounce_study: " << problem.what() << "\n";
  return 2;
} catch (const std::exception& problem) {
  std::cerr << "bounce_study: " << problem.what() << "\n";
  return 3;
}
