#include <bounce/part1_contacts.hpp>
#include <bounce/part3_step.hpp>
#include <cmath>

namespace bounce {

namespace {

// Impulse (normal, tangential) of the contact. One corner, so all cases can be written down.
Eigen::Vector2d impulse(const Contact& contact, const Vector3& v, const Vector3& v_free, const Parameters& params) {
  const Vector3 J_t = contact.J.col(0);
  const Vector3 J_n = contact.J.col(1);
  const Eigen::Matrix3d W = params.M().inverse();
  const double a = J_n.dot(W * J_n);
  const double b = J_n.dot(W * J_t);
  const double c = J_t.dot(W * J_t);
  const double w_n = J_n.dot(v_free) + params.epsilon * J_n.dot(v);
  const double u_t = J_t.dot(v_free);

  // Case 1: the corner separates by itself.
  if (w_n >= 0) return {0, 0};

  // Case 2: it sticks, both equations hold: a P_n + b P_t = -w_n, b P_n + c P_t = -u_t.
  const double det = a * c - b * b;
  const double P_n = (-w_n * c + u_t * b) / det;
  const double P_t = (-u_t * a + w_n * b) / det;
  if (P_n >= 0 && std::abs(P_t) <= params.mu * P_n) return {P_n, P_t};

  // Case 3: it slides to the right and friction pushes to the left.
  const double right = -w_n / (a - params.mu * b);
  if (right >= 0 && u_t + b * right - c * params.mu * right >= 0) return {right, -params.mu * right};

  // Case 4: it slides to the left.
  const double left = -w_n / (a + params.mu * b);
  return {left, params.mu * left};
}

}  // namespace

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const Vector3 v_free = v + params.dt * params.g;
  if (contact.phi >= params.delta) return {q + params.dt * v_free, v_free};

  const Eigen::Vector2d P = impulse(contact, v, v_free, params);
  const Vector3 v_next = v_free + params.M().inverse() * (contact.J.col(1) * P(0) + contact.J.col(0) * P(1));
  return {q + params.dt * v_next + Vector3(0, params.delta, 0), v_next};
}

}  // namespace bounce
