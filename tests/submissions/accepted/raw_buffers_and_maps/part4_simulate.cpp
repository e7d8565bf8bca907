#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <cstring>
#include <memory>

using namespace std;

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params)
{
    int T = params.T;
    unique_ptr<double[]> buffer(new double[6*T]);
    double* qs = buffer.get();
    double* vs = buffer.get() + 3*T;
    memcpy(qs, q_0.data(), 3*sizeof(double));
    memcpy(vs, v_0.data(), 3*sizeof(double));

    for (int i = 1; i < T; i++) {
        Eigen::Map<Vector3> q(qs + 3*(i-1));
        Eigen::Map<Vector3> v(vs + 3*(i-1));
        State s = step(q, v, params);
        memcpy(qs + 3*i, s.q.data(), 3*sizeof(double));
        memcpy(vs + 3*i, s.v.data(), 3*sizeof(double));
    }

    Trajectory tr;
    tr.q = Eigen::Map<Eigen::Matrix3Xd>(qs, 3, T);
    tr.v = Eigen::Map<Eigen::Matrix3Xd>(vs, 3, T);
    return tr;
}

}
