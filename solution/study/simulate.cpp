#include "simulate.hpp"

#include <charconv>
#include <iomanip>
#include <stdexcept>

#include "../exact/simulate_to.hpp"
#include "timing.hpp"

namespace bounce::study {
namespace {

double number_of(const std::string& text) {
  double x = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw std::invalid_argument("the tolerance is \"" + text +
                                "\"; it must be a number, in metres");
  }
  return x;
}

template <class Write>
void list(std::ostream& out, const char* name, std::size_t count, const Write& write) {
  out << "\"" << name << "\": [";
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) out << ", ";
    write(i);
  }
  out << "],\n";
}

}  // namespace

void simulate(const std::filesystem::path& file, const std::string& tolerance, std::ostream& out) {
  const exact::Scene scene = exact::read_start(file);
  const double begin = cpu_ns();
  const exact::Answer answer = exact::simulate_to(scene, number_of(tolerance));
  const double seconds = (cpu_ns() - begin) / 1e9;
  const std::size_t count = answer.times.size();
  out << std::setprecision(17) << "{";
  list(out, "times", count, [&](std::size_t i) { out << answer.times[i]; });
  list(out, "q", count, [&](std::size_t i) {
    const auto& s = answer.motions[i];
    out << "[" << s.x << ", " << s.y << ", " << s.theta << "]";
  });
  list(out, "v", count, [&](std::size_t i) {
    const auto& s = answer.motions[i];
    out << "[" << s.v_x << ", " << s.v_y << ", " << s.omega << "]";
  });
  out << "\"method\": \"" << answer.method << "\",\n\"step\": ";
  if (answer.step > 0) {
    out << answer.step;
  } else {
    out << "null";
  }
  out << ",\n\"bound\": " << answer.bound << ",\n\"horizon\": " << answer.horizon
      << ",\n\"seconds\": " << seconds << "}\n";
}

}  // namespace bounce::study
