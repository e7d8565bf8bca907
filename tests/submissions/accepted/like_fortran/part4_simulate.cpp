#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce
{

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params)
{
  int i, t, n;
  Trajectory tr;
  State s;

  n = params.T;
  tr.q.resize(3, n);
  tr.v.resize(3, n);
  for (i = 0; i < 3; i++) {
    tr.q(i,0) = q_0(i);
    tr.v(i,0) = v_0(i);
  }
  s.q = q_0;
  s.v = v_0;
  for (t = 1; t < n; t++) {
    s = step(s.q, s.v, params);
    for (i = 0; i < 3; i++) {
      tr.q(i,t) = s.q(i);
      tr.v(i,t) = s.v(i);
    }
  }
  return tr;
}

}
