#include "random_contacts.hpp"

#include <limits>
#include <utility>

namespace bounce::tests {
namespace {

// The lowest of the four corners at this angle, eqs. (3) to (5).
void turn(Scene& scene, double theta) {
  const double x = scene.params.l / 2 * (std::cos(theta) - std::sin(theta));
  const double y = scene.params.l / 2 * (std::cos(theta) + std::sin(theta));
  scene.r_y = std::numeric_limits<double>::infinity();
  for (const auto& [r_x, r_y] : {std::pair{x, y}, {-y, x}, {-x, -y}, {y, -x}})
    if (r_y < scene.r_y) scene.r_x = r_x, scene.r_y = r_y;
}

// Components of v that are nothing or nearly so, and corners that graze or hardly slide.
void make_degenerate(Random& random, Scene& scene) {
  Vector3& v = scene.v;
  for (double& component : v)
    if (random.one_in(4)) component *= random.one_in(2) ? 0.0 : random.logarithmic(1e-18, 1.0);
  const double tiny = random.one_in(2) ? 0.0 : random.logarithmic(1e-18, 1e-3);
  if (random.one_in(2)) v.y() = -scene.r_x * v.z() - tiny;
  if (random.one_in(2)) v.x() = scene.r_y * v.z() + tiny;
}

double any_friction(Random& random) {
  if (random.one_in(8)) return 0.0;
  return random.one_in(8) ? random.logarithmic(1e-16, 1.3) : random.uniform(0.0, 1.3);
}

Vector3 any_gravity(Random& random) {
  if (random.one_in(2)) return {0.0, -9.81, 0.0};
  return {random.uniform(-10.0, 10.0), random.uniform(-10.0, 10.0), 0.0};
}

// A quarter of the squares stands on a corner or lies flat, to rounding.
Scene any_scene(Random& random, double m, double dt) {
  const double l = random.logarithmic(1e-3, 50.0), spin = random.one_in(8) ? 100.0 : 5.0;
  const double epsilon = random.one_in(4) ? random.integer(0, 1) : random.uniform(0.0, 1.0);
  const double v_x = random.uniform(-5.0, 5.0), v_y = random.uniform(-5.0, 5.0);
  const Vector3 v(v_x, v_y, random.uniform(-spin, spin) / l);
  const double mu = any_friction(random);
  Scene scene{0.0, 0.0, v, Parameters{l, m, mu, epsilon, any_gravity(random), dt}};
  const double eighth = std::atan(1.0);
  turn(scene, random.one_in(4) ? random.integer(-8, 8) * eighth : random.uniform(-10.0, 10.0));
  if (random.one_in(4)) make_degenerate(random, scene);
  return scene;
}

}  // namespace

Scene any_scene(Random& random) {
  const double m = random.logarithmic(1e-2, 1e2);
  return any_scene(random, m, random.logarithmic(1e-4, 1e-1));
}

Scene extreme_scene(Random& random) {
  const double m = random.logarithmic(1e-9, 1e9);
  return any_scene(
      random, m,
      random.one_in(2) ? random.logarithmic(1e-6, 1.0) : m * random.logarithmic(1e-12, 1e3));
}

Numbers numbers(const Scene& scene) {
  const Parameters& params = scene.params;
  const double x = scene.r_x, y = scene.r_y;
  const double per_mass = params.dt / params.m, s = 6.0 / (params.l * params.l);
  const Vector3 &v = scene.v, pull = params.dt * params.g;
  return {per_mass * (1.0 + s * x * x),
          -per_mass * s * x * y,
          per_mass * (1.0 + s * y * y),
          (1.0 + params.epsilon) * (v.y() + x * v.z()) + pull.y() + x * pull.z(),
          v.x() - y * v.z() + pull.x() - y * pull.z(),
          params.mu};
}

Lcp form(const Numbers& n) {
  Lcp lcp;
  lcp.V << n.a, -n.b, n.b, 0.0, -n.b, n.c, -n.c, 1.0, n.b, -n.c, n.c, 1.0, n.mu, -1.0, -1.0, 0.0;
  lcp.p << n.u_n, -n.u_t, n.u_t, 0.0;
  return lcp;
}

}  // namespace bounce::tests
