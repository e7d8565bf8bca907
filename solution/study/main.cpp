// bounce_study SCENES FOLDER [QUESTION ...]: reads the scenes of a folder, answers the questions,
// all of them unless some are named, and writes a CSV for each into FOLDER.
#include <algorithm>
#include <functional>
#include <iostream>
#include <map>

#include "questions.hpp"

namespace bounce::study {
namespace {

using Question = std::function<Table(const Scenes&)>;

std::map<std::string, Question> questions() {
  return {{"speed_accuracy", speed_accuracy},
          {"order", order},
          {"energy_gain", [](const Scenes&) { return energy_gain(); }},
          {"solution_count", [](const Scenes&) { return solution_count(); }},
          {"gauss_seidel", [](const Scenes&) { return gauss_seidel_sweeps(); }},
          {"depth", [](const Scenes&) { return depth(); }},
          {"almost_flat", [](const Scenes&) { return almost_flat(); }},
          {"rest_and_drift", rest_and_drift},
          {"scaling", [](const Scenes&) { return scaling(); }},
          {"least_model", least_model},
          {"chosen_model", chosen_model}};
}

int run(const std::vector<std::string>& words) {
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
  std::filesystem::create_directories(words[1]);
  for (const std::string& name : names) {
    const std::filesystem::path file = std::filesystem::path(words[1]) / (name + ".csv");
    const Table table = all.at(name)(scenes);
    table.write(file, origin());
    std::cout << file.string() << ": " << table.rows() << " rows\n" << std::flush;
  }
  return 0;
}

}  // namespace
}  // namespace bounce::study

int main(int argc, char** argv) try {
  if (argc < 3) {
    std::cerr << "usage: bounce_study SCENES FOLDER [QUESTION ...]\n";
    return 2;
  }
  return bounce::study::run({argv + 1, argv + argc});
} catch (const std::invalid_argument& problem) {
  std::cerr << "bounce_study: " << problem.what() << "\n";
  return 2;
} catch (const std::exception& problem) {
  std::cerr << "bounce_study: " << problem.what() << "\n";
  return 3;
}
