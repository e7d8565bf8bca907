#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <bounce/render.hpp>
#include <numbers>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory out;
  out.q.resize(3, params.T);
  out.v.resize(3, params.T);
  out.q.col(0) = q_0;
  out.v.col(0) = v_0;
  for (int t = 0; t < params.T - 1; ++t) {
    State next = step(out.q.col(t), out.v.col(t), params);
    out.q.col(t + 1) = next.q;
    out.v.col(t + 1) = next.v;
  }
  return out;
}

}  // namespace bounce

int main() {
  using namespace bounce;
  const Parameters params;
  const Trajectory trajectory = simulate(Vector3(0, 1.5, std::numbers::pi / 6), Vector3(0, -0.2, 0), params);
  render(trajectory.q, params, "animation.html");
}
