// Time and error of every method in every scene: the chart of speed against accuracy.
#pragma once

#include "catalog.hpp"
#include "table.hpp"

namespace bounce::study {

// A row for each scene, method and setting: the step, s, or a tolerance. All of a scene take turns,
// and a time is the median of the rounds, in ns of CPU per simulated second; an error is that of
// starts.hpp. own_error_m is that of the scene's own start, which the handout compares with.
Table speed_accuracy(const std::vector<Scene>& scenes, const Methods& methods,
                     const Extent& extent);

}  // namespace bounce::study
