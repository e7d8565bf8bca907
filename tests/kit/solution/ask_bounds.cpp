// Reads scenes from standard input, a line of 12 numbers each: l, mu, epsilon, g_x, g_y, x, y,
// theta, v_x, v_y, omega and until. Prints what simulate_to promises of the motion then: x, y,
// theta and the bound; or "refused".
#include <cstdio>
#include <iostream>

#include "exact/simulate_to.hpp"

int main() {
  using namespace bounce::study;
  constexpr double kTolerance = 1e-6;  // in sides
  Scene scene{};
  bounce::Parameters& p = scene.params;
  p.T = 2;
  auto &q = scene.start.q, &v = scene.start.v;
  while (std::cin >> p.l >> p.mu >> p.epsilon >> p.g(0) >> p.g(1) >> q(0) >> q(1) >> q(2) >> v(0) >>
         v(1) >> v(2) >> p.dt) {
    scene.until = p.dt;
    try {
      const Answer answer = simulate_to(scene, kTolerance * p.l);
      const auto& end = answer.motions.back();
      std::printf("%.17g %.17g %.17g %.3g\n", end.x, end.y, end.theta, answer.bound);
    } catch (const Refusal&) {
      std::puts("refused");
    }
  }
}
