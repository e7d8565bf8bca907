// Is a mistake named, and nothing false said? In code other than the gallery's, with rounding
// noise, and with two mistakes in one program. A wrong name is worse than none.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <set>

#include "known_part.hpp"

namespace bounce::tests {
namespace {

constexpr double kPi = std::numbers::pi;
const Vector3 kDown(0, -9.81, 0);

// Parts 1 and 2, written again with a switch for nearly each known mistake. One that isn't known
// here changes nothing.
class Rewritten {
 public:
  explicit Rewritten(std::set<std::string> mistakes) : mistakes_(std::move(mistakes)) {}

  Eigen::VectorXd answer(int part, const Case& c) {
    if (!first_) first_ = c.params;
    return part == 1 ? part1(c) : part2(c);
  }

 private:
  bool has(const std::string& mistake) const { return mistakes_.count(mistake) > 0; }

  // --- part 1 ---

  double half_side(const Parameters& params) const {
    if (has("part1_side_hard_coded")) return 0.1;
    if (has("part1_integer_half")) return 0;
    const double l = has("part1_corners_kept_from_the_first_call") ? first_->l : params.l;
    if (has("part1_corners_a_side_away")) return l;
    return has("part1_corners_a_quarter_away") ? l / 4 : l / 2;
  }

  int lowest(const Eigen::Matrix<double, 2, 4>& r) const {
    if (has("part1_always_the_same_corner")) return 2;
    const int first = has("part1_loop_misses_the_first_corner") ? 1 : 0;
    const int end = has("part1_loop_misses_a_corner") ? 3 : 4;
    const double sign = has("part1_highest_corner") ? -1 : 1;
    std::array<int, 4> order{0, 1, 2, 3};
    std::sort(order.begin() + first, order.begin() + end,
              [&](int a, int b) { return sign * r(1, a) < sign * r(1, b); });
    return order[static_cast<std::size_t>(first)];
  }

  Eigen::VectorXd part1(const Case& c) {
    const double h = half_side(c.params);
    double theta = c.q(2);
    if (has("part1_degrees")) theta *= kPi / 180;
    if (has("part1_turned_clockwise")) theta = -theta;
    Eigen::Matrix<double, 2, 4> s, r;
    s << h, -h, -h, h, h, h, -h, -h;
    if (has("part1_second_corner_repeats_the_first")) s.col(1) = s.col(0);
    const double first_sign = has("part1_sign_in_the_first_row_of_R") ? 1 : -1;
    const double second_sign = has("part1_sign_in_the_second_row_of_R") ? -1 : 1;
    for (int k = 0; k < 4; ++k) {
      r.col(k) << std::cos(theta) * s(0, k) + first_sign * std::sin(theta) * s(1, k),
          second_sign * std::sin(theta) * s(0, k) + std::cos(theta) * s(1, k);
    }
    const int k = lowest(r);

    Eigen::Vector2d arm = has("part1_jacobian_in_body_frame") ? s.col(k) : r.col(k);
    if (has("part1_arm_from_the_origin")) arm += c.q.head<2>();
    if (has("part1_arm_x_from_the_origin")) arm.x() += c.q.x();
    if (has("part1_arm_y_from_the_origin")) arm.y() += c.q.y();
    if (has("part1_arm_points_to_the_centre")) arm = -arm;
    if (has("part1_arms_exchanged")) arm.reverseInPlace();
    if (has("part1_sign_of_the_normal_arm")) arm.x() = -arm.x();
    if (has("part1_sign_of_the_tangential_arm")) arm.y() = -arm.y();

    Contact contact;
    contact.J << 1, 0, 0, 1, -arm.y(), arm.x();
    if (has("part1_filled_row_by_row")) contact.J << 1, 0, -arm.y(), 0, 1, arm.x();
    if (has("part1_columns_swapped")) contact.J.rowwise().reverseInPlace();
    contact.phi = c.q.y() + r(1, k);
    if (has("part1_phi_without_the_centre")) contact.phi = r(1, k);
    if (has("part1_phi_above_the_corner")) contact.phi = -r(1, k);
    return numbers_of(contact);
  }

  // --- part 2 ---

