#include <bounce/part1_contacts.hpp>
#include <algorithm>
#include <array>
#include <complex>

namespace bounce {

namespace {

using Complex = std::complex<double>;
using Point = std::array<Complex, 2>;

// Position of corner (i, j) of the square, i and j = -1 or 1.
Point corner(const std::array<Complex, 3>& q, double l, int i, int j) {
  const Complex c = std::cos(q[2]);
  const Complex s = std::sin(q[2]);
  const double a = i * l / 2;
  const double b = j * l / 2;
  return {q[0] + c * a - s * b, q[1] + s * a + c * b};
}

}  // namespace

// J is the derivative of the corner's position by q. With an imaginary step nothing cancels, so
// the step can be tiny and the derivative is exact.
Contact get_contacts(const Vector3& q, const Parameters& params) {
  const std::array<Complex, 3> at = {q(0), q(1), q(2)};
  int i = -1, j = -1;
  for (int a : {-1, 1})
    for (int b : {-1, 1})
      if (corner(at, params.l, a, b)[1].real() < corner(at, params.l, i, j)[1].real()) i = a, j = b;

  Contact contact;
  contact.phi = corner(at, params.l, i, j)[1].real();
  const double h = 1e-100;
  for (std::size_t k = 0; k < 3; ++k) {
    auto moved = at;
    moved[k] += Complex(0, h);
    const Point p = corner(moved, params.l, i, j);
    contact.J(static_cast<int>(k), 0) = p[0].imag() / h;
    contact.J(static_cast<int>(k), 1) = p[1].imag() / h;
  }
  return contact;
}

}  // namespace bounce
