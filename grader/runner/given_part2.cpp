// The given part 2: another answers.
#include <bounce/part2_lcp.hpp>

#include "messages.hpp"

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  return frames::result<Lcp>(runner::ask_earlier_part(frames::question(2, params, J, v)));
}

}  // namespace bounce
