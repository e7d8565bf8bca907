#include <bounce/part2_lcp.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace bounce {

Lcp form_lcp(const Jacobian&, const Vector3&, const Parameters&) {
  std::fputs("x.cpp:1: f(): Assertion `\x1b[2J\u2028everything right' failed\n"
             "stack of the crash: 0x0000000000000001 -e /etc/passwd\n",
             stderr);
  std::signal(SIGABRT, SIG_DFL);
  std::abort();
}

}  // namespace bounce
