// How peers are run and timed, and the tables that come of it.
#pragma once

#include "../catalog.hpp"
#include "../questions.hpp"
#include "engine.hpp"

namespace bounce::study {

inline constexpr double kLeastNs = 200'000;  // a timing lasts at least so long
inline constexpr int kFinelyTimed = 7;       // times as many rounds for single steps

struct PeerExtent {
  double least_dt;  // s
  int rounds;       // timings, of which the median counts
};

// The square at the sample times of a scene, with theta unwound to whole turns; not timed.
Samples samples_of(const Peer& peer, const Scene& scene, double dt);

// CPU time of the steps up to scene.until, ns: making the world is not in it.
double time_of(const Peer& peer, const Scene& scene, double dt);

double median(std::vector<double> values);

// The truth, for what runs elsewhere: scene, t_s, x_m, y_m, theta_rad.
Table truths(const Scenes& scenes);

// Every scene, peer and step, and the same of our own methods, timed in turns: two tables with the
// columns of speed_accuracy.csv.
struct PeersAndOurs {
  Table peers, ours;
};
PeersAndOurs sweep(const Scenes& scenes, const Peers& peers, const PeerExtent& extent);

// One step in the air and one in contact, each timed in turns with the fast form of the
// assignment's scheme; params.dt of each scene is the step.
Table single_steps(const Scenes& kinds, const Peers& peers, const PeerExtent& extent);

Table settings(const Peers& peers);

// What an engine's own settings change: the errors of those that are not swept and of those that
// are, at one step.
Table variants(const Scenes& scenes, const Peers& peers, double dt);

// The LCP alone, by Siconos's solvers and ours.
Table lcp_solvers(const PeerExtent& extent);

}  // namespace bounce::study
