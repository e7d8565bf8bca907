#include "rewritten.hpp"

#include <algorithm>
#include <array>
#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <cmath>
#include <numbers>
#include <optional>

#include "../../parts/submission.hpp"

namespace bounce::tests {
namespace {

constexpr double kPi = std::numbers::pi;
const Vector3 kDown(0, -9.81, 0);

State next(const State& state, const Parameters& params) { return step(state.q, state.v, params); }

// A program with these mistakes. One that isn't known here changes nothing.
class Rewritten {
 public:
  explicit Rewritten(std::set<std::string> mistakes) : mistakes_(std::move(mistakes)) {}

  Eigen::VectorXd answer(int part, const Case& c) {
    if (!first_) first_ = c.params;
    return part == 1 ? part1(c) : part == 2 ? part2(c) : part == 3 ? part3(c) : part4(c);
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

  // --- part 3 ---

  bool touches(const Contact& contact, const Case& c, const Parameters& params) const {
    const double phi = contact.phi;
    if (has("part3_no_lift_when_leaving") && contact.J.col(1).dot(c.v) >= 0) return false;
    if (has("part3_bounces_in_the_air")) return true;
    if (has("part3_contact_below_zero")) return phi < 0;
    if (has("part3_contact_at_or_below_zero")) return phi <= 0;
    if (has("part3_contact_above_delta")) return phi > params.delta;
    if (has("part3_contact_by_the_absolute_value")) return std::abs(phi) < params.delta;
    if (has("part3_threshold_doubled")) return phi < 2 * params.delta;
    if (has("part3_threshold_hard_coded")) return phi < 0.001;
    if (has("part3_tests_the_height_of_the_centre")) return c.q.y() < params.delta;
    return phi < params.delta;
  }

  Eigen::Vector3d contact_force(const Contact& contact, const Case& c) const {
    const Lcp lcp =
        form_lcp(contact.J, c.v, has("part3_default_parameters") ? Parameters() : c.params);
    Vector3 f = solve_lcp(lcp.V, lcp.p);
    if (has("part3_forces_in_the_wrong_order")) f = Vector3(f(2), f(0), f(1));
    if (has("part3_one_friction_force_alone")) f(1) = 0;
    if (has("part3_friction_to_the_left_alone")) f(2) = 0;
    double f_t = f(2) - f(1);
    if (has("part3_friction_sign")) f_t = -f_t;
    if (has("part3_normal_force_alone")) f_t = 0;
    Vector3 t = contact.J.col(0);
    if (has("part3_friction_without_moment")) t(2) = 0;
    return contact.J.col(1) * f(0) + t * f_t;
  }

  double lift(bool touching, double phi, const Parameters& params) const {
    if (has("part3_without_the_lift")) return 0;
    if (!touching && !has("part3_lift_in_flight_too")) return 0;
    const double depth = has("part3_lifted_out_of_the_ground") ? phi : 0;
    return (params.delta - depth) * (has("part3_lift_times_dt") ? params.dt : 1);
  }

  Eigen::VectorXd part3(const Case& c) {
    Parameters p = c.params;
    const Parameters usual;
    if (has("part3_dt_hard_coded")) p.dt = usual.dt;
    if (has("part3_delta_hard_coded")) p.delta = usual.delta;
    if (has("part3_gravity_hard_coded")) p.g = kDown;
    if (has("part3_gravity_upwards")) p.g = -p.g;
    if (has("part3_mass_hard_coded")) p.m = usual.m;
    const Parameters& inertia = has("part3_inverse_mass_kept_from_the_first_call") ? *first_ : p;
    const Eigen::Matrix3d M = inertia.M();
    Eigen::Matrix3d W = has("part3_mass_in_place_of_its_inverse") ? M : M.inverse();

    const Contact contact = get_contacts(c.q, has("part3_default_parameters") ? usual : c.params);
    const bool touching = touches(contact, c, p);
    Vector3 a = has("part3_mass_in_place_of_its_inverse") ? Vector3(W * M * p.g) : p.g;
    if (has("part3_force_is_g")) a = W * p.g;
    if (has("part3_mass_without_inertia")) W = Eigen::Matrix3d::Identity() / p.m;
    if (has(touching ? "part3_no_gravity_in_contact" : "part3_no_gravity_in_flight")) a.setZero();
    const bool no_time =
        has("part3_velocity_without_dt") || (touching && has("part3_contact_step_without_dt"));
    const double time = no_time ? 1 : p.dt;
    Vector3 dv = time * a;
    if (touching) {
      dv += (has("part3_forces_taken_for_impulses") ? 1 : time) * W * contact_force(contact, c);
    }
    Vector3 v = c.v + dv;
    Vector3 along = v;
    if (has("part3_moves_with_the_old_velocity")) along = c.v;
    if (has("part3_half_g_dt_squared")) along = (c.v + v) / 2;
    const Vector3 q = c.q + p.dt * along + Vector3(0, lift(touching, contact.phi, p), 0);
    return numbers_of(State{q, v}, c);
  }

  // --- part 4 ---

  State state_after(const std::vector<State>& states, const Parameters& p) const {
    const std::size_t t = states.size();
    const State& start = states.front();
    const State& from = has("part4_always_from_column_zero") ? start : states.back();
    Vector3 v = has("part4_steps_with_the_first_velocity") ? start.v : from.v;
    if (has("part4_velocity_two_columns_back")) v = states[t < 2 ? 0 : t - 2].v;
    if (!has("part4_parabola_through_the_ground")) return step(from.q, v, p);
    const double time = static_cast<double>(t) * p.dt;
    return {start.q + time * start.v + time * time / 2 * p.g, start.v + time * p.g};
  }

  Eigen::VectorXd part4(const Case& c) {
    const Parameters p = has("part4_default_parameters") ? Parameters() : c.params;
    State start{c.q, has("part4_initial_velocity_ignored") ? Vector3(0, 0, 0) : c.v};
    if (has("part4_starts_after_a_step")) start = next(start, p);
    int T = has("part4_always_150_columns") ? 150 : c.params.T;
    T += has("part4_one_column_too_many") - has("part4_one_column_missing");
    std::vector<State> states{start};
    while (static_cast<int>(states.size()) < T) states.push_back(state_after(states, p));
    states.resize(static_cast<std::size_t>(T));

    const auto columns = static_cast<Eigen::Index>(states.size());
    Trajectory got{Eigen::Matrix3Xd(3, columns), Eigen::Matrix3Xd(3, columns)};
    const bool has_stored_v =
        !has("part4_velocity_never_stored") && !has("part4_velocity_left_zero");
    for (Eigen::Index t = 0; t < columns; ++t) {
      const State& state = states[static_cast<std::size_t>(t)];
      got.q.col(t) = state.q;
      got.v.col(t) = has("part4_velocity_one_column_early") ? next(state, p).v : state.v;
      const bool stored = t == 0 ? !has("part4_velocity_left_zero") : has_stored_v;
      if (!stored) got.v.col(t).setZero();
    }
    if (has("part4_last_column_left_zero") && columns > 1) {
      got.q.rightCols<1>().setZero();
      got.v.rightCols<1>().setZero();
    }
    submission::require_columns(columns, columns, c.params.T);
    return numbers_of(got);
  }

  std::set<std::string> mistakes_;
  std::optional<Parameters> first_;  // of the first question
};

}  // namespace

std::vector<Answer> answers_with(const std::set<std::string>& mistakes, int part,
                                 const std::vector<Case>& cases) {
  Rewritten program(mistakes);
  std::vector<Answer> all;
  for (const Case& c : cases) {
    try {
      all.push_back({program.answer(part, c), ""});
    } catch (const std::exception& thrown) {
      all.push_back({{}, thrown.what()});
    }
  }
  return all;
}

}  // namespace bounce::tests
