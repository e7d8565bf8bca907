#include <bounce/part2_lcp.hpp>

using namespace std;

namespace bounce {

typedef long double real;
typedef Eigen::Matrix<real, 3, 1> Vec;

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params)
{
    real dt = params.dt;
    real m = params.m;
    real l = params.l;
    Vec Minv(1/m, 1/m, 6/(m*l*l));
    Vec n = J.col(1).cast<real>();
    Vec t = J.col(0).cast<real>();
    Vec u = v.cast<real>();
    Vec g = params.g.cast<real>();

    real nn = dt * n.dot(Minv.cwiseProduct(n));
    real nt = dt * n.dot(Minv.cwiseProduct(t));
    real tt = dt * t.dot(Minv.cwiseProduct(t));
    real pn = (1 + (real)params.epsilon) * n.dot(u) + dt * n.dot(g);
    real pt = t.dot(u) + dt * t.dot(g);

    Eigen::Matrix<real, 4, 4> V;
    V << nn, -nt, nt, 0,
         -nt, tt, -tt, 1,
         nt, -tt, tt, 1,
         params.mu, -1, -1, 0;
    Eigen::Matrix<real, 4, 1> p(pn, -pt, pt, 0);

    Lcp out;
    out.V = V.cast<double>();
    out.p = p.cast<double>();
    return out;
}

}
