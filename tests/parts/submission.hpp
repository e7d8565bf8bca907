// The code under test. The tests call it only through submission::get_contacts and so on, with the
// arguments and the result of the part's own function. There are two implementations: linked/ calls
// the functions directly (in a student's own build, where a debugger works); the judge's
// submission_remote.cpp asks a runner in another process.
#pragma once

#include "functions.hpp"

namespace bounce::submission {

template <int part, auto* function>
struct Asked;

template <int part, class Result, class... Arguments, Result (*function)(Arguments...)>
struct Asked<part, function> {
  // Of part 3, also where right earlier parts are given to part 4: then the right step. Of part 4,
  // throws std::runtime_error unless q and v are both 3xT.
  Result operator()(Arguments... arguments) const;
};

#define BOUNCE_ASKED(number, function) inline constexpr Asked<number, &bounce::function> function{};
BOUNCE_FUNCTIONS(BOUNCE_ASKED)
#undef BOUNCE_ASKED

// The first T columns, or T - 1 if one is missing, so that a wrong number of columns doesn't make
// the others wrong. Throws std::runtime_error if q or v has fewer, or none.
Trajectory first_columns(const Vector3& q_0, const Vector3& v_0, const Parameters& params);

// Throws std::runtime_error, naming the shapes, unless both numbers of columns are T.
void require_columns(Eigen::Index q_columns, Eigen::Index v_columns, int T);

// How many of the first T columns both have. Throws the same if more than one is missing.
Eigen::Index columns_at_hand(Eigen::Index q_columns, Eigen::Index v_columns, int T);

}  // namespace bounce::submission
