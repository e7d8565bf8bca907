// The submission is linked into the test program. The judge has another one of this file, which
// asks a runner in another process (grader/judge/submission_remote.cpp).
#include "../submission.hpp"

#include <exception>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>

#include "linked.hpp"

namespace bounce::submission {
namespace {

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

template <int part, class Result, class... Arguments, Result (*function)(Arguments...)>
Result Asked<part, function>::operator()(Arguments... arguments) const {
  const std::string name = "part " + std::to_string(part) + (part > 2 ? ", or what it calls," : "");
  Result got = ask(name, tests::linked<function>, arguments...);
  if constexpr (std::is_same_v<Result, Trajectory>) {
    require_columns(got.q.cols(), got.v.cols(), std::get<2>(std::tie(arguments...)).T);
  }
  return got;
}

#define BOUNCE_DEFINE(number, function) template struct Asked<number, &bounce::function>;
BOUNCE_FUNCTIONS(BOUNCE_DEFINE)

Trajectory first_columns(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  const Trajectory got = tests::linked<&bounce::simulate>(q_0, v_0, params);
  const Eigen::Index columns = columns_at_hand(got.q.cols(), got.v.cols(), params.T);
  return {got.q.leftCols(columns), got.v.leftCols(columns)};
}

}  // namespace bounce::submission
