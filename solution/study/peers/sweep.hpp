// How peers are run and timed, and the tables that come of it.
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

// The square at the sample times of a scene, with theta unwound to whole turns; not timed.
Samples samples_of(const Peer& peer, const Scene& scene, double dt);

// CPU time of so many runs of the steps up to scene.until, ns: making the world is not in it.
double time_of(const Peer& peer, const Scene& scene, double dt, long repeats);

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

// What an engine's own settings change: the errors of those that are not swept and of those that
// are, over the step.
Table variants(const Scenes& scenes, const Peers& peers, const PeerExtent& extent);

// The LCP alone, by Siconos's solvers and ours.
Table lcp_solvers(const PeerExtent& extent);

}  // namespace bounce::study
