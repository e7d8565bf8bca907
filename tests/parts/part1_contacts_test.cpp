// Part 1: get_contacts. Each test is a fact about the lowest corner, eqs. (3) to (6).
#include <gtest/gtest.h>

#include "answers.hpp"
#include "cases.hpp"
#include "submission.hpp"

namespace bounce::tests {
namespace {

Contact contact_of(const Case& c) { return submission::get_contacts(c.q, c.params); }

Problem compare_contact(const Case& c) {
  const Contact got = contact_of(c);
  return both(compare(c, "phi", "m", c.contact.phi, got.phi),
              compare(c, "J = [J_t J_n]", "1, 1, m", c.contact.J, got.J));
}

[[maybe_unused]] const bool kPart1IsRegistered =
    register_call(1, [](const Case& c) { return numbers_of(contact_of(c)); });

TEST(part1, MeasuresTheHeightOfTheLowestCorner) {
  for_each_case(
      [](const Case& c) { return compare(c, "phi", "m", c.contact.phi, contact_of(c).phi); });
}

TEST(part1, GivesTheTangentialColumn) {
  for_each_case([](const Case& c) {
    return compare(c, "J_t (column 0 of J)", "1, 1, m", c.contact.J.col(0), contact_of(c).J.col(0));
  });
}

TEST(part1, GivesTheNormalColumn) {
  for_each_case([](const Case& c) {
    return compare(c, "J_n (column 1 of J)", "1, 1, m", c.contact.J.col(1), contact_of(c).J.col(1));
  });
}

TEST(part1, FindsAnyOfTheFourCorners) { for_each_case(compare_contact); }

TEST(part1, TurnsHoweverFar) { for_each_case(compare_contact); }

TEST(part1, TakesTheSideFromTheParameters) { for_each_case(compare_contact); }

}  // namespace
}  // namespace bounce::tests
