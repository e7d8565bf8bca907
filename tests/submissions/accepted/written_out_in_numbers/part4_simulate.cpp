#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

using namespace std;

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params)
{
    Trajectory tr;
    tr.q.resize(3, params.T);
    tr.v.resize(3, params.T);

    Vector3 q = q_0;
    Vector3 v = v_0;
    for (int i = 0; i < params.T; i++) {
        tr.q.col(i) = q;
        tr.v.col(i) = v;
        State s = step(q, v, params);
        q = s.q;
        v = s.v;
    }
    return tr;
}

}
