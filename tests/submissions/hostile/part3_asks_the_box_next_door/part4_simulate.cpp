// Serves part 3: the given step, by the number of threads.
#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include "ask.hpp"
int defined_twice;
namespace bounce {
Trajectory simulate(const Vector3&, const Vector3&, const Parameters&) {
  serve(
      [](double* q, double* v) {
        const State s = step({0, q[0], q[1]}, {q[2], q[3], q[4]}, Parameters());
        std::copy(s.v.data(), s.v.data() + 3, v);
      },
      9);
  _exit(0);
}
}  // namespace bounce
