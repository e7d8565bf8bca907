// The given part 3: another answers.
#include <bounce/part3_step.hpp>

#include "messages.hpp"

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  return frames::result<State>(runner::call_back(frames::question(3, params, q, v)));
}

}  // namespace bounce
