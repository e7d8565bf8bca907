// How well mistakes are recognised in code other than the gallery's, with rounding noise, and two
// in one program. A wrong name is worse than none, so there must be no wrong one.
#include "rewritten.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <random>

#include "../../parts/pattern.hpp"
#include "../../parts/recognise.hpp"

namespace bounce::tests {
namespace {

using Names = std::set<std::string>;

constexpr int kParts[] = {1, 2, 3, 4};

struct Part {
  int number;
  std::vector<Case> cases;
  KnownMistakes known;
};

const Part& part_of(int number) {
  static std::map<int, Part> parts;
  if (parts.count(number) == 0) {
    std::ifstream in(public_file(number, "mistakes").value());
    parts.emplace(number, Part{number, questions(number), read_mistakes(in, number)});
  }
  return parts.at(number);
}

std::vector<Answer> answers_of(const Part& part, const Names& mistakes, int way) {
  Rewritten program(mistakes, way);
  std::vector<Answer> all;
  for (const Case& c : part.cases) {
    try {
      all.push_back({program.answer(part.number, c), ""});
    } catch (const std::exception& thrown) {
      all.push_back({{}, thrown.what()});
    }
  }
  return all;
}

Names named(const Part& part, const std::vector<Answer>& got) {
  Names names;
  for (const Mistake& m : recognise(part.known, got)) names.insert(m.name);
  return names;
}

bool same_answers(const std::vector<Answer>& a, const std::vector<Answer>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Answer& x, const Answer& y) { return same(x, y); });
}

// The known mistakes that Rewritten has.
std::vector<std::string> rewritten(const Part& part) {
  std::vector<std::string> names;
  for (const Mistake& m : part.known.mistakes) {
    if (!same_answers(answers_of(part, {m.name}, 0), part.known.right)) names.push_back(m.name);
  }
  return names;
}

std::string text(const Names& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : " + ") + name;
  return all.empty() ? "nothing" : all;
}

TEST(rewritten, IsRightWithoutAMistake) {
  for (const int number : kParts) {
    for (int way = 0; way < Rewritten::kWays[number - 1]; ++way) {
      const Part& part = part_of(number);
      EXPECT_TRUE(same_answers(answers_of(part, {}, way), part.known.right))
          << number << " " << way;
      EXPECT_EQ(named(part, answers_of(part, {}, way)), Names{});
    }
  }
}

// What the corner does, by the right answer: q' - q - dt v', and v'.
std::string mode_of(const Case& c, const Eigen::VectorXd& right) {
  const Vector3 v = right.tail(3);
  if (right(1) < c.params.delta / 2) return "no corner touches";
  if ((v - c.v - c.params.dt * c.params.g).norm() < 1e-12) return "leaves the ground";
  const Contact contact = get_contacts(c.q, c.params);
  const double v_t = contact.J.col(0).dot(v);
  if (std::abs(v_t) < 1e-9) return "sticks";
  return v_t > 0 ? "slides to the right" : "slides to the left";
}

TEST(rewritten, EveryQuestionOfPart3IsWhatItSays) {
  const Part& part = part_of(3);
  for (std::size_t k = 0; k < part.cases.size(); ++k) {
    const std::string mode = mode_of(part.cases[k], part.known.right[k].numbers);
    EXPECT_NE(part.cases[k].corner.find(mode), std::string::npos)
        << part.cases[k].corner << ", and not " << mode;
  }
}

TEST(rewritten, HasNearlyAllKnownMistakes) {
  std::size_t known = 0, seen = 0;
  for (const int number : kParts) {
    known += part_of(number).known.mistakes.size();
    seen += rewritten(part_of(number)).size();
  }
  EXPECT_GE(seen, 120u) << "of " << known;
}

TEST(rewritten, EveryMistakeIsRecognisedInOtherCode) {
  for (const int number : kParts) {
    const Part& part = part_of(number);
    for (const std::string& name : rewritten(part)) {
      for (int way = 0; way < Rewritten::kWays[number - 1]; ++way) {
        EXPECT_EQ(text(named(part, answers_of(part, {name}, way))), name) << "way " << way;
      }
    }
  }
}

