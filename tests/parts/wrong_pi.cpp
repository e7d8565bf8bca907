#include "wrong_pi.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "recognise.hpp"

namespace bounce::tests {
namespace {

constexpr double kWhole = 1e-4;  // how far a number of quarters may be from a whole one

// By what angle the answer's arm is turned from the right one; none if it differs otherwise.
std::optional<double> turn(const Answer& right, const Answer& got) {
  if (got.numbers.size() != 7 || !got.numbers.allFinite()) return std::nullopt;
  const double x = right.numbers(5), y = -right.numbers(2);
  const double got_x = got.numbers(5), got_y = -got.numbers(2);
  const bool is_an_arm = same(std::hypot(x, y), std::hypot(got_x, got_y)) &&
                         same(got.numbers(6) - right.numbers(6), got_y - y);
  if (!is_an_arm) return std::nullopt;
  return std::atan2(x * got_y - y * got_x, x * got_x + y * got_y);
}

bool fits(double pi, const std::vector<double>& turns) {
  const double quarter = (pi - std::numbers::pi) / 4;
  const auto quarters = [&](double turn) { return turn / quarter; };
  const auto is_whole = [&](double turn) {
    return std::abs(quarters(turn) - std::round(quarters(turn))) < kWhole;
  };
  const auto is_turned = [&](double turn) { return std::round(quarters(turn)) != 0; };
  return std::all_of(turns.begin(), turns.end(), is_whole) &&
         std::count_if(turns.begin(), turns.end(), is_turned) >= static_cast<int>(kEnough);
}

}  // namespace

Words written_pi(const std::vector<Answer>& right, const std::vector<Answer>& got) {
  std::vector<double> turns;
  for (std::size_t k = 0; k < right.size(); ++k) {
    const std::optional<double> turned = turn(right[k], got[k]);
    if (!turned) return {};
    turns.push_back(*turned);
  }
  for (const char* pi : {"3.14", "3.141", "3.142", "3.1415", "3.1416", "3.14159"}) {
    if (fits(std::stod(pi), turns)) {
      return {std::string("Your arm is the right one, turned by a multiple of (") + pi +
              " - pi) / 4 in every question. Often: pi is written with too few digits."};
    }
  }
  return {};
}

}  // namespace bounce::tests
