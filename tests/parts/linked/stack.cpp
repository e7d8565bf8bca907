#include "stack.hpp"

#if defined(__linux__) || defined(__APPLE__)
#include <fcntl.h>
#include <unistd.h>
#include <unwind.h>

#include <csignal>
#include <cstdint>
#ifdef __APPLE__
#include <mach-o/dyld.h>
#else
#include <link.h>
#endif

namespace bounce::tests {
namespace {

constexpr int kMostFrames = 40;

int stack_file = -1;
std::uintptr_t program_moved = 0;  // how far the system has put the program from its own addresses

// By hand: a signal's handler may not call printf.
void write_address(std::uintptr_t address) {
  char line[] = "0x0000000000000000\n";
  for (int digit = 17; digit > 1; --digit, address >>= 4) {
    line[digit] = "0123456789abcdef"[address & 15];
  }
  [[maybe_unused]] const auto written = ::write(stack_file, line, sizeof line - 1);
}

// The address of the call, not of what follows it, which may be another line's.
_Unwind_Reason_Code write_frame(_Unwind_Context* context, void* left) {
  int is_exact = 0;
  const std::uintptr_t address = _Unwind_GetIPInfo(context, &is_exact) - program_moved;
  write_address(is_exact ? address : address - 1);
  return --*static_cast<int*>(left) > 0 ? _URC_NO_REASON : _URC_END_OF_STACK;
}

void write_stack(int signal) {
  int left = kMostFrames;
  _Unwind_Backtrace(write_frame, &left);
  ::raise(signal);
}

std::uintptr_t distance_moved() {
#ifdef __APPLE__
  return static_cast<std::uintptr_t>(_dyld_get_image_vmaddr_slide(0));
#else
  std::uintptr_t first = 0;  // the program itself is the first of what is loaded
  ::dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* to) {
        *static_cast<std::uintptr_t*>(to) = info->dlpi_addr;
        return 1;
      },
      &first);
  return first;
#endif
}

}  // namespace

void write_stack_of_crash(const std::string& file) {
  stack_file = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (stack_file < 0) return;
  program_moved = distance_moved();
  static char other_stack[64 * 1024];  // the usual one may be full
  stack_t alternative = {};
  alternative.ss_sp = other_stack;
  alternative.ss_size = sizeof other_stack;
  ::sigaltstack(&alternative, nullptr);
  struct sigaction action = {};
  action.sa_handler = write_stack;
  action.sa_flags = SA_ONSTACK | static_cast<int>(SA_RESETHAND);  // the second signal ends it
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL}) {
    ::sigaction(signal, &action, nullptr);
  }
}

}  // namespace bounce::tests
#else
namespace bounce::tests {
void write_stack_of_crash(const std::string&) {}
}  // namespace bounce::tests
#endif
