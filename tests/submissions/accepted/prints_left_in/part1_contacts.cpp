#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <cstdio>
#include <iostream>

namespace bounce {

namespace {
struct Hello {
  Hello() { std::cout << "part 1 loaded" << std::endl; }
  ~Hello() { std::cout << "part 1 done" << std::endl; }
} hello;
}  // namespace

Contact get_contacts(const Vector3& q, const Parameters& params) {
  std::cout << "get_contacts: q = " << q.transpose() << "\n";
  const double h = params.l / 2;
  double r_x = 0, r_y = 0;
  for (int k = 0; k < 4; ++k) {
    const double s_x = k % 2 ? h : -h;
    const double s_y = k / 2 ? h : -h;
    const double x = std::cos(q(2)) * s_x - std::sin(q(2)) * s_y;
    const double y = std::sin(q(2)) * s_x + std::cos(q(2)) * s_y;
    printf("corner %d: %f %f\n", k, x, y);
    if (k == 0 || y < r_y) {
      std::cerr << "new lowest corner " << k << std::endl;
      r_x = x;
      r_y = y;
    }
  }
  Contact contact;
  contact.J << 1, 0, 0, 1, -r_y, r_x;
  contact.phi = q(1) + r_y;
  std::cout << "J =\n" << contact.J << "\nphi = " << contact.phi << std::endl;
  return contact;
}

}  // namespace bounce
