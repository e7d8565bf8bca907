#include "ladder.hpp"

#include <algorithm>
#include <cmath>

#include "../exact/simulate_scene.hpp"
#include "../methods/moreau_jean.hpp"
#include "../methods/scheme.hpp"

namespace bounce::study {

Model model_of(ModelLevel level) {
  const int corners = level <= ModelLevel::ballistic      ? 0
                      : level <= ModelLevel::one_friction ? 1
                                                          : 2;
  return {corners, level == ModelLevel::one_friction || level == ModelLevel::two_frictions};
}

Motions motion_with(const Scene& scene, ModelLevel level, const std::vector<double>& times,
                    EventOptions options) {
  const auto start = motion_of(scene.start);
  if (level == ModelLevel::asleep) return {times.size(), start};
  options.model = model_of(level);
  return simulate_events<double>(scene.params, start, times, options);
}

Parameters stepped(const Scene& scene, double dt) {
  Parameters params = scene.params;
  params.dt = dt;
  params.T = int(std::lround(scene.until / dt)) + 1;
  return params;
}

Motions whole_model(const Parameters& params, const State& start) {
  return sample(MoreauJean<2>(params), motion_of(start), params.T - 1, 1);
}

double distance_to_whole_model(const Parameters& params, const State& start) {
  const Trajectory chosen = simulate_scene(params, start);
  double farthest = 0;
  Eigen::Index column = 0;
  for (const auto& s : whole_model(params, start)) {
    const Vector3 off = chosen.q.col(++column) - state_of(s).q;
    farthest = std::max(farthest, off.cwiseAbs().maxCoeff());
  }
  return farthest;
}

}  // namespace bounce::study
