#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce::runner {
struct ChannelClosed {};
}  // namespace bounce::runner

namespace bounce {

State step(const Vector3&, const Vector3&, const Parameters&) { throw runner::ChannelClosed(); }

}  // namespace bounce
