#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <cstdlib>
#include <iostream>

using namespace std;

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params)
{
    double dt = params.dt;
    double m = params.m;
    double I = m * params.l * params.l / 6.0;

    Contact c = get_contacts(q, params);

    // gravity
    double Fx = m * params.g(0);
    double Fy = m * params.g(1);
    double Tq = I * params.g(2);

    bool touching = c.phi < params.delta;
    // set BOUNCE_DEBUG=1 to see the contacts
    if (touching && getenv("BOUNCE_DEBUG") != nullptr) {
        cerr << "contact, phi = " << c.phi << ", r = " << c.J(2,1) << " " << -c.J(2,0) << endl;
    }
    if (touching) {
        Lcp lcp = form_lcp(c.J, v, params);
        Vector3 f = solve_lcp(lcp.V, lcp.p);
        double fn = f(0);
        double ft = f(2) - f(1);
        Fx += c.J(0,1)*fn + c.J(0,0)*ft;
        Fy += c.J(1,1)*fn + c.J(1,0)*ft;
        Tq += c.J(2,1)*fn + c.J(2,0)*ft;
    }

    State s;
    s.v(0) = v(0) + dt*Fx/m;
    s.v(1) = v(1) + dt*Fy/m;
    s.v(2) = v(2) + dt*Tq/I;
    s.q(0) = q(0) + dt*s.v(0);
    s.q(1) = q(1) + dt*s.v(1);
    s.q(2) = q(2) + dt*s.v(2);
    if (touching) {
        s.q(1) += params.delta;
    }
    return s;
}

}
