#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <vector>

namespace bounce {

namespace {
std::vector<Eigen::Vector2d> arms(double theta, double l) {
  std::vector<Eigen::Vector2d> result;
  const double c = std::cos(theta), s = std::sin(theta);
  for (double x : {-l / 2, l / 2})
    for (double y : {-l / 2, l / 2})
      result.emplace_back(c * x - s * y, s * x + c * y);
  return result;
}
}  // namespace

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const auto all = arms(q(2), params.l);
  std::size_t best = 0;
  for (std::size_t k = 1; k < all.size(); ++k)
    if (all[k].y() < all[best].y()) best = k;

  const Vector3 J_t(1, 0, all[best].y());
  const Vector3 J_n(0, 1, all[best].x());
  Contact out;
  out.J << J_t, J_n;
  out.phi = q(1) + all[best].y();
  return out;
}

}  // namespace bounce
