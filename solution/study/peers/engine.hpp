// The interface of every engine: a world with one square and the ground, made from a scene and a
// step. There is one file per engine, with its settings above the code.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "../../exact/scene.hpp"

namespace bounce::study {

class Engine {
 public:
  Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  virtual ~Engine() = default;

  virtual void step() = 0;
  // theta may be off by whole turns.
  virtual Motion<double> motion() const = 0;
};

struct Peer {
  std::string version;
  std::unique_ptr<Engine> (*make)(const Scene& scene, double dt);
  double least_dt = 3e-5;  // s. Smaller steps would take too long.
};

template <class World>
std::unique_ptr<Engine> make(const Scene& scene, double dt) {
  return std::make_unique<World>(scene, dt);
}

// How far the ground reaches to either side, and how deep if it is a box, m.
inline constexpr double kGroundHalf = 50, kGroundDepth = 10;

// The engines that were found when this was built, by name, each with the settings that its authors
// recommend, where they do. Their files enter them.
inline std::map<std::string, Peer> all_peers;

// An engine as a method (catalog.hpp): only its steps are timed, without making the world or
// reading the motion. Steps are from 1/30 s, which games take, down to least_dt or the peer's own.
struct Method;
Method method_of(const std::string& name, const Peer& peer, double least_dt);

}  // namespace bounce::study
