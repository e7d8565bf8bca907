#include "rewritten.hpp"

#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <cmath>
#include <optional>

#include "../../parts/submission.hpp"

namespace bounce::tests {
namespace {

const Vector3 kDown(0, -9.81, 0);

State next(const State& state, const Parameters& params) { return step(state.q, state.v, params); }

// A program with these mistakes. One that isn't known here changes nothing.
class Rewritten {
 public:
  explicit Rewritten(std::set<std::string> mistakes) : mistakes_(std::move(mistakes)) {}

  Eigen::VectorXd answer(int part, const Case& c) {
    if (!first_) first_ = c.params;
    return part == 3 ? part3(c) : part4(c);
  }

 private:
  bool has(const std::string& mistake) const { return mistakes_.count(mistake) > 0; }

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
