// Part 3 in a program that judges part 4 with right earlier parts; beside before_part3_step.cpp.
#include <bounce/part3_step.hpp>

#include "given.hpp"

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const double* numbers = tests::given(3, params, q, v);
  return {Eigen::Map<const Vector3>(numbers), Eigen::Map<const Vector3>(numbers + 3)};
}

}  // namespace bounce
