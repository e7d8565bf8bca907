#include <bounce/part2_lcp.hpp>

namespace bounce {

namespace {

class ContactProblem {
 public:
  ContactProblem(const Jacobian& J, const Parameters& params) : params_(params) {
    J_hat_.col(0) = J.col(1);
    J_hat_.col(1) = -J.col(0);
    J_hat_.col(2) = J.col(0);
    M_inv_ = params_.M().inverse();
    f_e_ = params_.M() * params_.g;
  }

  Eigen::Matrix4d matrix() const {
    Eigen::Matrix4d V = Eigen::Matrix4d::Zero();
    V.block<3, 3>(0, 0) = J_hat_.transpose() * M_inv_ * J_hat_ * params_.dt;
    V(1, 3) = 1;
    V(2, 3) = 1;
    V(3, 0) = params_.mu;
    V(3, 1) = -1;
    V(3, 2) = -1;
    return V;
  }

  Eigen::Vector4d vector(const Vector3& v) const {
    const Vector3 kick = params_.dt * M_inv_ * f_e_;
    Eigen::Vector4d p = Eigen::Vector4d::Zero();
    p(0) = J_hat_.col(0).dot((1 + params_.epsilon) * v + kick);
    p(1) = J_hat_.col(1).dot(v + kick);
    p(2) = J_hat_.col(2).dot(v + kick);
    return p;
  }

 private:
  const Parameters& params_;
  Eigen::Matrix3d J_hat_;
  Eigen::Matrix3d M_inv_;
  Vector3 f_e_;
};

}  // namespace

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const ContactProblem problem(J, params);
  return {problem.matrix(), problem.vector(v)};
}

}  // namespace bounce
