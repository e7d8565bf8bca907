// The submission is linked into the test program. The judge has another one of this file, which
// asks a runner in another process (grader/judge/submission_remote.cpp).
#include "../submission.hpp"

#include <exception>
#include <stdexcept>
#include <string>

#include "linked.hpp"

namespace bounce {

tests::Linked& tests::linked() {
  static Linked functions;
  return functions;
}

namespace submission {
namespace {

using tests::linked;

// Returns what the function returns. Turns any exception of it into std::runtime_error, such as
// "part 1 threw an exception: oh", which says that it comes from the student's program.
template <class Function, class... Arguments>
auto ask(const std::string& part, Function function, const Arguments&... arguments) {
  try {
    return function(arguments...);
  } catch (const std::exception& thrown) {
    throw std::runtime_error(part + " threw an exception: " + thrown.what());
  } catch (const char* text) {
    throw std::runtime_error(part + " threw: " + text);
  } catch (const std::string& text) {
    throw std::runtime_error(part + " threw: " + text);
  } catch (...) {
    throw std::runtime_error(part + " threw something that isn't a std::exception");
  }
}

}  // namespace

Contact get_contacts(const Vector3& q, const Parameters& params) {
  return ask("part 1", linked().get_contacts, q, params);
}

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  return ask("part 2", linked().form_lcp, J, v, params);
}

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  return ask("part 3, or what it calls,", linked().step, q, v, params);
}

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  const Trajectory got = ask("part 4, or what it calls,", linked().simulate, q_0, v_0, params);
  require_columns(got.q.cols(), got.v.cols(), params.T);
  return got;
}

Trajectory first_columns(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  const Trajectory got = linked().simulate(q_0, v_0, params);
  const Eigen::Index columns = columns_at_hand(got.q.cols(), got.v.cols(), params.T);
  return {got.q.leftCols(columns), got.v.leftCols(columns)};
}

}  // namespace submission
}  // namespace bounce
