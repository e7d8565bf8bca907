// bounce_study [--quick] SCENES FOLDER [QUESTION ...]: reads the scenes of a folder, answers the
// named questions (by default all), and writes a CSV for each into FOLDER. --quick measures fewer
// rounds, and fewer random scenes.
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
  std::string times = "";
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

int run(const std::vector<std::string>& words, const Extent& extent) {
  const int core = pin_to_one_core();
  const auto all = questions(core, extent);
  std::vector<std::string> names(words.begin() + 2, words.end());
  if (names.empty())
    for (const auto& [name, question] : all) names.push_back(name);
  for (const std::string& name : names) {
    if (all.count(name)) continue;
    std::cerr << "bounce_study: there is no question \"" << name << "\"; there are:";
    for (const auto& [known, question] : all) std::cerr << " " << known;
    std::cerr << "\n";
    return 2;
  }
  const Scenes scenes = read_scenes(words[0]);
  std::filesystem::create_directories(words[1]);
  for (const std::string& name : names) {
    const std::filesystem::path file = std::filesystem::path(words[1]) / (name + ".csv");
    const Question& question = all.at(name);
    const Table table = question.answer(scenes, extent);
    table.write(file, origin(question.times));
    std::cout << file.string() << ": " << table.rows() << " rows\n" << std::flush;
  }
  return 0;
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
  if (words.size() < 2) {
    std::cerr << "usage: bounce_study [--quick] SCENES FOLDER [QUESTION ...]\n";
    return 2;
  }
  return bounce::study::run(words, quick ? bounce::study::kQuick : bounce::study::Extent());
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
