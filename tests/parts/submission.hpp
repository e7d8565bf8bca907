// The code under test. The tests call it only through these functions, which have two
// implementations: linked/ calls the functions directly (in a student's own build, where a debugger
// works); the judge's submission_remote.cpp asks a runner in another process.
#pragma once

#include <bounce/types.hpp>

namespace bounce::submission {

Contact get_contacts(const Vector3& q, const Parameters& params);
Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params);

// For part 4, which calls it, also where right earlier parts are given: then the right step.
State step(const Vector3& q, const Vector3& v, const Parameters& params);

// Throws std::runtime_error unless q and v are both 3xT.
Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params);

// The first T columns, or T - 1 if one is missing, so that a wrong number of columns doesn't make
// the others wrong. Throws std::runtime_error if q or v has fewer, or none.
Trajectory first_columns(const Vector3& q_0, const Vector3& v_0, const Parameters& params);

// Throws std::runtime_error, naming the shapes, unless both numbers of columns are T.
void require_columns(Eigen::Index q_columns, Eigen::Index v_columns, int T);

// How many of the first T columns both have. Throws the same if more than one is missing.
Eigen::Index columns_at_hand(Eigen::Index q_columns, Eigen::Index v_columns, int T);

}  // namespace bounce::submission
