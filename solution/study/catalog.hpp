// The methods and models that the study compares.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "../exact/truth.hpp"

namespace bounce::study {

// --- methods: each a function of a scene and a setting ---

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

// --- the ladder of models: each with exact times of impact, so that only the model differs ---

// What a model of the ladder may use.
Model model_of(ModelLevel level);

// The scene at these times with at most this model; fewer than `times` where its impacts go on
// without an end, or are more than options.most_events.
Motions motion_with(const Scene& scene, ModelLevel level, const std::vector<double>& times,
                    EventOptions options = {});

// The scene's parameters for steps of dt, s, until it isn't compared any more.
Parameters stepped(const Scene& scene, double dt);

// Moreau-Jean's scheme, which takes the whole model wherever a corner touches: the motion after
// each step; and the largest distance of a coordinate of simulate_scene to it.
Motions whole_model(const Parameters& params, const State& start);
double distance_to_whole_model(const Parameters& params, const State& start);

}  // namespace bounce::study
