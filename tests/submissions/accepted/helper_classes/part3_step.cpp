#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

namespace {

class Stepper {
 public:
  Stepper(const Vector3& q, const Vector3& v, const Parameters& params)
      : q_(q), v_(v), params_(params), contact_(get_contacts(q, params)) {}

  bool touching() const { return contact_.phi < params_.delta; }

  State next() const {
    const Vector3 v = v_ + params_.dt * params_.M().inverse() * force();
    Vector3 q = q_ + params_.dt * v;
    if (touching()) q += Vector3(0, params_.delta, 0);
    return {q, v};
  }

 private:
  Vector3 force() const {
    Vector3 f = params_.M() * params_.g;
    if (touching()) f += ground();
    return f;
  }

  Vector3 ground() const {
    const Lcp lcp = form_lcp(contact_.J, v_, params_);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    return contact_.J.col(1) * f(0) + contact_.J.col(0) * (f(2) - f(1));
  }

  Vector3 q_;
  Vector3 v_;
  Parameters params_;
  Contact contact_;
};

}  // namespace

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  return Stepper(q, v, params).next();
}

}  // namespace bounce
