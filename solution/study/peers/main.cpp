// bounce_peers SCENES STEPS FOLDER [--quick]: the engines that were found when this was built, on
// the scenes of a folder and on those for single steps, beside our methods. Writes into FOLDER
// peers.csv, peers_beside.csv (ours, in the same run), peers_ratios.csv (between the two),
// peers_steps.csv, peers_variants.csv, peers_settings.csv, and peers_lcp.csv where Siconos was
// found.
#include <iostream>
#include <sstream>

#include "sweep.hpp"

namespace bounce::study {
namespace {

const PeerExtent kWhole{Extent{9, 1e6, 0}, 1e-6}, kQuickly{Extent{3, 2e5, 0}, 1e-3};

std::string times_of_sweep(int core, const Extent& extent) {
  std::ostringstream text;
  text << times_taken(core, extent) << "; what takes over " << kLongNs / 1e6
       << " ms plays in one round of " << kLongEvery;
  return text.str();
}

int run(const std::vector<std::string>& words) {
  const PeerExtent& extent = words.size() == 4 ? kQuickly : kWhole;
  const int core = pin_to_one_core();
  const Scenes scenes = read_scenes(words[0]), kinds = read_scenes(words[1]);
  const std::filesystem::path folder = words[2];
  std::filesystem::create_directories(folder);
  const std::string timed = times_of_sweep(core, extent.timing);
  const auto write = [&](const Table& table, const char* name, const std::string& times) {
    table.write(folder / name, origin(times));
    std::cout << (folder / name).string() << ": " << table.rows() << " rows\n" << std::flush;
  };
  const Peers peers = all_peers();
  write(settings(peers), "peers_settings.csv", "");
  write(single_steps(kinds, peers, extent), "peers_steps.csv", timed);
#ifdef BOUNCE_PEER_SICONOS
  write(lcp_solvers(extent), "peers_lcp.csv", timed);
#endif
  write(variants(scenes, peers, extent), "peers_variants.csv", "");
  const Sweep tables = sweep(scenes, peers, extent);
  write(tables.ours, "peers_beside.csv", timed);
  write(tables.ratios, "peers_ratios.csv", timed);
  write(tables.peers, "peers.csv", timed);
  return 0;
}

}  // namespace
}  // namespace bounce::study

int main(int argc, char** argv) try {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() < 3 || words.size() > 4 || (words.size() == 4 && words[3] != "--quick")) {
    std::cerr << "usage: bounce_peers SCENES STEPS FOLDER [--quick]\n";
    return 2;
  }
  return bounce::study::run(words);
} catch (const std::invalid_argument& problem) {
  std::cerr << "bounce_peers: " << problem.what() << "\n";
  return 2;
} catch (const std::exception& problem) {
  std::cerr << "bounce_peers: " << problem.what() << "\n";
  return 3;
}
