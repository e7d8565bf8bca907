#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <cmath>
#include <stdexcept>

using namespace std;

namespace bounce {

// Lemke's method for w = V z + p. Throws when it ends in a ray.
static void lemke(const double V[4][4], const double p[4], double z[4])
{
    double T[4][10];    // w1..w4, z1..z4, artificial, right hand side
    int basis[4];
    int i, j, c;

    for (i = 0; i < 4; i++) z[i] = 0;
    int r = 0;
    for (i = 1; i < 4; i++) if (p[i] < p[r]) r = i;
    if (p[r] >= 0) return;

    for (i = 0; i < 4; i++) {
        for (j = 0; j < 4; j++) {
            T[i][j] = (i == j) ? 1.0 : 0.0;
            T[i][4+j] = -V[i][j];
        }
        T[i][8] = -1.0;
        T[i][9] = p[i];
        basis[i] = i;
    }

    int enter = 8;
    for (int it = 0; it < 100; it++) {
        // pivot on (r, enter)
        double d = T[r][enter];
        for (j = 0; j < 10; j++) T[r][j] /= d;
        for (i = 0; i < 4; i++) {
            if (i == r) continue;
            double f = T[i][enter];
            for (j = 0; j < 10; j++) T[i][j] -= f*T[r][j];
        }
        int leave = basis[r];
        basis[r] = enter;
        if (leave == 8) {
            for (i = 0; i < 4; i++)
                if (basis[i] >= 4) z[basis[i]-4] = T[i][9];
            return;
        }

        // the complement of the one that left enters next; lexicographic ratio test
        enter = leave < 4 ? leave + 4 : leave - 4;
        r = -1;
        for (i = 0; i < 4; i++) {
            if (T[i][enter] <= 1e-11) continue;
            if (r < 0) { r = i; continue; }
            int order[5] = { 9, 0, 1, 2, 3 };
            for (c = 0; c < 5; c++) {
                double a = T[i][order[c]]/T[i][enter];
                double b = T[r][order[c]]/T[r][enter];
                if (fabs(a - b) > 1e-13*(fabs(a) + fabs(b))) {
                    if (a < b) r = i;
                    break;
                }
            }
        }
        if (r < 0) throw runtime_error("ray");
        for (i = 0; i < 4; i++) {
            if (basis[i] != 8 || T[i][enter] <= 1e-11) continue;
            if (T[i][9]/T[i][enter] <= T[r][9]/T[r][enter]*(1 + 1e-13)) r = i;
        }
    }
    throw runtime_error("too many pivots");
}

static Vector3 forces(const Lcp& lcp)
{
    // scale the forces so that all numbers are of the size of velocities
    double unit = lcp.V(0,0);
    double V[4][4], p[4], z[4];
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            V[i][j] = lcp.V(i,j);
            if (i < 3 && j < 3) V[i][j] /= unit;
        }
        p[i] = lcp.p(i);
    }
    try {
        lemke(V, p, z);
        return Vector3(z[0]/unit, z[1]/unit, z[2]/unit);
    } catch (const runtime_error&) {
        return solve_lcp(lcp.V, lcp.p);     // mine got stuck, take the given one
    }
}

State step(const Vector3& q, const Vector3& v, const Parameters& params)
{
    double dt = params.dt;
    double m = params.m;
    double I = m * params.l * params.l / 6.0;
    Contact c = get_contacts(q, params);

    double Fx = m * params.g(0);
    double Fy = m * params.g(1);
    double Tq = I * params.g(2);
    double lift = 0;
    if (c.phi < params.delta) {
        Vector3 f = forces(form_lcp(c.J, v, params));
        double fn = f(0);
        double ft = f(2) - f(1);
        Fx += c.J(0,1)*fn + c.J(0,0)*ft;
        Fy += c.J(1,1)*fn + c.J(1,0)*ft;
        Tq += c.J(2,1)*fn + c.J(2,0)*ft;
        lift = params.delta;
    }

    State s;
    s.v << v(0) + dt*Fx/m, v(1) + dt*Fy/m, v(2) + dt*Tq/I;
    s.q << q(0) + dt*s.v(0), q(1) + dt*s.v(1) + lift, q(2) + dt*s.v(2);
    return s;
}

}  // namespace bounce
