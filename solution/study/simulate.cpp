#include "simulate.hpp"

#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "advice.hpp"
#include "timing.hpp"

namespace bounce::study {
namespace {

using json = nlohmann::ordered_json;

double number_of(const std::string& text) {
  double x = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw std::invalid_argument("the tolerance is \"" + text +
                                "\"; it must be a number, in metres");
  }
  return x;
}

json json_of(const Answer& answer, double seconds) {
  json q = json::array(), v = json::array();
  for (const auto& s : answer.motions) {
    q.push_back({s.x, s.y, s.theta});
    v.push_back({s.v_x, s.v_y, s.omega});
  }
  return {{"times", answer.times},
          {"q", q},
          {"v", v},
          {"method", answer.method},
          {"bound", answer.bound},
          {"horizon", answer.times.back()},
          {"seconds", seconds}};
}

}  // namespace

void simulate(const std::filesystem::path& file, const std::string& tolerance, std::ostream& out) {
  const Scene scene = read_scene(file, false);
  const double within = number_of(tolerance), begin = cpu_ns();
  const Answer answer = simulate_to(scene, within);
  json whole = json_of(answer, (cpu_ns() - begin) / 1e9);
  whole.update(advise(scene, answer, within));
  out << whole << "\n";
}

}  // namespace bounce::study
