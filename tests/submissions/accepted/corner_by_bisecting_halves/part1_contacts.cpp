#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <utility>

namespace bounce {

using Corner = std::pair<double, double>;  // (height, x), so that the smaller pair is lower

static Corner lower(const Corner* first, const Corner* last) {
  if (last - first == 1) return *first;
  const Corner* middle = first + (last - first) / 2;
  const Corner a = lower(first, middle), b = lower(middle, last);
  return b < a ? b : a;
}

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double h = params.l * 0.5;
  const double u = h * (std::cos(q(2)) + std::sin(q(2))), w = h * (std::cos(q(2)) - std::sin(q(2)));
  // The corners are the vectors (u, -w) and (w, u), and their opposites.
  const Corner corners[] = {{u, w}, {-u, -w}, {-w, u}, {w, -u}};
  const auto [height, x] = lower(corners, corners + 4);

  Contact contact;
  contact.J.setZero();
  contact.J.diagonal().setOnes();
  contact.J.row(2) << -height, x;
  contact.phi = q(1) + height;
  return contact;
}

}  // namespace bounce
