// Errors over shifted starts.
//
// How far a scheme is off depends on where within a step an impact falls: with one start, the error
// over the step is a saw-tooth of up to a factor of ten. So an error is the root of the mean square
// over several starts, which lie parts of a step apart along the true motion.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "../exact/truth.hpp"

namespace bounce::study {

using namespace exact;

inline constexpr int kStarts = 5;

// A step dt, s, that divides scene.until into a whole number of steps, and a number of samples that
// divides that number. dt is within 3 % of the step asked for, if that is at most scene.until / 40.
struct Grid {
  double dt;
  int samples;
};
Grid grid_of(const Scene& scene, double dt);

// m; `own` is that of the scene's own start.
struct Errors {
  double own, rms;
};

class Starts {
 public:
  // Those for a step, s.
  Starts(const Scene& scene, double dt);

  const Grid& grid() const { return grid_; }

  using Run = std::function<Samples(const Scene&, const Grid&)>;
  Errors errors_of(const Run& run) const;

 private:
  Grid grid_;
  std::vector<Scene> scenes_;
  std::vector<Samples> truths_;
};

// The starts of a scene for every step of a sweep, each made once.
class StartsOfScene {
 public:
  explicit StartsOfScene(const Scene& scene) : scene_(scene) {}
  const Starts& at(double dt) { return by_step_.try_emplace(dt, scene_, dt).first->second; }

 private:
  const Scene& scene_;
  std::map<double, Starts> by_step_;
};

// The steps of a sweep from `largest` down to `least`, four in a factor of ten.
inline constexpr int kStepsPerDecade = 4;
std::vector<double> steps_down_to(double least, double largest = 1e-2);

}  // namespace bounce::study
