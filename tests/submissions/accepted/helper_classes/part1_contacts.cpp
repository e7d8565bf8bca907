#include <bounce/part1_contacts.hpp>
#include <array>
#include <cmath>

namespace bounce {

namespace {

class Square {
 public:
  Square(const Vector3& q, double side) : centre_(q.head<2>()), angle_(q(2)), side_(side) {
    const double h = side_ / 2;
    corners_[0] = corner(h, h);
    corners_[1] = corner(-h, h);
    corners_[2] = corner(-h, -h);
    corners_[3] = corner(h, -h);
  }

  const Eigen::Vector2d& lowest() const {
    int best = 0;
    for (int k = 1; k < 4; ++k) {
      if (corners_[k].y() < corners_[best].y()) best = k;
    }
    return corners_[best];
  }

  Eigen::Vector2d arm() const { return lowest() - centre_; }

  Jacobian jacobian() const {
    const Eigen::Vector2d r = arm();
    Jacobian J;
    J.col(0) << 1, 0, -r.y();
    J.col(1) << 0, 1, r.x();
    return J;
  }

 private:
  Eigen::Vector2d corner(double a, double b) const {
    return centre_ + Eigen::Vector2d(std::cos(angle_) * a - std::sin(angle_) * b,
                                     std::sin(angle_) * a + std::cos(angle_) * b);
  }

  Eigen::Vector2d centre_;
  double angle_;
  double side_;
  std::array<Eigen::Vector2d, 4> corners_;
};

}  // namespace

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const Square square(q, params.l);
  return {square.jacobian(), square.lowest().y()};
}

}  // namespace bounce
