#include "ladder.hpp"

namespace bounce::study {

Model model_of(ModelLevel level) {
  const int corners = level <= ModelLevel::ballistic      ? 0
                      : level <= ModelLevel::one_friction ? 1
                                                          : 2;
  return {corners, level == ModelLevel::one_friction || level == ModelLevel::two_frictions};
}

std::vector<methods::Motion<double>> motion_with(const Scene& scene, ModelLevel level,
                                                 const std::vector<double>& times,
                                                 EventOptions options) {
  const auto start = methods::motion_of<double>(scene.start);
  if (level == ModelLevel::asleep) return {times.size(), start};
  options.model = model_of(level);
  return simulate_events<double>(scene.params, start, times, options);
}

}  // namespace bounce::study
