// The submission runs in another process: each function of the tests is a question to it.
#include "../../tests/parts/submission.hpp"

#include "session.hpp"

namespace bounce::submission {
namespace {

template <class... Matrices>
frames::Frame question(std::uint32_t part, const Parameters& params, const Matrices&... arguments) {
  frames::Frame frame;
  frame.part = part;
  frames::put(params, frame);
  frames::put(frame, arguments...);
  return frame;
}

}  // namespace

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const frames::Frame answer = judge::session->ask(question(1, params, q));
  Contact contact;
  frames::take(answer, contact.J);
  contact.phi = answer.values[6];
  return contact;
}

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const frames::Frame answer = judge::session->ask(question(2, params, J, v));
  Lcp lcp;
  frames::take(answer, lcp.V, lcp.p);
  return lcp;
}

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const frames::Frame answer = judge::session->ask(question(3, params, q, v));
  State next;
  frames::take(answer, next.q, next.v);
  return next;
}

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory trajectory;
  const frames::Frame answer = judge::session->ask(question(4, params, q_0, v_0), &trajectory);
  require_columns(answer.q_columns, answer.v_columns, params.T);
  return trajectory;
}

Trajectory first_columns(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory trajectory;
  judge::session->ask(question(4, params, q_0, v_0), &trajectory);
  return trajectory;
}

}  // namespace bounce::submission
