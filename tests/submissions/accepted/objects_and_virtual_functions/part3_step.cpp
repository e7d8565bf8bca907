#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

#include <memory>

namespace bounce {

class Body {
 public:
  Body(const Vector3& q, const Vector3& v, const Parameters& params) : q_(q), v_(v), params_(params) {}
  virtual ~Body() = default;

  State next() const {
    const Vector3 v = v_ + params_.dt * params_.M().colPivHouseholderQr().solve(weight() + contactForce());
    return State{q_ + params_.dt * v + correction(), v};
  }

 protected:
  Vector3 weight() const { return params_.M() * params_.g; }
  virtual Vector3 contactForce() const = 0;
  virtual Vector3 correction() const = 0;

  Vector3 q_, v_;
  Parameters params_;
};

class FlyingBody : public Body {
 public:
  using Body::Body;

 protected:
  Vector3 contactForce() const override { return Vector3::Zero(); }
  Vector3 correction() const override { return Vector3::Zero(); }
};

class TouchingBody : public Body {
 public:
  TouchingBody(const Vector3& q, const Vector3& v, const Parameters& params, const Jacobian& J)
      : Body(q, v, params), J_(J) {}

 protected:
  Vector3 contactForce() const override {
    const Lcp lcp = form_lcp(J_, v_, params_);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    return J_.col(1) * f(0) - J_.col(0) * f(1) + J_.col(0) * f(2);
  }
  Vector3 correction() const override { return {0, params_.delta, 0}; }

 private:
  Jacobian J_;
};

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  std::unique_ptr<Body> body;
  if (contact.phi < params.delta) {
    body = std::make_unique<TouchingBody>(q, v, params, contact.J);
  } else {
    body = std::make_unique<FlyingBody>(q, v, params);
  }
  return body->next();
}

}  // namespace bounce
