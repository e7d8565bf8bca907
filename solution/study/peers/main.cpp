// bounce_peers SCENES STEPS FOLDER [--quick]: the engines that were found when this was built, on
// the scenes of a folder and on those for single steps, beside our methods. Writes into FOLDER
// peers.csv, peers_beside.csv (ours, in the same run), peers_steps.csv, peers_variants.csv,
// peers_settings.csv, peers_lcp.csv where Siconos was found, and truth.csv.
#include <iostream>

#include "sweep.hpp"

namespace bounce::study {
namespace {

int run(const std::vector<std::string>& words) {
  const bool quick = words.size() == 4;
  const PeerExtent extent = quick ? PeerExtent{1e-3, 3} : PeerExtent{1e-5, 3};
  const int core = pin_to_one_core();
  const Scenes scenes = read_scenes(words[0]), kinds = read_scenes(words[1]);
  const std::filesystem::path folder = words[2];
  std::filesystem::create_directories(folder);
  const auto write = [&](const Table& table, const char* name, int times_the_rounds = 1) {
    table.write(folder / name, origin(core, Extent{times_the_rounds * extent.rounds, kLeastNs}));
    std::cout << (folder / name).string() << ": " << table.rows() << " rows\n" << std::flush;
  };
  const Peers peers = all_peers();
  Scenes all = scenes;
  all.insert(all.end(), kinds.begin(), kinds.end());
  write(truths(all), "truth.csv");
  write(settings(peers), "peers_settings.csv");
  write(single_steps(kinds, peers, extent), "peers_steps.csv", kFinelyTimed);
#ifdef BOUNCE_PEER_SICONOS
  write(lcp_solvers(extent), "peers_lcp.csv", kFinelyTimed);
#endif
  write(variants(scenes, peers, quick ? 1e-3 : 1e-4), "peers_variants.csv");
  const PeersAndOurs tables = sweep(scenes, peers, extent);
  write(tables.ours, "peers_beside.csv");
  write(tables.peers, "peers.csv");
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
