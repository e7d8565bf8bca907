#include <bounce/part2_lcp.hpp>

using namespace std;

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params)
{
    double dt = params.dt;
    double im = 1.0 / params.m;                             // inverse mass
    double iI = 6.0 / (params.m * params.l * params.l);     // inverse inertia

    double tx = J(0,0), ty = J(1,0), ta = J(2,0);
    double nx = J(0,1), ny = J(1,1), na = J(2,1);

    double nn = nx*nx*im + ny*ny*im + na*na*iI;
    double nt = nx*tx*im + ny*ty*im + na*ta*iI;
    double tt = tx*tx*im + ty*ty*im + ta*ta*iI;

    Lcp out;
    out.V(0,0) =  nn*dt;  out.V(0,1) = -nt*dt;  out.V(0,2) =  nt*dt;  out.V(0,3) = 0;
    out.V(1,0) = -nt*dt;  out.V(1,1) =  tt*dt;  out.V(1,2) = -tt*dt;  out.V(1,3) = 1;
    out.V(2,0) =  nt*dt;  out.V(2,1) = -tt*dt;  out.V(2,2) =  tt*dt;  out.V(2,3) = 1;
    out.V(3,0) = params.mu;  out.V(3,1) = -1;   out.V(3,2) = -1;      out.V(3,3) = 0;

    double vn = nx*v(0) + ny*v(1) + na*v(2);
    double vt = tx*v(0) + ty*v(1) + ta*v(2);
    double gn = nx*params.g(0) + ny*params.g(1) + na*params.g(2);
    double gt = tx*params.g(0) + ty*params.g(1) + ta*params.g(2);

    out.p(0) = (1.0 + params.epsilon)*vn + dt*gn;
    out.p(1) = -(vt + dt*gt);
    out.p(2) = vt + dt*gt;
    out.p(3) = 0;
    return out;
}

}
