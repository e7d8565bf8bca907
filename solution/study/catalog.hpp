// The methods that the study compares, each as a function of a scene and a setting.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "../exact/truth.hpp"

namespace bounce::study {

struct Method {
  std::string name;
  bool has_step;  // the setting is a time step, s; otherwise it is a tolerance
  std::vector<double> settings;
  std::function<Motions(const Scene&, double setting, int samples)> simulate;
  // CPU time of this many runs, ns; empty where a run is all that `simulate` does.
  std::function<double(const Scene&, double setting, long repeats)> time = {};
};
using Methods = std::vector<Method>;

Methods all_methods();

// The steps of a sweep from `largest` down to `least`, four in a factor of ten.
std::vector<double> steps_down_to(double least, double largest = 1e-2);

}  // namespace bounce::study