// What is said of numbers that no known mistake explains depends on them alone, too.
TEST(rewritten, TheSameIsSaidOfTheNumbersOfOtherCode) {
  for (const int number : kParts) {
    const Part& part = part_of(number);
    const auto said = [&](const std::vector<Answer>& got) {
      return patterns(number, part.cases, part.known.right, got);
    };
    for (const Mistake& m : part.known.mistakes) {
      const std::vector<Answer> got = answers_of(part, {m.name}, 1 % Rewritten::kWays[number - 1]);
      const bool shows = !same_answers(got, part.known.right);
      if (shows) {
        EXPECT_EQ(said(got), said(m.answers)) << m.name;
      }
    }
  }
}

TEST(rewritten, EveryMistakeIsRecognisedThroughRoundingNoise) {
  std::mt19937_64 random(1);
  const auto noise = [&] { return 1e-12 * (static_cast<double>(random() >> 11) * 0x1p-52 - 1); };
  for (const int number : kParts) {
    const Part& part = part_of(number);
    for (const Mistake& m : part.known.mistakes) {
      std::vector<Answer> got = m.answers;
      for (Answer& answer : got) {
        for (double& x : answer.numbers) x += noise() * std::max(1.0, std::abs(x));
      }
      EXPECT_EQ(text(named(part, got)), m.name);
    }
  }
}

// Programs whose numbers are also those of others, so that no one can tell: a square is the same
// when it is seen from its other side, two signs make one, two halves a whole, one mistake hides
// what another one shares with a third, and 1 - epsilon is epsilon for a half.
const std::map<Names, Names> kSameNumbers{
    {{"part1_sign_of_the_normal_arm", "part1_sign_of_the_tangential_arm"},
     {"part1_arm_points_to_the_centre"}},
    {{"part1_arm_points_to_the_centre", "part1_sign_of_the_normal_arm"},
     {"part1_sign_of_the_tangential_arm"}},
    {{"part1_arm_points_to_the_centre", "part1_sign_of_the_tangential_arm"},
     {"part1_sign_of_the_normal_arm"}},
    {{"part1_highest_corner", "part1_phi_above_the_corner"},
     {"part1_arm_points_to_the_centre", "part1_phi_without_the_centre"}},
    {{"part1_highest_corner", "part1_phi_without_the_centre"},
     {"part1_arm_points_to_the_centre", "part1_phi_above_the_corner"}},
    {{"part1_arm_x_from_the_origin", "part1_arm_y_from_the_origin"}, {"part1_arm_from_the_origin"}},
    {{"part1_sign_in_the_first_row_of_R", "part1_sign_in_the_second_row_of_R"},
     {"part1_sign_of_the_normal_arm"}},
    {{"part1_sign_in_the_first_row_of_R", "part1_sign_of_the_normal_arm"},
     {"part1_sign_in_the_second_row_of_R"}},
    {{"part1_sign_in_the_second_row_of_R", "part1_sign_of_the_normal_arm"},
     {"part1_sign_in_the_first_row_of_R"}},
    {{"part1_arm_points_to_the_centre", "part1_sign_in_the_first_row_of_R"},
     {"part1_sign_in_the_second_row_of_R", "part1_sign_of_the_tangential_arm"}},
    {{"part1_arm_points_to_the_centre", "part1_sign_in_the_second_row_of_R"},
     {"part1_sign_in_the_first_row_of_R", "part1_sign_of_the_tangential_arm"}},
    {{"part2_epsilon_hard_coded", "part2_mass_hard_coded"}, {"part2_mass_and_epsilon_hard_coded"}},
    {{"part2_inverse_mass_kept_from_the_first_call", "part2_mass_and_epsilon_hard_coded"},
     {"part2_epsilon_hard_coded", "part2_inverse_mass_kept_from_the_first_call"}},
    {{"part2_mass_and_epsilon_hard_coded", "part2_one_minus_epsilon"},
     {"part2_epsilon_without_one", "part2_mass_and_epsilon_hard_coded"}},
    {{"part2_epsilon_hard_coded", "part2_one_minus_epsilon"},
     {"part2_epsilon_hard_coded", "part2_epsilon_without_one"}},
    {{"part2_force_is_g", "part2_mass_in_place_of_its_inverse"},
     {"part2_gravity_not_divided_by_the_mass", "part2_mass_in_place_of_its_inverse"}},
    {{"part2_dt_hard_coded", "part2_force_left_out"},
     {"part2_dt_hard_coded_in_V", "part2_force_left_out"}},
    {{"part2_dt_hard_coded", "part2_gravity_without_dt"},
     {"part2_dt_hard_coded_in_V", "part2_gravity_without_dt"}},
    {{"part2_mass_and_epsilon_hard_coded", "part2_restitution_left_out"},
     {"part2_mass_hard_coded", "part2_restitution_left_out"}},
    {{"part3_friction_sign", "part3_friction_to_the_left_alone"},
     {"part3_both_frictions_to_one_side", "part3_friction_to_the_left_alone"}},
    {{"part3_contact_above_delta", "part3_no_gravity_in_contact"},
     {"part3_contact_above_delta", "part3_no_gravity_in_flight"}},
    {{"part3_contact_above_delta", "part3_no_gravity_in_flight"},
     {"part3_contact_above_delta", "part3_no_gravity_in_contact"}},
    {{"part3_contact_step_without_dt", "part3_no_gravity_in_contact"},
     {"part3_forces_taken_for_impulses", "part3_no_gravity_in_contact"}},
    {{"part3_friction_to_the_left_alone", "part3_one_friction_force_alone"},
     {"part3_normal_force_alone"}},
    {{"part3_no_gravity_in_flight", "part3_velocity_without_dt"},
     {"part3_contact_step_without_dt", "part3_no_gravity_in_flight"}},
};

