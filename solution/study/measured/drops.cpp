#include "drops.hpp"

#include <cmath>

#include "methods/assignment.hpp"

namespace bounce::measured {
namespace {

using methods::Arm;
using methods::Motion;

constexpr int kStepsPerSample = 40;            // 0.1 ms at 250 Hz
constexpr int kAssignmentSteps = 4;            // 1 ms
constexpr double kDelta = 1e-3, kFlat = 5e-4;  // m; what counts as both corners at once

class Drop {
 public:
  Drop(const World& world, const Motion<double>& start, std::string_view law, const Setting& with)
      : world_(world),
        s_(start),
        law_(law_named(law)),
        one_(law.starts_with("two_")
                 ? law_named(law == "two_frictionless" ? "frictionless" : "newton")
                 : law_),
        with_(with) {}

  void step(double dt) {
    s_.v_y -= dt * world_.g;
    const double kept = 1 - dt * world_.drag;
    s_.v_x *= kept;
    s_.v_y *= kept;
    s_.omega *= kept;
    for (int again = 0; again < 2; ++again) collide();
    s_.x += dt * s_.v_x;
    s_.y += dt * s_.v_y;
    s_.theta += dt * s_.omega;
  }

  const Motion<double>& motion() const { return s_; }

 private:
  double gap(const Arm<double>& r) const {
    return s_.y + r.y - world_.ground - world_.slope * (s_.x + r.x);
  }

  // The law answers at the deepest corner that approaches.
  void collide() {
    const double half = world_.side / 2;
    if (s_.y - world_.ground - world_.slope * s_.x > 1.5 * half) return;
    const auto r = methods::arms(half, std::cos(s_.theta), std::sin(s_.theta));
    int deepest = -1;
    for (int i = 0; i < 4; ++i) {
      const bool hits = gap(r[i]) <= 0 && methods::normal_velocity(s_, r[i]) < 0;
      if (hits && (deepest < 0 || gap(r[i]) < gap(r[deepest]))) deepest = i;
    }
    if (deepest < 0) return;
    const Arm<double>&before = r[(deepest + 3) % 4], &after = r[(deepest + 1) % 4];
    const Arm<double>& other = before.y < after.y ? before : after;
    const Impact hit{world_.gyration_squared, r[deepest], other, s_.v_x, s_.v_y, s_.omega, 0, 0, 0};
    const Velocity v = (gap(other) < kFlat ? law_ : one_)(hit, with_);
    s_.v_x = v.x, s_.v_y = v.y, s_.omega = v.omega;
  }

  const World world_;
  Motion<double> s_;
  const Law law_, one_;
  const Setting with_;
};

std::vector<Motion<double>> assignment_drop(const World& world, Motion<double> start,
                                            const Setting& with, int samples) {
  Parameters params;
  params.l = world.side;
  params.mu = with.mu;
  params.epsilon = with.epsilon;
  params.g = {0, -world.g, 0};
  params.dt = world.interval / kAssignmentSteps;
  params.delta = kDelta;
  const double ground = world.ground + world.slope * start.x;
  start.y -= ground;
  methods::Assignment scheme(params, start);
  std::vector<Motion<double>> poses;
  for (int i = 0; i < samples; ++i) {
    scheme.steps(kAssignmentSteps);
    poses.push_back(scheme.motion());
    poses.back().y += ground;
  }
  return poses;
}

}  // namespace

std::vector<Motion<double>> drop(const World& world, Motion<double> start, std::string_view law,
                                 const Setting& with, int samples) {
  if (law == "assignment") return assignment_drop(world, start, with, samples);
  Drop body(world, start, law, with);
  std::vector<Motion<double>> poses;
  for (int i = 0; i < samples; ++i) {
    for (int k = 0; k < kStepsPerSample; ++k) body.step(world.interval / kStepsPerSample);
    poses.push_back(body.motion());
  }
  return poses;
}

}  // namespace bounce::measured
