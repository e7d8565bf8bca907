// The methods that the study compares, each as a function of a scene and a setting.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "../exact/truth.hpp"
#include "starts.hpp"

namespace bounce::study {

using namespace exact;

struct Method {
  std::string name;
  bool has_step;  // the setting is a time step, s; otherwise it is a tolerance
  std::vector<double> settings;
  std::function<Samples(const Scene&, double setting, int samples)> simulate;
  // CPU time of this many runs, ns; empty where a run is all that `simulate` does.
  std::function<double(const Scene&, double setting, long repeats)> time = {};
};
using Methods = std::vector<Method>;

Methods all_methods();

// A method at one setting, the step as it is run.
struct Setting {
  double value;
  int samples;
  Errors error;
};
Setting measure(const Method& method, double setting, StartsOfScene& starts);

}  // namespace bounce::study
