#include "cases.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

namespace bounce::tests {
namespace {

using json = nlohmann::ordered_json;  // checks in the order of the file

double largest_error_so_far = 0;

// --- reading ---

template <class Matrix>
Matrix matrix(const json& rows) {
  Matrix m;
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    for (Eigen::Index j = 0; j < m.cols(); ++j) {
      const auto& row = rows.at(static_cast<std::size_t>(i));
      m(i, j) = (m.cols() == 1 ? row : row.at(static_cast<std::size_t>(j))).template get<double>();
    }
  }
  return m;
}

Eigen::Matrix3Xd columns(const json& list) {
  Eigen::Matrix3Xd m(3, static_cast<Eigen::Index>(list.size()));
  for (Eigen::Index j = 0; j < m.cols(); ++j) {
    m.col(j) = matrix<Vector3>(list.at(static_cast<std::size_t>(j)));
  }
  return m;
}

Parameters read_parameters(const json& p) {
  return {p.at("l"),  p.at("m"),     p.at("mu"), p.at("epsilon"), matrix<Vector3>(p.at("g")),
          p.at("dt"), p.at("delta"), p.at("T")};
}

void read_expected(const json& expected, Case& c) {
  if (expected.contains("phi")) c.contact = {matrix<Jacobian>(expected.at("J")), expected["phi"]};
  if (expected.contains("other_J")) c.other_J = matrix<Jacobian>(expected["other_J"]);
  if (expected.contains("V")) {
    c.lcp = {matrix<Eigen::Matrix4d>(expected["V"]), matrix<Eigen::Vector4d>(expected.at("p"))};
  }
  c.has_decidable_steps = expected.contains("steps");
  if (expected.contains("columns")) {
    c.columns = expected["columns"].get<std::vector<int>>();
    c.trajectory = {columns(expected.at("q")), columns(expected.at("v"))};
  } else if (expected.contains("v")) {
    c.state = {matrix<Vector3>(expected.at("q")), matrix<Vector3>(expected["v"])};
  }
}

// --- comparing ---

double error(double expected, double got) {
  if (!std::isfinite(got)) return INFINITY;
  return std::abs(got - expected) / std::max(1.0, std::abs(expected));
}

void read_input(const json& input, Case& c) {
  for (const auto& [key, value] : input.items()) {
    c.input.push_back(key);
    if (key == "J") {
      c.J = matrix<Jacobian>(value);
    } else {
      (key[0] == 'q' ? c.q : c.v) = matrix<Vector3>(value);
    }
  }
}

Case read_case(const json& from, const std::string& check, bool hidden) {
  Case c;
  c.check = check;
  c.name = from.at("name");
  c.corner = from.value("contact", "");
  c.hidden = hidden;
  c.tolerance = from.at("tolerance");
  c.params = read_parameters(from.at("params"));
  read_input(from.at("input"), c);
  read_expected(from.at("expected"), c);
  return c;
}

// Caches each file, since all checks of a part are in the same files.
const std::vector<Case>& cases_in(const std::filesystem::path& file) {
  static std::map<std::filesystem::path, std::vector<Case>> read;
  auto known = read.find(file);
  if (known == read.end()) {
    std::ifstream in(file);
    const bool hidden = file.parent_path().filename() == "hidden";
    known = read.emplace(file, read_cases(in, hidden)).first;
  }
  return known->second;
}

}  // namespace

std::vector<Case> read_cases(std::istream& file, bool hidden) {
  std::vector<Case> cases;
  const json all = json::parse(file);
  for (const auto& [check, of_check] : all.at("checks").items()) {
    for (const json& c : of_check) cases.push_back(read_case(c, check, hidden));
  }
  return cases;
}

std::vector<Case> cases_of(const std::string& check) {
  std::vector<Case> cases;
  for (const auto& folder : fixture_folders) {
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
      if (file.path().filename().string().rfind(check.substr(0, check.find('.')), 0) != 0) continue;
      for (const Case& c : cases_in(file.path())) {
        if (c.check == check) cases.push_back(c);
      }
    }
  }
  if (cases.empty()) throw std::logic_error("the fixtures hold no case of " + check);
  return cases;
}

Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> agrees(const Case& c,
                                                          const Eigen::MatrixXd& expected,
                                                          const Eigen::MatrixXd& got) {
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> right(got.rows(), got.cols());
  for (Eigen::Index i = 0; i < got.size(); ++i) {
    right(i) = error(expected(i), got(i)) <= c.tolerance;
  }
  return right;
}

Problem compare(const Case& c, const std::string& name, const std::string& unit,
                const Eigen::MatrixXd& expected, const Eigen::MatrixXd& got) {
  double worst = 0;
  for (Eigen::Index i = 0; i < got.size(); ++i) {
    worst = std::max(worst, error(expected(i), got(i)));
  }
  if (!c.hidden) largest_error_so_far = std::max(largest_error_so_far, worst);
  if (worst <= c.tolerance) return {};
  return {"", {{name, unit, expected, got}}};
}

Problem compare(const Case& c, const std::string& name, const std::string& unit, double expected,
                double got) {
  return compare(c, name, unit, Eigen::MatrixXd::Constant(1, 1, expected),
                 Eigen::MatrixXd::Constant(1, 1, got));
}

Problem both(const Problem& a, const Problem& b) {
  Problem problem = a;
  problem.differences.insert(problem.differences.end(), b.differences.begin(), b.differences.end());
  return problem;
}

double largest_error() { return largest_error_so_far; }

}  // namespace bounce::tests
