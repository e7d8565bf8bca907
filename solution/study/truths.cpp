#include <cstdio>

#include "../exact/truth.hpp"
#include "questions.hpp"

namespace bounce::study {
namespace {

// Enough digits to read back the same double.
std::string exactly(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

}  // namespace

Table truths(const Scenes& scenes) {
  Table table({"scene", "t_s", "x_m", "y_m", "theta_rad"});
  for (const Scene& scene : scenes) {
    const std::vector<double> times = sample_times(scene);
    const Samples truth = truth_of(scene);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      table.add(scene.name, exactly(times[i]), exactly(truth[i].x), exactly(truth[i].y),
                exactly(truth[i].theta));
    }
  }
  return table;
}

}  // namespace bounce::study
