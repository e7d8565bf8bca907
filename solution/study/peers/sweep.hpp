// Runs and times the engines, and makes their tables.
#pragma once

#include "../catalog.hpp"
#include "../questions.hpp"
#include "engine.hpp"
#include "turns.hpp"

namespace bounce::study {

struct PeerExtent {
  Extent timing;
  double least_dt;  // s
};

// The square at the samples of a grid, with theta unwound to whole turns; not timed.
Samples samples_of(const Peer& peer, const Scene& scene, const Grid& grid);

// CPU time of `repeats` runs of the steps up to scene.until, ns, without making the world.
double time_of(const Peer& peer, const Scene& scene, const Grid& grid, long repeats);

// Every scene, peer and step, and the same of our own methods, timed in turns: peers and ours with
// the columns of speed_accuracy.csv and quartiles, and how they compare (ratios.hpp).
struct Sweep {
  Table peers, ours, ratios;
};
Sweep sweep(const Scenes& scenes, const Peers& peers, const PeerExtent& extent);

// One step in the air and one in contact, each timed in turns with the fast form of the
// assignment's scheme; params.dt of each scene is the step.
Table single_steps(const Scenes& kinds, const Peers& peers, const PeerExtent& extent);

Table settings(const Peers& peers);

// The effect of an engine's settings: errors over the step, of the variants and of the settings in
// the sweep.
Table variants(const Scenes& scenes, const Peers& peers, const PeerExtent& extent);

// The LCP alone, by Siconos's solvers and ours.
Table lcp_solvers(const PeerExtent& extent);

}  // namespace bounce::study
