#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

using namespace std;

namespace bounce {

typedef long double real;

State step(const Vector3& q, const Vector3& v, const Parameters& params)
{
    Contact c = get_contacts(q, params);
    real dt = params.dt;
    real M[3] = { params.m, params.m, (real)params.m * params.l * params.l / 6 };
    real F[3] = { M[0]*params.g(0), M[1]*params.g(1), M[2]*params.g(2) };

    bool touching = c.phi < params.delta;
    if (touching) {
        Lcp lcp = form_lcp(c.J, v, params);
        Vector3 f = solve_lcp(lcp.V, lcp.p);
        for (int k = 0; k < 3; k++) {
            F[k] += (real)c.J(k,1)*f(0) + (real)c.J(k,0)*((real)f(2) - (real)f(1));
        }
    }

    State s;
    for (int k = 0; k < 3; k++) {
        real vk = v(k) + dt*F[k]/M[k];
        real qk = q(k) + dt*vk;
        if (touching && k == 1) qk += params.delta;
        s.v(k) = (double)vk;
        s.q(k) = (double)qk;
    }
    return s;
}

}
