#include <bounce/part1_contacts.hpp>
#include <bounce/part3_step.hpp>
#include <Eigen/LU>
#include <cmath>

namespace bounce {

// In the corner's two velocities: the impulse that stops it along the ground and sends it back
// upwards; if friction can't hold it, the largest friction along the ground in its place.
State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const Vector3 w = params.M().diagonal().cwiseInverse();
  const Vector3 free = v + params.dt * params.g;
  if (!(contact.phi < params.delta)) return {q + params.dt * free, free};

  const Eigen::Matrix2d A = contact.J.transpose() * w.asDiagonal() * contact.J;  // of (t, n)
  Eigen::Vector2d gap = contact.J.transpose() * free;
  gap(1) += params.epsilon * contact.J.col(1).dot(v);

  Eigen::Vector2d impulse = Eigen::Vector2d::Zero();
  if (gap(1) < 0) {
    impulse = -A.inverse() * gap;
    if (std::abs(impulse(0)) > params.mu * impulse(1)) {
      // Without any friction it would slide this way; friction never turns that round.
      const double slides = gap(0) - A(0, 1) / A(1, 1) * gap(1);
      const double sign = slides > 0 ? -1 : 1;
      impulse(1) = -gap(1) / (A(1, 1) + sign * params.mu * A(1, 0));
      impulse(0) = sign * params.mu * impulse(1);
    }
  }

  const Vector3 v_next = free + w.cwiseProduct(contact.J * impulse);
  return {q + params.dt * v_next + params.delta * Vector3::UnitY(), v_next};
}

}  // namespace bounce
