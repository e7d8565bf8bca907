// bounce_study [--quick] SCENES FOLDER [QUESTION ...]: reads the scenes of a folder, answers the
// questions, all of them unless some are named, and writes a CSV for each into FOLDER. --quick
// measures fewer rounds and coarser maps.
#include <algorithm>
#include <functional>
#include <iostream>
#include <map>

#include "questions.hpp"
#include "timing.hpp"

namespace bounce::study {
namespace {

using Question = std::function<Table(const Scenes&, const Extent&)>;

// A question about the scenes, about none of them, and about neither scenes nor extent.
Question about(Table (*answer)(const Scenes&)) {
  return [answer](const Scenes& scenes, const Extent&) { return answer(scenes); };
}
Question about(Table (*answer)(const Extent&)) {
  return [answer](const Scenes&, const Extent& extent) { return answer(extent); };
}
Question about(Table (*answer)()) {
  return [answer](const Scenes&, const Extent&) { return answer(); };
}

std::map<std::string, Question> questions() {
  return {{"speed_accuracy", speed_accuracy},
          {"speed_ratios", speed_ratios},
          {"order", about(order)},
          {"energy_gain", about(energy_gain)},
          {"solution_count", about(solution_count)},
          {"gauss_seidel", about(gauss_seidel_sweeps)},
          {"depth", about(depth)},
          {"almost_flat", about(almost_flat)},
          {"flat_landing", about(flat_landing)},
          {"rest_and_drift", about(rest_and_drift)},
          {"scaling", about(scaling)},
          {"bad_input", about(bad_input)},
          {"examples", about(examples)},
          {"least_model", least_model},
          {"chosen_model", chosen_model}};
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
    const Table table = all.at(name)(scenes, extent);
    table.write(file, origin(core, extent));
    std::cout << file.string() << ": " << table.rows() << " rows\n" << std::flush;
  }
  return 0;
}

}  // namespace
}  // namespace bounce::study

int main(int argc, char** argv) try {
  std::vector<std::string> words(argv + 1, argv + argc);
  const bool quick = !words.empty() && words[0] == "--quick";
  if (quick) words.erase(words.begin());
  if (words.size() < 2) {
    std::cerr << "usage: bounce_study [--quick] SCENES FOLDER [QUESTION ...]\n";
    return 2;
  }
  return bounce::study::run(words, quick ? bounce::study::kQuick : bounce::study::Extent());
} catch (const std::invalid_argument& problem) {
  std::cerr << "bounce_study: " << problem.what() << "\n";
  return 2;
} catch (const std::exception& problem) {
  std::cerr << "bounce_study: " << problem.what() << "\n";
  return 3;
}
