// bounce_peers [--quick] SCENES FILE.csv: writes the table speed_accuracy, as bounce_study does,
// with the engines that were found when this was built in the same rounds as our methods.
#include <iostream>

#include "../speed_accuracy.hpp"
#include "engine.hpp"

namespace bounce::study {
namespace {

void run(const std::string& scenes, const std::string& file, bool quick) {
  const Extent extent = quick ? kQuick : Extent{9, 1e6};
  const int core = pin_to_one_core();
  Methods methods = all_methods();
  std::string engines = "# engines:";
  for (const auto& [name, peer] : all_peers) {
    methods.push_back(method_of(name, peer, quick ? 1e-3 : 1e-6));
    engines += " " + name + " " + peer.version;
  }
  std::vector<std::string> lines = origin(times_taken(core, extent));
  lines.push_back(engines);
  speed_accuracy(read_scenes(scenes), methods, extent).write(file, lines);
}

}  // namespace
}  // namespace bounce::study

int main(int argc, char** argv) try {
  std::vector<std::string> words(argv + 1, argv + argc);
  const bool quick = !words.empty() && words[0] == "--quick";
  if (quick) words.erase(words.begin());
  if (words.size() != 2) throw std::invalid_argument("usage: [--quick] SCENES FILE.csv");
  bounce::study::run(words[0], words[1], quick);
  return 0;
} catch (const std::invalid_argument& problem) {
  std::cerr << "bounce_peers: " << problem.what() << "\n";
  return 2;
} catch (const std::exception& problem) {
  std::cerr << "bounce_peers: " << problem.what() << "\n";
  return 3;
}
