#include <bounce/part1_contacts.hpp>

#include <algorithm>
#include <complex>
#include <iterator>
#include <vector>

namespace bounce {

// Points of the plane as complex numbers: to turn is to multiply.
Contact get_contacts(const Vector3& q, const Parameters& params) {
  const std::vector<std::complex<double>> square = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  const std::complex<double> turn = std::polar(params.l / 2, q(2));

  std::vector<std::complex<double>> arms;
  std::transform(square.begin(), square.end(), std::back_inserter(arms),
                 [&](const std::complex<double>& s) { return turn * s; });
  const auto r = *std::min_element(arms.begin(), arms.end(),
                                   [](const auto& a, const auto& b) { return a.imag() < b.imag(); });

  Contact contact;
  contact.J << 1, 0, 0, 1, -r.imag(), r.real();
  contact.phi = q(1) + r.imag();
  return contact;
}

}  // namespace bounce
