// The interface of every engine: a world with one square and the ground, made from a scene and a
// step. There is one file per engine, with its settings above the code.
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

// The settings that a reader must know to judge a comparison, in a few words each.
struct Settings {
  std::string numbers;      // the precision
  std::string planar;       // how the motion is kept in the plane
  std::string restitution;  // how epsilon is set
  std::string friction;     // how mu is set
  std::string contact;      // margins, corrections, iterations
  std::string order;        // the kind of Euler step: "velocity first" or "position first"
};

class Numpy;  // numpy.hpp

struct Peer {
  std::string name, title, version;
  std::string year;  // of this version; empty for numpy, which is no engine
  bool swept;        // else it is only a variant: its steps are timed, and its errors compared
  Settings settings;
  std::string limit;  // why its error may stop falling, in words
  std::unique_ptr<Engine> (*make)(const Scene& scene, double dt);
  std::shared_ptr<Numpy> numpy = nullptr;  // in whose process it runs; `make` is null then
  // s. Smaller steps would take too long.
  double least_dt = 3e-5;
  // s. The steps of a sweep are close together down to here; below, where an engine only shows how
  // exact it gets, there are two in a factor of ten.
  double close_dt = 1e-3;
};

// How far the ground reaches to either side, and how deep if it is a box, m.
inline constexpr double kGroundHalf = 50, kGroundDepth = 10;

// A square that is this slow for this long falls asleep, in engines that have sleep and let one say
// so: its steps then cost next to nothing.
inline constexpr double kAsleep = 0.1;  // s
inline constexpr double kSlow = 0.01;   // m/s and rad/s

// Each engine with the settings that suit it best; and with its defaults, if these differ much.
using Peers = std::vector<Peer>;
Peers chipmunk();
Peers box2d();
Peers ode();
Peers bullet();
Peers mujoco();
Peers dart();
Peers siconos_kernel();
Peers simbody();
// Empty if Python has no numpy.
Peers numpy();

// The engines that were found when this was built.
Peers all_peers();

}  // namespace bounce::study
