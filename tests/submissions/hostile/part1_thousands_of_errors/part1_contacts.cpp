#include <bounce/part1_contacts.hpp>

#define ERROR(n) int error_##n = undeclared_##n<<<;
#define TEN(n)                                                                          \
  ERROR(n##0) ERROR(n##1) ERROR(n##2) ERROR(n##3) ERROR(n##4) ERROR(n##5) ERROR(n##6) \
      ERROR(n##7) ERROR(n##8) ERROR(n##9)
#define HUNDRED(n) \
  TEN(n##0) TEN(n##1) TEN(n##2) TEN(n##3) TEN(n##4) TEN(n##5) TEN(n##6) TEN(n##7) TEN(n##8) TEN(n##9)

HUNDRED(10) HUNDRED(11) HUNDRED(12) HUNDRED(13) HUNDRED(14) HUNDRED(15)
HUNDRED(16) HUNDRED(17) HUNDRED(18) HUNDRED(19) HUNDRED(20) HUNDRED(21)
HUNDRED(22) HUNDRED(23) HUNDRED(24) HUNDRED(25) HUNDRED(26) HUNDRED(27)
HUNDRED(28) HUNDRED(29) HUNDRED(30) HUNDRED(31) HUNDRED(32) HUNDRED(33)
HUNDRED(34) HUNDRED(35) HUNDRED(36) HUNDRED(37) HUNDRED(38) HUNDRED(39)

namespace bounce {

Contact get_contacts(const Vector3&, const Parameters&) {
  return {Jacobian::Zero(), 0.0};
}

}  // namespace bounce
