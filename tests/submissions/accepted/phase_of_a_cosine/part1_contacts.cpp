#include <bounce/part1_contacts.hpp>
#include <algorithm>
#include <complex>
#include <vector>

namespace bounce {

// The corners are at R e^(i (theta + pi/4 + k pi/2)). Seen from the direction of -i, the lowest has
// the largest cosine.
Contact get_contacts(const Vector3& q, const Parameters& params) {
  using Complex = std::complex<double>;
  const Complex i(0, 1), start = params.l / 2 * Complex(1, 1) * std::exp(i * q(2));
  const std::vector<Complex> corners{start, i * start, -start, -i * start};
  const auto cosine = [&](Complex r) { return std::cos(std::arg(r / -i)); };
  const Complex r = *std::max_element(corners.begin(), corners.end(), [&](Complex a, Complex b) {
    return cosine(a) < cosine(b);
  });

  Jacobian J;
  J << 1, 0, 0, 1, -r.imag(), r.real();
  return {J, q(1) + r.imag()};
}

}  // namespace bounce
