// The methods that the study compares, each as one function of a scene and a setting.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "../exact/truth.hpp"
#include "starts.hpp"

namespace bounce::study {

using namespace exact;

// Why an error may stop falling, in words, and a cure that then does better: a method without that
// limit, or the method itself, measured against the truth under another law of impact.
struct Limit {
  std::string cure, words;
  methods::ImpactLaw law = methods::ImpactLaw::newton;
};

struct Method {
  std::string name, title;
  bool has_step;  // the setting is a time step, s; otherwise it is a tolerance
  std::vector<double> settings;
  std::function<Samples(const Scene&, double setting, int samples)> simulate;
  std::vector<Limit> limits;

  Samples run(const Scene& scene, double setting) const {
    return simulate(scene, setting, kSamples);
  }
};

std::vector<Method> all_methods();

// A method at one setting, the step as it is run.
struct Setting {
  double value;
  int samples;
  Errors error;
};
Setting measure(const Method& method, double setting, StartsOfScene& starts);

// CPU time of this process, ns.
double cpu_ns();

}  // namespace bounce::study
