// What every engine is here: a world with one square and the ground, made of a scene and a step.
// One file per engine, with its settings above the code.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "../../exact/scene.hpp"

namespace bounce::study {

using namespace exact;

class Engine {
 public:
  Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  virtual ~Engine() = default;

  virtual void step() = 0;
  // theta may be off by whole turns.
  virtual methods::Motion<double> motion() const = 0;
};

// What a reader wants to know before believing a comparison, in a few words each.
struct Settings {
  std::string numbers;      // the precision
  std::string planar;       // how the motion is kept in the plane
  std::string restitution;  // how epsilon is said
  std::string friction;     // how mu is said
  std::string contact;      // margins, corrections, iterations
  std::string order;        // which Euler: "velocity first" or "position first"
};

class Numpy;  // numpy.hpp

struct Peer {
  std::string name, title, version;
  bool swept;  // else only its steps are timed, and its errors compared with those that are
  Settings settings;
  std::string limit;  // why its error may stop falling, in words
  std::unique_ptr<Engine> (*make)(const Scene& scene, double dt);
  std::shared_ptr<Numpy> numpy = nullptr;  // in whose process it runs; `make` is null then
  double least_dt = 0;                     // s; smaller steps would take too long
};

// The ground reaches so far to either side, m, and so deep where it is a box.
inline constexpr double kGroundHalf = 50, kGroundDepth = 10;

// An engine with the settings that suit it best, and where they differ much, with those it has by
// itself.
using Peers = std::vector<Peer>;
Peers chipmunk();
Peers box2d();
Peers ode();
Peers bullet();
Peers mujoco();
Peers dart();
// None where Python has no numpy.
Peers numpy();

// Those that were found when this was built.
Peers all_peers();

}  // namespace bounce::study
