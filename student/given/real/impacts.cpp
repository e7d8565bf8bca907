#include "impacts.hpp"

#include <algorithm>
#include <bounce/part2_lcp.hpp>
#include <bounce/solve_lcp.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace bounce::real {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Law read_law(std::istringstream& line) {
  Law law;
  line >> law.error;
  std::getline(line >> std::ws, law.name);
  return law;
}

Impact read_impact(std::istringstream& line) {
  Impact hit{};
  line >> hit.r_x >> hit.r_y;
  for (double& x : hit.before) line >> x;
  for (double& x : hit.after) line >> x;
  return hit;
}

Jacobian jacobian(const Impact& hit) {
  Jacobian J;
  J << 1, 0, 0, 1, -hit.r_y, hit.r_x;
  return J;
}

// The velocity after the contact's impulses per mass act at the corner.
Vector3 pushed(const Impact& hit, double normal, double tangential, double gyration) {
  const double moment = hit.r_x * normal - hit.r_y * tangential;
  return hit.before + Vector3(tangential, normal, moment / gyration);
}

// Not finite where solve_lcp finds no solution.
Answer answer(const Impact& hit, const Parameters& params) {
  const double gyration = params.l * params.l / 6;
  const Lcp lcp = form_lcp(jacobian(hit), hit.before, params);
  Vector3 f;
  try {
    f = solve_lcp(lcp.V, lcp.p) * (params.dt / params.m);
  } catch (const std::exception&) {
    return {Vector3::Constant(kInfinity), kInfinity};
  }
  const Vector3 after = pushed(hit, f(0), f(2) - f(1), gyration), off = after - hit.after;
  const double size = std::sqrt(off(0) * off(0) + off(1) * off(1) + gyration * off(2) * off(2));
  return {after, std::isfinite(size) ? size : kInfinity};
}

double median(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  const std::size_t half = numbers.size() / 2;
  return numbers.size() % 2 ? numbers[half] : (numbers[half - 1] + numbers[half]) / 2;
}

}  // namespace

Measured read_measured(const std::filesystem::path& file) {
  std::ifstream in(file);
  Measured measured;
  measured.params.g.setZero();  // an impact takes no time
  for (std::string text; std::getline(in, text);) {
    std::istringstream line(text);
    std::string kind;
    line >> kind;
    if (kind == "square")
      line >> measured.params.l >> measured.params.mu >> measured.params.epsilon;
    if (kind == "floor") line >> measured.floor;
    if (kind == "assignment") measured.assignment = read_law(line);
    if (kind == "law") measured.others.push_back(read_law(line));
    if (kind == "impact") measured.impacts.push_back(read_impact(line));
  }
  if (measured.impacts.empty())
    throw std::runtime_error(file.string() + " is missing: unpack the handout anew");
  return measured;
}

Result ask(const Measured& measured) {
  Result result{{}, 0, 0};
  std::vector<double> errors;
  for (const Impact& hit : measured.impacts) {
    result.answers.push_back(answer(hit, measured.params));
    errors.push_back(result.answers.back().error);
    result.no_solution += !std::isfinite(errors.back());
  }
  result.error = median(errors);
  return result;
}

}  // namespace bounce::real
