// Part 1: get_contacts. Each check is a fact about the lowest corner, eqs. (3) to (6).
#include "answers.hpp"
#include "checks.hpp"
#include "submission.hpp"

namespace bounce::tests {
namespace {

Contact ask_contact(Asker& asker, const Case& c) {
  return submission::get_contacts(asker, c.q, c.params);
}

// Of two corners that are equally low, the one to whose J the answer is nearer.
Jacobian right_J(const Case& c, const Contact& got) {
  const auto distance = [&](const Jacobian& J) { return (got.J - J).cwiseAbs().maxCoeff(); };
  const bool is_other = c.other_J && distance(*c.other_J) < distance(c.contact.J);
  return is_other ? *c.other_J : c.contact.J;
}

Problem compare_contact(const Case& c, const Contact& got) {
  return both(compare(c, "phi", "m", c.contact.phi, got.phi),
              compare(c, "J = [J_t J_n]", "1, 1, m", right_J(c, got), got.J));
}

Problem compare_phi(const Case& c, const Contact& got) {
  return compare(c, "phi", "m", c.contact.phi, got.phi);
}

Problem compare_J_t(const Case& c, const Contact& got) {
  return compare(c, "J_t (column 0 of J)", "1, 1, m", c.contact.J.col(0), got.J.col(0));
}

Problem compare_J_n(const Case& c, const Contact& got) {
  return compare(c, "J_n (column 1 of J)", "1, 1, m", c.contact.J.col(1), got.J.col(1));
}

[[maybe_unused]] const bool kPart1IsAdded =
    register_call(1,
                  [](Asker& asker, const Case& c) { return numbers_of(ask_contact(asker, c)); }) &&
    add_checks<Contact>("part1", ask_contact,
                        {{"MeasuresTheHeightOfTheLowestCorner", compare_phi},
                         {"GivesTheTangentialColumn", compare_J_t},
                         {"GivesTheNormalColumn", compare_J_n},
                         {"FindsAnyOfTheFourCorners", compare_contact},
                         {"TurnsHoweverFar", compare_contact},
                         {"TakesTheSideFromTheParameters", compare_contact}});

}  // namespace
}  // namespace bounce::tests
