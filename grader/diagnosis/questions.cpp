#include <algorithm>
#include <fstream>

#include "findings.hpp"

namespace bounce::tests {
namespace {

// A number of a case, by its name in formulas.
double& number_of(Case& c, const std::string& name) {
  Parameters& p = c.params;
  const std::map<std::string, double*> numbers{
      {"l", &p.l},     {"m", &p.m},     {"mu", &p.mu},      {"epsilon", &p.epsilon},
      {"g0", &p.g(0)}, {"g1", &p.g(1)}, {"dt", &p.dt},      {"delta", &p.delta},
      {"x", &c.q(0)},  {"y", &c.q(1)},  {"theta", &c.q(2)}, {"v0", &c.v(0)},
      {"v1", &c.v(1)}, {"v2", &c.v(2)}};
  return *numbers.at(name);
}

// The case with each of these changes, "l = 1.25 l, m = 1.5 m & delta = 2 delta"; a name of a list
// stands for its alternatives.
Cases changed(const Case& base, const std::string& changes) {
  Cases cases{base};
  for (const std::string& change : split(changes, '&')) {
    Cases more;
    for (const Case& before : cases) {
      for (const Alternative& one : alternatives(change)) {
        Case& c = more.emplace_back(before);
        for (const std::string& number : split(one.formula, ',')) {
          const std::size_t at = number.find(" = ");
          number_of(c, number.substr(0, at)) = value_in(before, number.substr(at + 3));
        }
      }
    }
    cases = more;
  }
  return cases;
}

Cases those_of(const Row& row, const Cases& cases) {
  Cases found;
  for (const Case& c : cases) {
    if ((c.name + ", " + c.corner).find(row.at("cases")) != std::string::npos) found.push_back(c);
  }
  const std::size_t skip = row.count("skip"), most = std::stoul(row.at("most"));
  if (found.size() < skip + most) throw std::logic_error("too few cases: " + row.at("cases"));
  return {found.begin() + std::ptrdiff_t(skip), found.begin() + std::ptrdiff_t(skip + most)};
}

bool has_other_parameters(const Case& c) {
  const Parameters usual;
  return c.params.l != usual.l || c.params.m != usual.m;
}

}  // namespace

std::vector<Case> questions(int part) {
  std::ifstream in(public_file(part));
  Cases all = read_cases(in, false), others;
  const auto has_two_answers = [](const Case& c) { return c.other_J.has_value(); };
  all.erase(std::remove_if(all.begin(), all.end(), has_two_answers), all.end());
  const std::string block = "questions " + std::to_string(part);
  for (const Row& row : rows_of(block)) {
    for (const Case& base : those_of(row, all)) {
      for (const std::string& changes : split(row.at("ask"))) {
        for (const Case& c : changed(base, changes)) others.push_back(c);
      }
    }
  }
  std::stable_partition(all.begin(), all.end(), has_other_parameters);
  all.insert(all.end(), others.begin(), others.end());
  for (int again = part == 4 ? 1 : 4; again > 0; --again) {
    all.push_back(Case(all[static_cast<std::size_t>(again - 1)]));
  }
  return all;
}

}  // namespace bounce::tests