  Eigen::VectorXd part2(const Case& c) const {
    Parameters p = c.params;
    const Parameters usual;
    if (has("part2_mass_hard_coded") || has("part2_mass_and_epsilon_hard_coded")) p.m = usual.m;
    if (has("part2_epsilon_hard_coded") || has("part2_mass_and_epsilon_hard_coded"))
      p.epsilon = 0.5;
    if (has("part2_side_hard_coded")) p.l = usual.l;
    if (has("part2_mu_hard_coded")) p.mu = usual.mu;
    if (has("part2_dt_hard_coded")) p.dt = usual.dt;
    if (has("part2_gravity_hard_coded")) p.g = kDown;

    Vector3 M(p.m, p.m, p.m * p.l * p.l / 6);
    if (has("part2_twelfth_of_the_side_squared")) M(2) /= 2;
    if (has("part2_radius_not_squared")) M(2) = p.m * p.l / std::sqrt(6.0);
    Vector3 W = has("part2_mass_in_place_of_its_inverse") ? M : Vector3(M.cwiseInverse());
    if (has("part2_mass_without_inertia")) W.setConstant(1 / p.m);
    Vector3 f_e = M.cwiseProduct(p.g);
    if (has("part2_force_is_g")) f_e = p.g;
    if (has("part2_force_left_out")) f_e.setZero();
    if (has("part2_force_upwards")) f_e = -f_e;
    Vector3 dv = p.dt * W.cwiseProduct(f_e);
    if (has("part2_gravity_not_divided_by_the_mass")) dv = p.dt * f_e;
    if (has("part2_gravity_without_dt")) dv /= p.dt;

    const bool swapped = has("part2_columns_of_J_swapped");
    const Vector3 t = c.J.col(swapped ? 1 : 0), n = c.J.col(swapped ? 0 : 1);
    const double side = has("part2_friction_directions_swapped") ? -1 : 1;
    const double hat = has("part2_friction_directions_swapped_in_J_hat") ? -side : side;
    Eigen::Matrix3d J_hat;
    J_hat << n, -hat * t, hat * t;
    if (has("part2_jhat_stacked_as_rows")) J_hat.transposeInPlace();
    double time = has("part2_dt_hard_coded_in_V") ? usual.dt : p.dt;
    if (has("part2_without_dt")) time /= p.dt;
    if (has("part2_dt_squared")) time *= p.dt;

    Lcp lcp;
    lcp.V.setZero();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < 3; ++k) lcp.V(i, j) += time * J_hat(k, i) * J_hat(k, j) * W(k);
      }
    }
    Eigen::Vector4d column(0, 1, 1, 0), row(p.mu, -1, -1, 0);
    if (has("part2_lambda_bounds_the_normal_too")) column(0) = 1;
    if (has("part2_friction_bound_doubled")) row(0) *= 2;
    if (has("part2_last_row_negated")) row = -row;
    if (has("part2_last_column_left_zero")) column.setZero();
    if (has("part2_mu_in_the_last_column")) std::swap(row(0), column(0));
    if (has("part2_mu_in_the_corner")) std::swap(row(0), column(3));
    if (has("part2_border_transposed")) std::swap(row, column);
    lcp.V.col(3) += column;
    lcp.V.row(3) += row.transpose();

    Vector3 before = (1 + p.epsilon) * c.v;
    if (has("part2_epsilon_without_one")) before = p.epsilon * c.v;
    if (has("part2_restitution_left_out")) before = c.v;
    if (has("part2_one_minus_epsilon")) before = (1 - p.epsilon) * c.v;
    if (has("part2_scalar_added_to_a_vector")) before = Vector3::Ones() + p.epsilon * c.v;
    const double gravity = has("part2_restitution_on_gravity_too") ? 1 + p.epsilon : 1;
    const double bounce = has("part2_restitution_along_the_ground") ? 1 + p.epsilon : 1;
    const double gravity_1 = has("part2_gravity_sign_in_the_second_row") ? -1 : 1;
    lcp.p << n.dot(before) + gravity * n.dot(dv), -side * t.dot(bounce * c.v + gravity_1 * dv),
        side * t.dot(bounce * c.v + dv), has("part2_mu_in_the_last_row_of_p") ? p.mu : 0;
    return numbers_of(lcp);
  }

  std::set<std::string> mistakes_;
  std::optional<Parameters> first_;  // of the first question
};

