// bounce_study [--quick] SCENES FOLDER [QUESTION ...]: reads the scenes of a folder, answers the
// named questions (by default all), and writes a CSV for each into FOLDER. --quick measures fewer
// rounds and coarser maps.
//
// bounce_study simulate SCENE.json TOLERANCE: see simulate.hpp.
#include <algorithm>
#include <functional>
#include <iostream>
#include <map>

#include "../exact/simulate_to.hpp"
#include "questions.hpp"
#include "simulate.hpp"
#include "timing.hpp"

namespace bounce::study {
namespace {

struct Question {
  std::function<Table(const Scenes&, const Extent&)> answer;
  bool timed = false, once = false;

  std::string times(int core, const Extent& extent) const {
    return once ? times_taken(core) : timed ? times_taken(core, extent) : "";
  }
};

Question timed(Table (*answer)(const Scenes&, const Extent&)) { return {answer, true}; }
Question timed(Table (*answer)(const Extent&)) {
  return {[answer](const Scenes&, const Extent& extent) { return answer(extent); }, true};
}
// An untimed question depends on the scenes, on the extent, or on neither.
Question untimed(Table (*answer)(const Scenes&)) {
  return {[answer](const Scenes& scenes, const Extent&) { return answer(scenes); }};
}
Question untimed(Table (*answer)(const Extent&)) {
  return {[answer](const Scenes&, const Extent& extent) { return answer(extent); }};
}
Question untimed(Table (*answer)()) {
  return {[answer](const Scenes&, const Extent&) { return answer(); }};
}

std::map<std::string, Question> questions() {
  return {{"speed_accuracy", timed(speed_accuracy)},
          {"speed_ratios", timed(speed_ratios)},
          {"order", untimed(order)},
          {"truth", untimed(truths)},
          {"energy_gain", untimed(energy_gain)},
          {"solution_count", untimed(solution_count)},
          {"gauss_seidel", untimed(gauss_seidel_sweeps)},
          {"depth", untimed(depth)},
          {"almost_flat", untimed(almost_flat)},
          {"flat_landing", untimed(flat_landing)},
          {"rest_and_drift", untimed(rest_and_drift)},
          {"scaling", untimed(scaling)},
          {"bad_input", timed(bad_input)},
          {"examples", untimed(examples)},
          {"least_model", timed(least_model)},
          {"chosen_model", timed(chosen_model)},
          {"tolerance", {untimed(tolerance).answer, false, true}},
          {"random_models", untimed(random_models)}};
}

int run(const std::vector<std::string>& words, const Extent& extent) {
  const auto all = questions();
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
  const int core = pin_to_one_core();
  std::filesystem::create_directories(words[1]);
  for (const std::string& name : names) {
    const std::filesystem::path file = std::filesystem::path(words[1]) / (name + ".csv");
    const Question& question = all.at(name);
    const Table table = question.answer(scenes, extent);
    table.write(file, origin(question.times(core, extent)));
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
