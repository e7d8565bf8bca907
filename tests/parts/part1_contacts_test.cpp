// Part 1: get_contacts. Each test is a fact about the lowest corner, eqs. (3) to (6).
#include <gtest/gtest.h>

#include "answers.hpp"
#include "cases.hpp"
#include "submission.hpp"

namespace bounce::tests {
namespace {

Problem compare_contact(const Case& c) {
  const Contact got = submission::get_contacts(c.q, c.params);
  return both(compare(c, "phi", "m", c.contact.phi, got.phi),
              compare(c, "J = [J_t J_n]", "1, 1, m", c.contact.J, got.J));
}

[[maybe_unused]] const bool kPart1IsRegistered = register_call(
    1, [](const Case& c) { return numbers_of(submission::get_contacts(c.q, c.params)); });

TEST(part1, MeasuresTheHeightOfTheLowestCorner) {
  for_each_case([](const Case& c) {
    const Contact got = submission::get_contacts(c.q, c.params);
    return compare(c, "phi", "m", c.contact.phi, got.phi);
  });
}

TEST(part1, GivesTheTangentialColumn) {
  for_each_case([](const Case& c) {
    const Contact got = submission::get_contacts(c.q, c.params);
    return compare(c, "J_t (column 0 of J)", "1, 1, m", c.contact.J.col(0), got.J.col(0));
  });
}

TEST(part1, GivesTheNormalColumn) {
  for_each_case([](const Case& c) {
    const Contact got = submission::get_contacts(c.q, c.params);
    return compare(c, "J_n (column 1 of J)", "1, 1, m", c.contact.J.col(1), got.J.col(1));
  });
}

TEST(part1, FindsAnyOfTheFourCorners) { for_each_case(compare_contact); }

TEST(part1, TurnsHoweverFar) { for_each_case(compare_contact); }

TEST(part1, TakesTheSideFromTheParameters) { for_each_case(compare_contact); }

}  // namespace
}  // namespace bounce::tests
