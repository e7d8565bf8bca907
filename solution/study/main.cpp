// bounce_study [--quick] SCENES FILE.csv QUESTION: reads the scenes of a folder, and writes the
// table that answers the question. --quick measures fewer rounds, and fewer random scenes.
// bounce_peers is the same program with the engines that were found when it was built.
//
// bounce_study simulate SCENE.json TOLERANCE: see simulate.hpp.
#include <iostream>
#include <map>

#include "../exact/simulate_to.hpp"
#include "peers/engine.hpp"
#include "questions.hpp"
#include "simulate.hpp"

namespace bounce::study {
namespace {

struct Asked {
  Question* answer;
  std::string times{};
};

std::map<std::string, Asked> questions(int core, const Extent& extent) {
  const std::string timed = times_taken(core, extent);
  return {{"speed_accuracy", {speed_accuracy, timed}},
          {"truth", {truths}},
          {"endings", {endings}},
          {"energy_gain", {energy_gain}},
          {"solution_count", {solution_count}},
          {"gauss_seidel", {gauss_seidel_sweeps}},
          {"depth", {depth}},
          {"almost_flat", {almost_flat}},
          {"flat_landing", {flat_landing}},
          {"rest_and_drift", {rest_and_drift}},
          {"slope_and_energy", {slope_and_energy}},
          {"restitution", {restitution}},
          {"large_friction", {large_friction}},
          {"event_limits", {event_limits}},
          {"examples", {examples}},
          {"least_model", {least_model, timed}},
          {"chosen_model", {chosen_model, timed}},
          {"random_models", {random_models}},
          {"tolerance", {tolerance, times_taken(core)}}};
}

void run(const std::string& scenes, const std::string& file, const std::string& name, bool quick) {
  const Extent extent = quick ? kQuick : all_peers.empty() ? Extent() : kBesidePeers;
  const auto all = questions(pin_to_one_core(), extent);
  const auto question = all.find(name);
  if (question == all.end()) throw std::invalid_argument("there is no question \"" + name + "\"");
  std::vector<std::string> lines = origin(question->second.times);
  if (!all_peers.empty()) lines.push_back("# engines:");
  for (const auto& [engine, peer] : all_peers) lines.back() += " " + engine + " " + peer.version;
  question->second.answer(read_scenes(scenes), extent).write(file, lines);
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
  bounce::study::run(words[0], words[1], words[2], quick);
  return 0;
} catch (const bounce::study::Refusal& refusal) {
  std::cerr << "bounce_study: " << refusal.what() << "\n";
  return 1;
} catch (const std::invalid_argument& problem) {
  std::cerr << "bounce_study: " << problem.what() << "\n";
  return 2;
} catch (const std::exception& problem) {
  std::cerr << "bounce_study: " << problem.what() << "\n";
  return 3;
}
