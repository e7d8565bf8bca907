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
#include <iostream>
#include <limits>

#include "../study/page.hpp"
#include "../study/tables.hpp"

namespace bounce::real {
namespace {

using nlohmann::json;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSame = 1e-3;  // of the error: the table's numbers have five digits

// How far the velocity that follows from your form_lcp for a measured impact is off:
// sqrt(dv_x^2 + dv_y^2 + r_g^2 domega^2) with r_g^2 = l^2/6, the metric of the energy, m/s. Adds
// both to the impact. Infinite where solve_lcp finds no solution.
double answer(json& impact, const Parameters& params) {
  const double r_x = impact["r"][0], r_y = impact["r"][1];  // from the centre to the corner, m
  const Vector3 before = study::vector_of(impact["before"]);
  Jacobian J;
  J << 1, 0, 0, 1, -r_y, r_x;
  const Lcp lcp = form_lcp(J, before, params);
  Vector3 mine = Vector3::Constant(kInfinity);
  try {
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    const Eigen::Vector2d force(f(2) - f(1), f(0));  // along the ground, and away from it
    mine = before + params.dt * params.M().inverse() * J * force;
  } catch (const std::exception&) {
  }
  const Vector3 off = mine - study::vector_of(impact["after"]);
  const double error = std::sqrt(off.dot(params.M() * off) / params.m);
  impact["mine"] = {mine(0), mine(1), mine(2)};
  impact["error"] = error;
  return std::isfinite(error) ? error : kInfinity;
}

double median(std::vector<double> all) {
  std::sort(all.begin(), all.end());
  const std::size_t half = all.size() / 2;
  return all.size() % 2 ? all[half] : (all[half - 1] + all[half]) / 2;
}

// "0.0954 m/s": two laws that differ only in the third digit are told apart.
std::string speed(double metres_per_second) {
  return std::isfinite(metres_per_second) ? study::number(metres_per_second, "%#.3g") + " m/s"
                                          : "no answer";
}

// The laws stand in order: yours, the assignment's, others, and what no law gets below.
std::string sentence(const json& laws, const std::vector<double>& errors, bool is_wrong) {
  const double mine = laws[0]["error"], due = laws[1]["error"];
  const auto unsolved = std::count(errors.begin(), errors.end(), kInfinity);
  std::string text = "Over " + std::to_string(errors.size()) +
                     " measured impacts of a real square the velocity after is off, in the "
                     "median, by";
  for (const json& law : laws) {
    text += " " + std::string(law["label"]) + " (" + std::string(law["name"]) + "),";
  }
  text.back() = '.';
  if (unsolved > 0)
    return text + " For " + std::to_string(unsolved) +
           " of them solve_lcp finds no solution to your V and p.";
  if (std::abs(mine - due) > kSame * due)
    return text + (mine > due ? " What is more than the assignment's law comes from your program."
                              : " Yours isn't the assignment's law, and being nearer is luck.");
  return is_wrong ? text : text + " What is left is the error of the law, not of your program.";
}

// The page's data and the sentence in it: the measured ones with your answers.
json answered(json data, bool is_wrong) {
  Parameters params;
  params.g.setZero();      // an impact takes no time
  params.l = data["l"];    // of the square, m
  params.mu = data["mu"];  // both fitted to other impacts of the same square
  params.epsilon = data["epsilon"];
  std::vector<double> errors;
  for (json& impact : data["impacts"]) errors.push_back(answer(impact, params));
  json& laws = data["bars"];  // how far each is off, in the median over the impacts, m/s
  laws.insert(laws.begin(), json{{"name", "your form_lcp"}, {"error", median(errors)}});
  for (json& law : laws) law["label"] = speed(law["error"]);
  data["sentence"] = sentence(laws, errors, is_wrong);
  data["wrong"] = is_wrong;
  return data;
}

}  // namespace
}  // namespace bounce::real

int main(int argc, char** argv) {
  using namespace bounce;
  if (argc < 3) {
    std::cerr << "usage: real MEASURED PAGE [--wrong]; ./check --real starts it\n";
    return 2;
  }
  try {
    const nlohmann::json data = real::answered(study::read_json(argv[1]), argc > 3);
    check::write(argv[2], study::page_with("impacts.html", data));
    std::cout << std::string(data["sentence"]) << "\n";
  } catch (const std::exception& error) {
    std::cerr << "No page was written: " << error.what() << ".\n";
    return 1;
  }
  return 0;
}
