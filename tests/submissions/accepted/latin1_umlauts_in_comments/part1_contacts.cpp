#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

// Höhe der tiefsten Ecke über dem Boden und ihre Jacobimatrix (für Teil 2)
Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double a = params.l / 2;  // halbe Seitenlänge
  const double winkel = q(2);

  double tiefste = 1e9, hebel_x = 0, hebel_y = 0;
  for (int i = -1; i <= 1; i += 2) {
    for (int j = -1; j <= 1; j += 2) {
      const double rx = a * (i * std::cos(winkel) - j * std::sin(winkel));
      const double ry = a * (i * std::sin(winkel) + j * std::cos(winkel));
      if (ry < tiefste) {  // größer oder gleich geht auch
        tiefste = ry;
        hebel_x = rx;
        hebel_y = ry;
      }
    }
  }

  Contact ergebnis;
  ergebnis.J << 1, 0, 0, 1, -hebel_y, hebel_x;
  ergebnis.phi = q(1) + tiefste;
  return ergebnis;
}

}  // namespace bounce
