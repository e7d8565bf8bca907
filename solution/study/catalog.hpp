// The methods that the study compares, each as one function of a scene and a setting.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "../methods/impact_laws.hpp"
#include "scene.hpp"

namespace bounce::study {

// The square at even times up to scene.until: kSamples of them, unless another number is asked for.
// Between them an error may be larger.
inline constexpr int kSamples = 20;
using Samples = std::vector<methods::Motion<double>>;

// Why an error may stop falling, in words, and what does better where that is so: a method without
// that limit; or the method itself, measured by the truth under another law of impact.
struct Limit {
  std::string cure, words;
  methods::ImpactLaw law = methods::ImpactLaw::newton;
};

struct Method {
  std::string name, title;
  bool has_step;  // the setting is a time step, s; otherwise it is a tolerance
  std::vector<double> settings;
  std::function<Samples(const Scene&, double setting, int samples)> look;
  std::vector<Limit> limits;

  Samples run(const Scene& scene, double setting) const { return look(scene, setting, kSamples); }
};

std::vector<Method> all_methods();

std::vector<double> sample_times(const Scene& scene, int samples = kSamples);

// The truth: event-driven in long double, with tolerances a thousandth of any method's, so that the
// event-driven method in double has an error that can be seen. Throws std::runtime_error where the
// cap on events was reached.
Samples truth_of(const Scene& scene);
Samples truth_under(methods::ImpactLaw law, const Scene& scene);

// The largest distance over the samples, m; infinite where some are missing or not finite.
double error_of(const Scene& scene, const Samples& samples, const Samples& truth);

// The step nearest to dt of which a whole number makes up the time between two samples.
double fitting_step(const Scene& scene, double dt, int samples = kSamples);

// CPU time of this process, ns.
double cpu_ns();

}  // namespace bounce::study
