#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <memory>

namespace bounce {

namespace {

class Motion {
 public:
  Motion(const Vector3& v, const Parameters& params) : v_(v), params_(params) {}
  virtual ~Motion() = default;
  virtual Vector3 force() const { return params_.M() * params_.g; }
  virtual Vector3 correction() const { return Vector3::Zero(); }

 protected:
  Vector3 v_;
  Parameters params_;
};

class Bounce : public Motion {
 public:
  Bounce(const Jacobian& J, const Vector3& v, const Parameters& params) : Motion(v, params), J_(J) {}

  Vector3 force() const override {
    const Lcp lcp = form_lcp(J_, v_, params_);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    return Motion::force() + J_.col(1) * f(0) - J_.col(0) * f(1) + J_.col(0) * f(2);
  }

  Vector3 correction() const override { return Vector3(0, params_.delta, 0); }

 private:
  Jacobian J_;
};

std::unique_ptr<Motion> motion(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  if (contact.phi < params.delta) return std::make_unique<Bounce>(contact.J, v, params);
  return std::make_unique<Motion>(v, params);
}

}  // namespace

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const std::unique_ptr<Motion> now = motion(q, v, params);
  const Vector3 a = params.M().inverse() * now->force();
  const Vector3 v_next = v + params.dt * a;
  const Vector3 q_next = q + params.dt * v_next + now->correction();
  return {q_next, v_next};
}

}  // namespace bounce
