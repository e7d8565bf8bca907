#include "crash.hpp"

#if defined(__linux__) || defined(__APPLE__)
#include <fcntl.h>
#include <unistd.h>
#include <unwind.h>

#include <csignal>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#ifdef __APPLE__
#include <mach-o/dyld.h>
#else
#include <link.h>
#include <ucontext.h>
#endif

namespace bounce::runner {
namespace {

int report = STDERR_FILENO;
std::uintptr_t program_moved = 0;  // how far the system has put the program from its own addresses
constexpr std::size_t kLongestText = 200;
constexpr std::uintptr_t kNearNull = 64 * 1024;
constexpr std::uintptr_t kBelowTheStack = 64 * 1024;  // that a call may touch below its pointer

std::uintptr_t stack_begin = 0;  // the stack grows down from here
const char* finding = nullptr;

struct Stack {
  std::uintptr_t addresses[kFrames];
  int size = 0;
};

// Notes the address of the call, not the return address, so that the line is the call's.
_Unwind_Reason_Code note_frame(_Unwind_Context* context, void* to) {
  Stack& stack = *static_cast<Stack*>(to);
  int before = 0;
  const std::uintptr_t address = _Unwind_GetIPInfo(context, &before) - program_moved;
  stack.addresses[stack.size++] = before ? address : address - 1;
  return stack.size < kFrames ? _URC_NO_REASON : _URC_END_OF_STACK;
}

char* put_text(char* to, const char* text) {
  const std::size_t size = ::strnlen(text, kLongestText);
  std::memcpy(to, text, size);
  return to + size;
}

// Writes hexadecimal digits by hand: a signal handler may not call printf.
char* put_hexadecimal(char* to, std::uintptr_t x) {
  to = put_text(to, " 0x");
  for (int shift = 4 * (kDigits - 1); shift >= 0; shift -= 4)
    *to++ = "0123456789abcdef"[(x >> shift) & 15];
  return to;
}

[[maybe_unused]] char* put_decimal(char* to, unsigned x) {
  if (x >= 10) to = put_decimal(to, x / 10);
  *to++ = "0123456789"[x % 10];
  return to;
}

std::uintptr_t stack_pointer([[maybe_unused]] void* context) {
#if defined(__linux__) && defined(__x86_64__)
  return static_cast<std::uintptr_t>(static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_RSP]);
#elif defined(__linux__) && defined(__aarch64__)
  return static_cast<ucontext_t*>(context)->uc_mcontext.sp;
#else
  return stack_begin;
#endif
}

// The likely cause of a fault at an address. Memory between the stack pointer and the stack's
// beginning always exists, unless the stack couldn't grow that far.
const char* cause_of_fault(std::uintptr_t address, std::uintptr_t pointer) {
  if (address < kNearNull) return kNull;
  return address >= pointer - kBelowTheStack && address < stack_begin ? kFullStack : kUnknown;
}

char* put_cause(char* to, int signal, const siginfo_t& info, void* context) {
  const bool is_fault = info.si_code > 0;  // and no signal that was sent
  to = put_text(put_text(to, "\n"), kCause);
  if (finding) {
    to = put_text(put_text(to, kFound), finding);
#ifdef __linux__
  } else if (signal == SIGSYS) {
    to = put_decimal(put_text(to, kCall), static_cast<unsigned>(info.si_syscall));
#endif
  } else if (is_fault && signal == SIGSEGV) {
    const auto address = reinterpret_cast<std::uintptr_t>(info.si_addr);
    to = put_text(to, cause_of_fault(address, stack_pointer(context)));
  } else if (is_fault && signal == SIGFPE) {
    to = put_text(to, info.si_code == FPE_INTDIV ? kDivision : kFloat);
  } else {
    to = put_text(to, kUnknown);
  }
  return put_text(to, "\n");
}

void tell(int signal, siginfo_t* info, void* context) {
  Stack stack;
  _Unwind_Backtrace(note_frame, &stack);
  char lines[sizeof kCause + sizeof kStack + 300 + kFrames * (kDigits + 3)];
  char* end = put_text(put_cause(lines, signal, *info, context), kStack);
  for (int i = 0; i < stack.size; ++i) end = put_hexadecimal(end, stack.addresses[i]);
  *end++ = '\n';
  [[maybe_unused]] const auto written =
      ::write(report, lines, static_cast<std::size_t>(end - lines));
  ::raise(signal);  // unlike a fault, a refused call or a sent signal isn't repeated
}

}  // namespace

void report_crashes(const char* file) {
  if (file) report = ::open(file, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
#ifdef __APPLE__
  program_moved = static_cast<std::uintptr_t>(_dyld_get_image_vmaddr_slide(0));
#else
  ::dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void*) {
        program_moved = info->dlpi_addr;
        return 1;  // the program itself is the first of what is loaded
      },
      nullptr);
#endif
  stack_begin = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
  static char other_stack[64 * 1024];  // the usual stack may have overflowed
  stack_t alternative = {};
  alternative.ss_sp = other_stack;
  alternative.ss_size = sizeof other_stack;
  ::sigaltstack(&alternative, nullptr);
  struct sigaction action = {};
  action.sa_sigaction = tell;
  // A second signal ends the program.
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS, SIGSYS}) {
    ::sigaction(signal, &action, nullptr);
  }
}

void note_finding(const char* what) { finding = what; }

}  // namespace bounce::runner
#else
void bounce::runner::report_crashes(const char*) {}
#endif
