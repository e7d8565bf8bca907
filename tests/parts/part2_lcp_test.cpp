// Part 2: form_lcp. Each check is a fact about V and p, eqs. (7) to (10).
#include "answers.hpp"
#include "checks.hpp"
#include "submission.hpp"

namespace bounce::tests {
namespace {

Lcp ask_lcp(Asker& asker, const Case& c) { return submission::form_lcp(asker, c.J, c.v, c.params); }

Problem compare_block(const Case& c, const Lcp& got) {
  return compare(c, "the upper left 3x3 of V", "s/kg", c.lcp.V.topLeftCorner<3, 3>(),
                 got.V.topLeftCorner<3, 3>());
}

Problem compare_border(const Case& c, const Lcp& got) {
  return both(compare(c, "the last column of V", "no unit", c.lcp.V.col(3), got.V.col(3)),
              compare(c, "the last row of V", "no unit", c.lcp.V.row(3), got.V.row(3)));
}

Problem compare_normal(const Case& c, const Lcp& got) {
  return compare(c, "p(0)", "m/s", c.lcp.p(0), got.p(0));
}

Problem compare_tangential(const Case& c, const Lcp& got) {
  return compare(c, "(p(1), p(2), p(3))", "m/s, m/s, N", c.lcp.p.tail<3>(), got.p.tail<3>());
}

Problem compare_along_the_ground(const Case& c, const Lcp& got) {
  return compare(c, "(p(1), p(2))", "m/s", c.lcp.p.segment<2>(1), got.p.segment<2>(1));
}

Problem compare_lcp(const Case& c, const Lcp& got) {
  return both(both(compare_block(c, got), compare_border(c, got)),
              compare(c, "p", "m/s, m/s, m/s, N", c.lcp.p, got.p));
}

[[maybe_unused]] const bool kPart2IsAdded =
    register_call(2, [](Asker& asker, const Case& c) { return numbers_of(ask_lcp(asker, c)); }) &&
    add_checks<Lcp>("part2", ask_lcp,
                    {{"FormsTheBlockOfTheForces", compare_block},
                     {"BordersItWithTheFrictionCone", compare_border},
                     {"GivesTheNormalRowOfP", compare_normal},
                     {"GivesTheTangentialRowsOfP", compare_tangential},
                     {"AddsGravityAlongTheGround", compare_along_the_ground},
                     {"TakesEveryNumberFromTheParameters", compare_lcp}});

}  // namespace
}  // namespace bounce::tests
