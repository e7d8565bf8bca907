#include <bounce/part2_lcp.hpp>
#include <cstring>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params)
{
	double Jh[3][3];
	double Minv[3] = { 1 / params.m, 1 / params.m, 6 / (params.m * params.l * params.l) };
	double V[4][4];
	double p[4];
	int i, j, k;

	for (i = 0; i < 3; i++) {
		Jh[i][0] = J(i, 1);
		Jh[i][1] = -J(i, 0);
		Jh[i][2] = J(i, 0);
	}

	memset(V, 0, sizeof(V));
	memset(p, 0, sizeof(p));
	for (i = 0; i < 3; i++)
		for (j = 0; j < 3; j++)
			for (k = 0; k < 3; k++)
				V[i][j] += Jh[k][i] * Minv[k] * Jh[k][j] * params.dt;
	V[1][3] = V[2][3] = 1;
	V[3][0] = params.mu;
	V[3][1] = V[3][2] = -1;

	for (i = 0; i < 3; i++)
		for (k = 0; k < 3; k++)
			p[i] += Jh[k][i] * (v(k) + params.dt * params.g(k));
	for (k = 0; k < 3; k++)
		p[0] += Jh[k][0] * params.epsilon * v(k);

	Lcp out;
	for (i = 0; i < 4; i++) {
		for (j = 0; j < 4; j++)
			out.V(i, j) = V[i][j];
		out.p(i) = p[i];
	}
	return out;
}

}
