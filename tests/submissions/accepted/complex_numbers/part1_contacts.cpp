#include <bounce/part1_contacts.hpp>
#include <complex>

namespace bounce {

using Complex = std::complex<double>;

Contact get_contacts(const Vector3& q, const Parameters& params) {
  // points of the plane are complex numbers; a quarter turn is a factor i
  const Complex i(0.0, 1.0);
  Complex arm = params.l / 2 * Complex(1.0, 1.0) * std::polar(1.0, q(2));
  Complex r = arm;
  for (int k = 0; k < 3; ++k) {
    arm *= i;
    if (arm.imag() < r.imag()) r = arm;
  }

  // omega turns r with i * omega * r
  const Complex ir = i * r;
  Contact contact;
  contact.J << 1.0, 0.0,
               0.0, 1.0,
               ir.real(), ir.imag();
  contact.phi = q(1) + r.imag();
  return contact;
}

}  // namespace bounce
