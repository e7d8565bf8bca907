// A program with switches: the slips that a student makes are chosen when it runs, so that
// thousands of programs are compiled once.
#pragma once
#include <bounce/types.hpp>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace slips {

using namespace bounce;

// The slips of the running program; every slip that was asked for is noted.
struct Program {
  std::set<std::string, std::less<>> slips;
  std::set<std::string, std::less<>> asked;
  std::map<std::string, Eigen::MatrixXd> kept;
  std::optional<Parameters> first_params;
};
Program& program();

inline bool slip(std::string_view name) {
  program().asked.emplace(name);
  return program().slips.contains(name);
}
inline double pick(std::string_view name, double wrong, double right) {
  return slip(name) ? wrong : right;
}

// The parameters as a part sees them that gets some of them from elsewhere: slips that every part
// may have. `names` has a letter for each that the part uses: l, m, u (mu), e (epsilon), g, d (dt),
// D (delta), T.
inline Parameters with_parameter_slips(const Parameters& given, std::string_view names) {
  Parameters p = given;
  const auto has = [&](char letter) { return names.find(letter) != names.npos; };
  if (slip("all constants at the top")) {
    const int T = given.T;
    p = Parameters{};
    if (!has('T')) p.T = T;
  }
  if (slip("parameters kept from the first call")) {
    if (!program().first_params) program().first_params = given;
    const int T = given.T;
    p = *program().first_params;
    if (!has('T')) p.T = T;
  }
  if (has('l')) {
    if (slip("l = 0.2 written down")) p.l = 0.2;
    if (slip("l = 0.4 written down")) p.l = 0.4;
    if (slip("l = 1 written down")) p.l = 1;
    if (slip("half side where the side is meant")) p.l = given.l / 2;
    if (slip("side where the half side is meant")) p.l = given.l * 2;
    if (slip("l is a float")) p.l = static_cast<float>(given.l);
    if (slip("l is an int")) p.l = static_cast<int>(given.l);
  }
  if (has('m')) {
    if (slip("m = 0.3 written down")) p.m = 0.3;
    if (slip("m = 1 written down")) p.m = 1;
    if (slip("m is an int")) p.m = std::max(1, static_cast<int>(given.m));
  }
  if (has('u')) {
    if (slip("mu = 0.3 written down")) p.mu = 0.3;
    if (slip("mu = 0.5 written down")) p.mu = 0.5;
    if (slip("mu = 0")) p.mu = 0;
    if (slip("mu is an int")) p.mu = static_cast<int>(given.mu);
    if (slip("epsilon where mu is meant")) p.mu = given.epsilon;
  }
  if (has('e')) {
    if (slip("epsilon = 0.5 written down")) p.epsilon = 0.5;
    if (slip("epsilon = 0.8 written down")) p.epsilon = 0.8;
    if (slip("epsilon = 1")) p.epsilon = 1;
    if (slip("epsilon is an int")) p.epsilon = static_cast<int>(given.epsilon);
    if (slip("mu where epsilon is meant")) p.epsilon = given.mu;
  }
  if (has('g')) {
    if (slip("g = (0, -9.81, 0) written down")) p.g = Vector3(0, -9.81, 0);
    if (slip("g = (0, -10, 0) written down")) p.g = Vector3(0, -10, 0);
    if (slip("g = (0, -9.8, 0) written down")) p.g = Vector3(0, -9.8, 0);
    if (slip("g points up")) p.g = -given.g;
    if (slip("g(1) alone")) p.g = Vector3(0, given.g(1), 0);
    if (slip("size of g downwards")) p.g = Vector3(0, -given.g.norm(), 0);
    if (slip("g = 0")) p.g = Vector3::Zero();
  }
  if (has('d')) {
    if (slip("dt = 0.01 written down")) p.dt = 0.01;
    if (slip("dt = 0.001 written down")) p.dt = 0.001;
    if (slip("dt is a float")) p.dt = static_cast<float>(given.dt);
  }
  if (has('D')) {
    if (slip("delta = 0.001 written down")) p.delta = 0.001;
    if (slip("delta = 0.01 written down")) p.delta = 0.01;
    if (slip("delta = 1e-6 written down")) p.delta = 1e-6;
  }
  if (has('T')) {
    if (slip("T = 150 written down")) p.T = 150;
    if (slip("T = 151")) p.T = given.T + 1;
    if (slip("T - 1 columns")) p.T = given.T - 1;
    if (slip("T / dt columns")) p.T = static_cast<int>(std::min(1e5, given.T / given.dt));
    if (slip("T * dt columns")) p.T = static_cast<int>(given.T * given.dt);
  }
  return p;
}

}  // namespace slips
