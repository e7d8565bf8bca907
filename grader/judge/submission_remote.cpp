// Calls the submission in another process: each function that the tests call asks it a question.
#include "../../tests/parts/submission.hpp"

#include <bounce/part3_step.hpp>

#include "../runner/messages.hpp"
#include "session.hpp"

namespace bounce::submission {
namespace {

template <class Result, class... Arguments>
Result ask(std::uint32_t part, const Parameters& params, const Arguments&... arguments) {
  return frames::result<Result>(judge::session->ask(frames::question(part, params, arguments...)));
}

}  // namespace

Contact get_contacts(const Vector3& q, const Parameters& params) {
  return ask<Contact>(1, params, q);
}

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  return ask<Lcp>(2, params, J, v);
}

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  return judge::session->answers_for(3) ? bounce::step(q, v, params) : ask<State>(3, params, q, v);
}

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory trajectory;
  const auto answer = judge::session->ask(frames::question(4, params, q_0, v_0), &trajectory);
  require_columns(answer.q_columns, answer.v_columns, params.T);
  return trajectory;
}

Trajectory first_columns(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory trajectory;
  judge::session->ask(frames::question(4, params, q_0, v_0), &trajectory);
  return trajectory;
}

}  // namespace bounce::submission