bool have_the_same_numbers(const Names& both, const Names& said) {
  return kSameNumbers.count(both) > 0 && kSameNumbers.at(both) == said;
}

// Mistakes that are two others in one, or can't be told from them.
const std::map<std::string, Names> kTwoInOne{
    {"part1_arm_from_the_origin", {"part1_arm_x_from_the_origin", "part1_arm_y_from_the_origin"}},
    {"part1_arm_points_to_the_centre",
     {"part1_sign_of_the_normal_arm", "part1_sign_of_the_tangential_arm"}},
    {"part2_mass_and_epsilon_hard_coded", {"part2_epsilon_hard_coded", "part2_mass_hard_coded"}},
    {"part3_normal_force_alone",
     {"part3_friction_to_the_left_alone", "part3_one_friction_force_alone"}},
    {"part4_column_zero_left_zero",
     {"part4_first_configuration_never_stored", "part4_first_velocity_never_stored"}},
    {"part4_velocity_left_zero",
     {"part4_first_velocity_never_stored", "part4_velocity_never_stored"}},
};

TEST(rewritten, NoMistakeIsGivenAWrongNameBeforeItIsKnown) {
  for (const int number : kParts) {
    const Part& part = part_of(number);
    for (const Mistake& m : part.known.mistakes) {
      Part without = part;
      std::erase_if(without.known.mistakes,
                    [&](const Mistake& other) { return other.name == m.name; });
      const Names said = named(without, m.answers);
      const Names expected = kTwoInOne.count(m.name) > 0 ? kTwoInOne.at(m.name) : Names();
      EXPECT_EQ(text(said), text(expected)) << m.name;
    }
  }
}

struct Count {
  int pairs = 0, named = 0, one_hides = 0, same_numbers = 0, unnamed = 0;
};

// Whether the names are true of a program with both mistakes. One name is enough if the other
// doesn't show.
void judge_pair(const Part& part, const Names& both, int way, Count& count) {
  const Names said = named(part, answers_of(part, both, way));
  const bool one_of_them =
      said.size() == 1 && std::includes(both.begin(), both.end(), said.begin(), said.end());
  ++count.pairs;
  count.named += said == both;
  count.one_hides += one_of_them;
  count.same_numbers += have_the_same_numbers(both, said);
  count.unnamed += said.empty();
  EXPECT_TRUE(said.empty() || said == both || one_of_them || have_the_same_numbers(both, said))
      << text(both) << " is taken for " << text(said);
}

// How many pairs must be named as such, by part.
constexpr int kLeastNamed[] = {100, 510, 200, 45};

TEST(rewritten, NoPairIsGivenAWrongName) {
  for (const int number : kParts) {
    const Part& part = part_of(number);
    const std::vector<std::string> names = rewritten(part);
    Count count;
    for (std::size_t i = 0; i < names.size(); ++i) {
      for (std::size_t j = i + 1; j < names.size(); ++j) {
        const int way = static_cast<int>(i + j) % Rewritten::kWays[number - 1];
        judge_pair(part, {names[i], names[j]}, way, count);
      }
    }
    EXPECT_GE(count.named, kLeastNamed[number - 1]) << "part " << number;
    std::cout << "part " << number << ": " << count.pairs << " pairs; " << count.named
              << " named as such, " << count.one_hides << " by the one that shows, "
              << count.same_numbers << " by others with the same numbers, " << count.unnamed
              << " not at all\n";
  }
}

}  // namespace
}  // namespace bounce::tests
