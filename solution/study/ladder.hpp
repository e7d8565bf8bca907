// The ladder of models, each with exact times of impact, so that only the model differs.
#pragma once

#include "../exact/event_driven.hpp"
#include "../exact/scene.hpp"

namespace bounce::study {

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
