#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <map>
#include <utility>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);

  const auto accelerate = [&](const Vector3& f) -> Vector3 {
    static std::map<std::pair<double, double>, Vector3> inverse;
    const auto [it, is_new] = inverse.try_emplace({params.m, params.l});
    if (is_new) it->second = params.M().diagonal().cwiseInverse();
    return it->second.cwiseProduct(f);
  };
  const auto ground_force = [&]() -> Vector3 {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    return contact.J * Eigen::Vector2d(f(2) - f(1), f(0));
  };
  const auto advance = [&](const Vector3& f, double lift) -> State {
    const Vector3 v_new = v + params.dt * accelerate(f);
    return {q + params.dt * v_new + lift * Vector3::UnitY(), v_new};
  };

  const Vector3 f_e = params.M() * params.g;
  return contact.phi < params.delta ? advance(f_e + ground_force(), params.delta)
                                    : advance(f_e, 0.0);
}

}  // namespace bounce
