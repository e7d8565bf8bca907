#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <variant>

namespace bounce {

namespace {

struct Flight {};
struct Touch {
  Jacobian J;
};
using Phase = std::variant<Flight, Touch>;

auto phase(const Vector3& q, const Parameters& params) -> Phase {
  const auto [J, phi] = get_contacts(q, params);
  if (phi < params.delta) return Touch{J};
  return Flight{};
}

template <typename... Ts>
struct overloaded : Ts... {
  using Ts::operator()...;
};
template <typename... Ts>
overloaded(Ts...) -> overloaded<Ts...>;

}  // namespace

auto step(const Vector3& q, const Vector3& v, const Parameters& params) -> State {
  const auto dt = params.dt;
  return std::visit(
      overloaded{
          [&](const Flight&) -> State {
            const auto next = Vector3{v + dt * params.g};
            return {q + dt * next, next};
          },
          [&](const Touch& touch) -> State {
            const auto [V, p] = form_lcp(touch.J, v, params);
            const auto f = solve_lcp(V, p);
            const auto push = Vector3{touch.J.col(1) * f.x() + touch.J.col(0) * (f.z() - f.y())};
            const auto next = Vector3{v + dt * params.g + dt * params.M().inverse() * push};
            return {q + dt * next + params.delta * Vector3::UnitY(), next};
          }},
      phase(q, params));
}

}  // namespace bounce
