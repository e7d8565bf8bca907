// The code under test, wherever it runs. The tests ask it through these four functions alone:
// linked/ calls the functions that are linked in (a student's own machine, with a
// debugger if they like); the judge's submission_remote.cpp asks a runner in another process.
#pragma once

#include <bounce/types.hpp>

namespace bounce::submission {

Contact get_contacts(const Vector3& q, const Parameters& params);
Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params);
State step(const Vector3& q, const Vector3& v, const Parameters& params);

// Throws std::runtime_error unless q and v are both 3xT.
Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params);

// The first T columns, or one less, so that a wrong number of columns is no mistake in those that
// are there. Throws std::runtime_error where q or v has fewer, or none.
Trajectory first_columns(const Vector3& q_0, const Vector3& v_0, const Parameters& params);

// Throws std::runtime_error, naming the shapes, unless both numbers of columns are T.
void require_columns(Eigen::Index q_columns, Eigen::Index v_columns, int T);

// How many columns both have of the first T. Throws the same where more than one is missing.
Eigen::Index columns_at_hand(Eigen::Index q_columns, Eigen::Index v_columns, int T);

}  // namespace bounce::submission