std::vector<Answer> answers_of(int part, const std::set<std::string>& mistakes) {
  Rewritten program(mistakes);
  std::vector<Answer> all;
  for (const Case& c : known_part(part).cases) all.push_back({program.answer(part, c), ""});
  return all;
}

bool is_right(int part, const std::vector<Answer>& got) {
  return std::equal(got.begin(), got.end(), known_part(part).known.right.begin(),
                    [](const Answer& a, const Answer& b) { return same(a, b); });
}

// The names in the order of the alphabet: "a + b".
std::string text(const std::set<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : " + ") + name;
  return all;
}

std::string named(const KnownMistakes& known, const std::vector<Answer>& got) {
  std::set<std::string> names;
  for (const Mistake& m : recognise(known, got)) names.insert(m.name);
  return text(names);
}

// The known mistakes that Rewritten has.
std::vector<std::string> rewritten(int part) {
  std::vector<std::string> names;
  for (const Mistake& m : known_part(part).known.mistakes) {
    if (!is_right(part, answers_of(part, {m.name}))) names.push_back(m.name);
  }
  return names;
}

TEST(rewritten, EveryMistakeIsRecognisedInOtherCode) {
  std::size_t count = 0;
  for (const int part : {1, 2}) {
    EXPECT_TRUE(is_right(part, answers_of(part, {}))) << part;
    for (const std::string& name : rewritten(part)) {
      EXPECT_EQ(named(known_part(part).known, answers_of(part, {name})), name);
      ++count;
    }
  }
  EXPECT_GE(count, 60U);
}

TEST(rewritten, EveryMistakeIsRecognisedThroughRoundingNoise) {
  std::mt19937_64 random(1);
  const auto noise = [&] { return 1e-12 * (static_cast<double>(random() >> 11) * 0x1p-52 - 1); };
  for (const int part : {1, 2, 3, 4}) {
    for (const Mistake& m : known_part(part).known.mistakes) {
      std::vector<Answer> got = m.answers;
      for (Answer& answer : got) {
        for (double& x : answer.numbers) x += noise() * std::max(1.0, std::abs(x));
      }
      EXPECT_EQ(named(known_part(part).known, got), m.name);
    }
  }
}

// Programs whose numbers are also those of others, so that no one can tell: a square is the same
// when it is seen from its other side, two signs make one, two halves a whole, one mistake hides
// what another one shares with a third, and 1 - epsilon is epsilon for a half.
std::map<std::string, std::string> same_numbers() {
  std::ifstream file(BOUNCE_PARTS "/same_numbers.txt");
  std::map<std::string, std::string> all;
  for (std::string line; std::getline(file, line);) {
    const std::size_t at = line.find(" = ");
    all[line.substr(0, at)] = line.substr(at + 3);
  }
  return all;
}

TEST(rewritten, NoMistakeIsGivenAWrongNameBeforeItIsKnown) {
  const auto same = same_numbers();
  for (const int part : {1, 2, 3, 4}) {
    for (const Mistake& m : known_part(part).known.mistakes) {
      KnownMistakes others = known_part(part).known;
      std::erase_if(others.mistakes, [&](const Mistake& other) { return other.name == m.name; });
      EXPECT_EQ(named(others, m.answers), same.count(m.name) > 0 ? same.at(m.name) : "") << m.name;
    }
  }
}

// One name is enough if the other mistake doesn't show.
TEST(rewritten, NoPairIsGivenAWrongName) {
  constexpr int kLeastNamed[] = {85, 490};
  const auto same = same_numbers();
  for (const int part : {1, 2}) {
    const std::vector<std::string> names = rewritten(part);
    int as_both = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
      for (std::size_t j = i + 1; j < names.size(); ++j) {
        const std::set<std::string> pair{names[i], names[j]};
        const std::string got = named(known_part(part).known, answers_of(part, pair));
        const std::set<std::string> true_of_it{"", names[i], names[j], text(pair)};
        const bool same_as_others = same.count(text(pair)) > 0 && same.at(text(pair)) == got;
        EXPECT_TRUE(same_as_others || true_of_it.count(got) > 0) << text(pair) << " is " << got;
        as_both += got == text(pair);
      }
    }
    EXPECT_GE(as_both, kLeastNamed[part - 1]) << "part " << part;
  }
}

}  // namespace
}  // namespace bounce::tests
