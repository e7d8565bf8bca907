#include "smallest.hpp"

#include <bounce/solve_lcp.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace bounce::tests {
namespace {

constexpr int kMostDigits = 17;

int part_of(const Case& c) { return c.check.at(4) - '0'; }  // "part3.FallsFreely"

int digits_of(double x) {
  for (int digits = 1; digits < kMostDigits; ++digits) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", digits, x);
    if (std::abs(std::atof(text) - x) <= 1e-14 * std::abs(x)) return digits;
  }
  return kMostDigits;
}

// --- what is asked ---

std::vector<words::Value> input_of(const Case& c) {
  std::vector<words::Value> all;
  for (const std::string& name : c.input) {
    const bool is_q = name[0] == 'q';
    const char* unit = is_q ? kConfiguration : kVelocity;
    if (name == "J") {
      all.push_back({name, rows(c.J), "1, 1, m"});
    } else {
      all.push_back({name, rows(is_q ? c.q : c.v), unit});
    }
  }
  return all;
}

std::vector<words::Value> values_of(const Parameters& p) {
  const auto one = [](double x) { return words::Rows{{x}}; };
  return {{"l", one(p.l), "m"},         {"m", one(p.m), "kg"},
          {"mu", one(p.mu), ""},        {"epsilon", one(p.epsilon), ""},
          {"g", rows(p.g), "m/s^2"},    {"dt", one(p.dt), "s"},
          {"delta", one(p.delta), "m"}, {"T", one(p.T), p.T == 1 ? "column" : "columns"}};
}

// The parameters that differ from the assignment's, which a reader needs to know.
std::vector<words::Value> others(const Parameters& params) {
  std::vector<words::Value> all = values_of(params), usual = values_of({}), other;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].rows != usual[i].rows) other.push_back(all[i]);
  }
  return other;
}

// --- on the way to the answer ---

words::OnTheWay value(const char* name, const char* unit, const Eigen::MatrixXd& m, int equation) {
  return {{name, rows(m), unit}, equation};
}

Vector3 v_free(const Case& c) { return c.v + c.params.dt * c.params.g; }

std::vector<words::OnTheWay> on_the_way_of_a_contact(const Contact& right) {
  const Eigen::Vector2d r(right.J(2, 1), -right.J(2, 0));
  return {value("r", "m", r, 5)};
}

std::vector<words::OnTheWay> on_the_way_of_an_lcp(const Case& c) {
  return {value("M's diagonal", "kg, kg, kg m^2", c.params.M().diagonal(), 1),
          value("v + dt M^-1 f_e", kVelocity, v_free(c), 10)};
}

std::vector<words::OnTheWay> on_the_way_of_a_step(Asker& asker, const Case& c) {
  const auto contact =
      frames::result<Contact>(asker.right_answer(frames::question(1, c.q, c.params)));
  std::vector<words::OnTheWay> all{
      value("phi", "m", Eigen::MatrixXd::Constant(1, 1, contact.phi), 4)};
  if (contact.phi < c.params.delta) {
    const auto lcp =
        frames::result<Lcp>(asker.right_answer(frames::question(2, contact.J, c.v, c.params)));
    all.push_back(value("J", "", contact.J, 6));
    all.push_back(value("p", "m/s, m/s, m/s, N", lcp.p, 10));
    all.push_back(value("(f_n, f_t1, f_t2)", "N", solve_lcp(lcp.V, lcp.p), 8));
  }
  all.push_back(value("v'", kVelocity, c.state.v, 13));
  return all;
}

// The state before the first wrong column, from which one step leads to it.
std::vector<words::OnTheWay> on_the_way_of_a_column(const Case& c, const std::string& quantity) {
  const int t = std::atoi(quantity.substr(quantity.find_last_of(' ') + 1).c_str());
  for (std::size_t i = 0; i < c.columns.size(); ++i) {
    if (c.columns[i] != t - 1) continue;
    const auto column = static_cast<Eigen::Index>(i);
    return {value("q before", kConfiguration, c.trajectory.q.col(column), 15),
            value("v before", kVelocity, c.trajectory.v.col(column), 15)};
  }
  return {};
}

std::vector<words::OnTheWay> on_the_way(Asker& asker, const Case& c, const std::string& quantity) {
  const int part = part_of(c);
  if (part == 1) return on_the_way_of_a_contact(c.contact);
  if (part == 2) return on_the_way_of_an_lcp(c);
  if (part == 4) return on_the_way_of_a_column(c, quantity);
  try {
    return on_the_way_of_a_step(asker, c);
  } catch (const std::runtime_error&) {  // it isn't recorded
    return {};
  }
}

}  // namespace

std::vector<Entry> numbers_in(Case& c) {
  Parameters& p = c.params;
  std::vector<Entry> all;
  const Parameters usual;
  for (double Parameters::*x : {&Parameters::l, &Parameters::m, &Parameters::mu,
                                &Parameters::epsilon, &Parameters::dt, &Parameters::delta})
    all.push_back({&(p.*x), usual.*x});
  for (Eigen::Index i = 0; i < 2; ++i) all.push_back({&p.g(i), usual.g(i)});
  for (const std::string& name : c.input) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      if (name == "J") {
        for (Eigen::Index j = 0; j < 2; ++j) all.push_back({&c.J(i, j), i == j ? 1.0 : 0.0});
      } else {
        all.push_back({name[0] == 'q' ? &c.q(i) : &c.v(i), 0, name[0] == 'q' && i == 2});
      }
    }
  }
  return all;
}

// An angle in degrees, where it is rounder there.
double as_written(const Entry& number) {
  const double x = *number.value, degrees = x / words::kDegree;
  return number.is_angle && digits_of(degrees) < digits_of(x) ? degrees : x;
}

// How many digits are written: 0.007 has three behind its point's zero, 100 has three.
int length_of(double x) {
  const int digits = digits_of(x), power = static_cast<int>(std::floor(std::log10(std::abs(x))));
  return digits + std::max({0, -1 - power, power + 1 - digits});
}

int digits_of(const Entry& number) { return digits_of(as_written(number)); }

Complexity complexity(Case c) {
  Complexity all{0, part_of(c) == 4 ? c.params.T : 0, 0};
  for (const Entry& number : numbers_in(c)) {
    if (*number.value == number.usual) continue;
    ++all[0];
    all[2] += length_of(as_written(number));
  }
  return all;
}

words::Question question_of(const Case& c) { return {input_of(c), others(c.params)}; }

words::Smallest smallest_of(Asker& asker, const Case& c, const Problem& problem) {
  const auto& [name, unit, expected, got] = problem.differences.at(0);
  return {{}, question_of(c), {name, rows(expected), unit}, rows(got), on_the_way(asker, c, name)};
}

}  // namespace bounce::tests
