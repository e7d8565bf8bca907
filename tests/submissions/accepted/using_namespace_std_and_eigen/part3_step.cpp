#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
using namespace std;
using namespace Eigen;

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  auto [J, phi] = get_contacts(q, params);
  Vector3d f = params.M() * params.g, lift = Vector3d::Zero();
  if (phi < params.delta) {
    auto [V, p] = form_lcp(J, v, params);
    Vector3d z = solve_lcp(V, p);
    f += J.col(1) * z(0) - J.col(0) * z(1) + J.col(0) * z(2);
    lift(1) = params.delta;
  }
  Vector3d v1 = v + params.dt * params.M().inverse() * f;
  return {q + params.dt * v1 + lift, v1};
}

}
