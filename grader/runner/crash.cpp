#include "crash.hpp"

#include <unistd.h>
#include <unwind.h>

#include <csignal>
#include <cstdint>
#include <cstring>
#include <iterator>

namespace bounce::runner {
namespace {

constexpr int kFrames = 40;

struct Stack {
  std::uintptr_t addresses[kFrames];
  int size = 0;
};

// The address of the call, not of what comes after it, so that its line is the call's.
_Unwind_Reason_Code note_frame(_Unwind_Context* context, void* to) {
  Stack& stack = *static_cast<Stack*>(to);
  int before = 0;
  const std::uintptr_t address = _Unwind_GetIPInfo(context, &before);
  stack.addresses[stack.size++] = before ? address : address - 1;
  return stack.size < kFrames ? _URC_NO_REASON : _URC_END_OF_STACK;
}

// In a signal handler only write() may be called: hexadecimal digits by hand.
char* put_hexadecimal(char* to, std::uintptr_t x) {
  *to++ = ' ';
  *to++ = '0';
  *to++ = 'x';
  for (int shift = 60; shift >= 0; shift -= 4) *to++ = "0123456789abcdef"[(x >> shift) & 15];
  return to;
}

void tell(int) {
  Stack stack;
  _Unwind_Backtrace(note_frame, &stack);
  char line[sizeof kStack + kFrames * 19 + 2] = "\n";
  char* end = std::strcpy(line + 1, kStack) + sizeof kStack - 1;
  for (int i = 0; i < stack.size; ++i) end = put_hexadecimal(end, stack.addresses[i]);
  *end++ = '\n';
  [[maybe_unused]] const auto written =
      ::write(STDERR_FILENO, line, static_cast<std::size_t>(end - line));
}

}  // namespace

void tell_where_it_crashes() {
  static char other_stack[64 * 1024];  // the usual one may be what has overflowed
  const stack_t alternative{other_stack, 0, sizeof other_stack};
  ::sigaltstack(&alternative, nullptr);
  struct sigaction action = {};
  action.sa_handler = tell;
  action.sa_flags = SA_ONSTACK | SA_RESETHAND;  // the second time, the signal ends the program
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS}) {
    ::sigaction(signal, &action, nullptr);
  }
}

}  // namespace bounce::runner
