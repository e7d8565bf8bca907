// Asks your form_lcp about measured impacts, and writes a page with how far it is off.
//
//   real MEASURED PAGE [--wrong]
//
// ./check --real builds and starts it. --wrong: checks of part 2 fail, and the page says so.
#include <algorithm>
#include <bounce/part2_lcp.hpp>
#include <bounce/solve_lcp.hpp>
#include <cmath>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "../study/page.hpp"
#include "pages.hpp"

namespace bounce::real {
namespace {

using nlohmann::json;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSame = 1e-3;  // of the error: the table's numbers have five digits

// An impact of one corner as it was measured; r points from the centre to the corner. And what
// follows from your form_lcp for it: v in m/s, m/s, rad/s; and how far that is off, in m/s, not
// finite where solve_lcp finds no solution.
struct Impact {
  double r_x, r_y;  // m
  Vector3 before, after;
  Vector3 mine = Vector3::Constant(kInfinity);
  double error = kInfinity;
};

// How far a law of impact is off, in the median over the impacts, m/s.
struct Law {
  std::string name;
  double error;
};

struct Measured {
  Parameters params;      // mu and epsilon fitted to other impacts of the same square
  std::vector<Law> laws;  // yours, part 2 by the course's solution, others, and the least of all
  std::vector<Impact> impacts;
};

// From fixtures/measured.txt.
Measured read_measured(const std::string& file) {
  std::ifstream in(file);
  Measured measured{{}, {{"your form_lcp", kInfinity}}, {}};
  measured.params.g.setZero();  // an impact takes no time
  Law least{"the least that any push at the corner leaves", 0};
  for (std::string text, kind; std::getline(in, text);) {
    std::istringstream line(text);
    line >> kind;
    if (kind == "square")
      line >> measured.params.l >> measured.params.mu >> measured.params.epsilon;
    if (kind == "floor") line >> least.error;
    if (kind == "assignment" || kind == "law") {
      Law law;
      std::getline(line >> law.error >> std::ws, law.name);
      measured.laws.push_back(law);
    }
    if (kind == "impact") {
      Impact hit{};
      line >> hit.r_x >> hit.r_y;
      for (double& x : hit.before) line >> x;
      for (double& x : hit.after) line >> x;
      measured.impacts.push_back(hit);
    }
  }
  if (measured.impacts.empty())
    throw std::runtime_error(file + " is missing: unpack the handout anew");
  measured.laws.push_back(least);
  return measured;
}

// The velocity that follows, and sqrt(dv_x^2 + dv_y^2 + r_g^2 domega^2) from the measured one, with
// r_g^2 = l^2/6: the metric of the energy.
void answer(Impact& hit, const Parameters& params) {
  Jacobian J;
  J << 1, 0, 0, 1, -hit.r_y, hit.r_x;
  const Lcp lcp = form_lcp(J, hit.before, params);
  Vector3 f;
  try {
    f = solve_lcp(lcp.V, lcp.p);
  } catch (const std::exception&) {
    return;
  }
  const Eigen::Vector2d force(f(2) - f(1), f(0));  // along the ground, and away from it
  hit.mine = hit.before + params.dt * params.M().inverse() * J * force;
  const Vector3 off = hit.mine - hit.after;
  hit.error = std::sqrt(off.dot(params.M() * off) / params.m);
  if (!std::isfinite(hit.error)) hit.error = kInfinity;
}

double median(const std::vector<Impact>& impacts) {
  std::vector<double> errors;
  for (const Impact& hit : impacts) errors.push_back(hit.error);
  std::sort(errors.begin(), errors.end());
  const std::size_t half = errors.size() / 2;
  return errors.size() % 2 ? errors[half] : (errors[half - 1] + errors[half]) / 2;
}

// "0.095 m/s"
std::string speed(double metres_per_second) {
  return std::isfinite(metres_per_second) ? study::number(metres_per_second, "%.2g") + " m/s"
                                          : "no answer";
}

// Each law behind what comes before it; the last is what no law gets below.
std::string sentence(const Measured& measured, bool is_wrong) {
  const auto& [params, laws, impacts] = measured;
  const double mine = laws[0].error, due = laws[1].error;
  const auto unsolved = std::count_if(impacts.begin(), impacts.end(),
                                      [](const Impact& hit) { return !std::isfinite(hit.error); });
  std::string text = "Over " + std::to_string(impacts.size()) +
                     " measured impacts of a real square the velocity after is off, in the "
                     "median, by";
  for (const Law& law : laws) text += " " + speed(law.error) + " (" + law.name + "),";
  text.back() = '.';
  if (unsolved > 0)
    return text + " For " + std::to_string(unsolved) +
           " of them solve_lcp finds no solution to your V and p.";
  if (std::abs(mine - due) > kSame * due)
    return text + (mine > due ? " What is more than the assignment's law comes from your program."
                              : " Yours isn't the assignment's law, and being nearer is luck.");
  return is_wrong ? text : text + " What is left is the error of the law, not of your program.";
}

json numbers(const Vector3& v) { return {v(0), v(1), v(2)}; }

json data(const Measured& measured, const std::string& sentence, bool is_wrong) {
  const auto& [params, laws, impacts] = measured;
  json data{{"wrong", is_wrong},
            {"l", params.l},
            {"mu", params.mu},
            {"epsilon", params.epsilon},
            {"sentence", sentence}};
  for (const Law& law : laws) {
    data["bars"].push_back({{"name", law.name}, {"error", law.error}, {"label", speed(law.error)}});
  }
  for (const Impact& hit : impacts) {
    data["impacts"].push_back({{"r", {hit.r_x, hit.r_y}},
                               {"before", numbers(hit.before)},
                               {"after", numbers(hit.after)},
                               {"mine", numbers(hit.mine)},
                               {"error", hit.error}});
  }
  return data;
}

}  // namespace
}  // namespace bounce::real

int main(int argc, char** argv) {
  using namespace bounce::real;
  if (argc < 3) {
    std::cerr << "usage: real MEASURED PAGE [--wrong]; ./check --real starts it\n";
    return 2;
  }
  try {
    Measured measured = read_measured(argv[1]);
    for (Impact& hit : measured.impacts) answer(hit, measured.params);
    measured.laws[0].error = median(measured.impacts);
    const std::string said = sentence(measured, argc > 3);
    bounce::study::write_page(argv[2], bounce::pages::impacts, data(measured, said, argc > 3));
    std::cout << said << "\n";
  } catch (const std::exception& error) {
    std::cerr << "No page was written: " << error.what() << ".\n";
    return 1;
  }
  return 0;
}
