#include <bounce/part2_lcp.hpp>

namespace bounce {

/* V and p of the handout,
   equations 7 to 10 */
#define ROW(a, b, c, d) \
  a, b, c, d

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params)
{
	Eigen::Matrix3d J_hat;
	J_hat << J.col(1), -J.col(0), J.col(0);
	Eigen::Matrix3d A = J_hat.transpose() * params.M().inverse() * J_hat * params.dt;

	Lcp lcp;
	lcp.V << ROW(A(0, 0), A(0, 1), A(0, 2), 0),
	         ROW(A(1, 0), A(1, 1), A(1, 2), 1),
	         ROW(A(2, 0), A(2, 1), A(2, 2), 1),
	         ROW(params.mu, -1, -1, 0);

	Vector3 w = v + params.dt * params.g;
	lcp.p << J.col(1).dot(w + params.epsilon * v), -J.col(0).dot(w), J.col(0).dot(w), 0;
	return lcp;
}

}
