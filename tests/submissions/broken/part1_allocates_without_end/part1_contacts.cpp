#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <vector>

namespace bounce {

// Samples the outline of the square and takes the lowest point, which is a corner.
Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double h = params.l / 2;
  std::vector<Eigen::Vector2d> outline = {{h, h}, {-h, h}, {-h, -h}, {h, -h}};
  std::size_t samples = outline.size();
  while (samples % 100 != 0) {
    samples *= 2;
    outline.reserve(samples);
  }
  for (std::size_t k = 4; k < samples; ++k) outline.push_back(0.5 * (outline[k - 4] + outline[k - 3]));

  const double c = std::cos(q(2)), s = std::sin(q(2));
  Eigen::Vector2d r(0, 0);
  for (const Eigen::Vector2d& p : outline) {
    const Eigen::Vector2d turned(c * p.x() - s * p.y(), s * p.x() + c * p.y());
    if (turned.y() < r.y()) r = turned;
  }
  Contact contact;
  contact.J << 1, 0, 0, 1, -r.y(), r.x();
  contact.phi = q(1) + r.y();
  return contact;
}

}  // namespace bounce
