// Calls the submission in another process: each function that the tests call asks it a question.
#include "../../tests/parts/submission.hpp"

#include <type_traits>

#include "../runner/messages.hpp"
#include "session.hpp"

namespace bounce::submission {

using frames::Frame;

template <int part, class Result, class... Arguments, Result (*function)(Arguments...)>
Result Asked<part, function>::operator()(Arguments... arguments) const {
  if (judge::session->answers_for(part)) return function(arguments...);
  const Frame question = frames::question(part, arguments...);
  Trajectory trajectory;
  if constexpr (std::is_same_v<Result, Trajectory>) {
    const Frame answer = judge::session->ask(question, &trajectory);
    require_columns(answer.q_columns, answer.v_columns, static_cast<int>(question.T));
    return trajectory;
  } else {
    return frames::result<Result>(judge::session->ask(question));
  }
}

#define BOUNCE_DEFINE(number, function) template struct Asked<number, &bounce::function>;
BOUNCE_FUNCTIONS(BOUNCE_DEFINE)

Trajectory first_columns(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory trajectory;
  judge::session->ask(frames::question(4, q_0, v_0, params), &trajectory);
  return trajectory;
}

}  // namespace bounce::submission
