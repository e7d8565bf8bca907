// Part 2: form_lcp. Each test is a fact about V and p, eqs. (7) to (10).
#include <gtest/gtest.h>

#include "answers.hpp"
#include "cases.hpp"
#include "submission.hpp"

namespace bounce::tests {
namespace {

Lcp lcp_of(const Case& c) { return submission::form_lcp(c.J, c.v, c.params); }

[[maybe_unused]] const bool kPart2IsRegistered =
    register_call(2, [](const Case& c) { return numbers_of(lcp_of(c)); });

Problem compare_block(const Case& c, const Lcp& got) {
  return compare(c, "the upper left 3x3 of V", "s/kg", c.lcp.V.topLeftCorner<3, 3>(),
                 got.V.topLeftCorner<3, 3>());
}

Problem compare_border(const Case& c, const Lcp& got) {
  return both(compare(c, "the last column of V", "no unit", c.lcp.V.col(3), got.V.col(3)),
              compare(c, "the last row of V", "no unit", c.lcp.V.row(3), got.V.row(3)));
}

TEST(part2, FormsTheBlockOfTheForces) {
  for_each_case([](const Case& c) { return compare_block(c, lcp_of(c)); });
}

TEST(part2, BordersItWithTheFrictionCone) {
  for_each_case([](const Case& c) { return compare_border(c, lcp_of(c)); });
}

TEST(part2, GivesTheNormalRowOfP) {
  for_each_case(
      [](const Case& c) { return compare(c, "p(0)", "m/s", c.lcp.p(0), lcp_of(c).p(0)); });
}

TEST(part2, GivesTheTangentialRowsOfP) {
  for_each_case([](const Case& c) {
    return compare(c, "(p(1), p(2), p(3))", "m/s, m/s, N", c.lcp.p.tail<3>(),
                   lcp_of(c).p.tail<3>());
  });
}

TEST(part2, AddsGravityAlongTheGround) {
  for_each_case([](const Case& c) {
    return compare(c, "(p(1), p(2))", "m/s", c.lcp.p.segment<2>(1), lcp_of(c).p.segment<2>(1));
  });
}

TEST(part2, TakesEveryNumberFromTheParameters) {
  for_each_case([](const Case& c) {
    const Lcp got = lcp_of(c);
    return both(both(compare_block(c, got), compare_border(c, got)),
                compare(c, "p", "m/s, m/s, m/s, N", c.lcp.p, got.p));
  });
}

}  // namespace
}  // namespace bounce::tests
