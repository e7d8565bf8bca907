#include "termination.hpp"

#include <seccomp.h>
#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <regex>

#include "../runner/crash.hpp"
#include "ending.hpp"
#include "sentences.hpp"

namespace bounce::judge {
namespace {

using View = std::string_view;

constexpr std::size_t kLongestPrint = 4000;  // bytes

// Whether a program that was stopped from outside was storing without end.
bool was_storing(const Limits& limits, std::size_t memory) { return memory >= limits.memory / 8; }

// --- the text that a program printed last: each character is looked at a few times at most ---

// The rest of the line after the last `mark`; empty if there is none.
View line_after(View print, View mark) {
  const std::size_t at = print.rfind(mark);
  if (at == View::npos) return "";
  print.remove_prefix(at + mark.size());
  return print.substr(0, print.find('\n'));
}

// The last such line counts: a submission can print one, too, but not after it has crashed. One
// that the runner can't have printed counts for nothing.
std::string stack_in(View print) {
  static const std::regex kAddresses("(?: 0x[0-9a-f]{" + std::to_string(runner::kDigits) + "}){1," +
                                     std::to_string(runner::kFrames) + "}");
  constexpr std::size_t kLongestStack = std::size_t{runner::kFrames} * (runner::kDigits + 3);
  const std::string line(line_after(print, runner::kStack).substr(0, kLongestStack + 1));
  return std::regex_match(line, kAddresses) ? line : "";
}

// --- how it ended ---

// What it printed before the runner's report says why: what an assertion or an exception says.
Termination of_abort(const Limits& limits, View print) {
  print = print.substr(0, print.rfind(runner::kCause));
  const View thrown = line_after(print, "terminate called after throwing an instance of ");
  if (thrown == "'std::bad_alloc'") return out_of_memory(limits);
  const std::size_t kept = std::min(print.size(), kLongestPrint);
  const auto end = words::of_abort(std::string(print.substr(print.size() - kept)));
  return {"crashed", end.what, end.number, end.text};
}

Termination of_refused_call(int number) {
  const std::unique_ptr<char, void (*)(void*)> name(
      ::seccomp_syscall_resolve_num_arch(SCMP_ARCH_NATIVE, number), std::free);
  return {"crashed", "call", number, name ? name.get() : ""};
}

Termination of_signal(int signal, const Limits& limits, View print, std::size_t memory) {
  if (signal == SIGXCPU) return out_of_cpu_time(limits, memory);
  if (signal == SIGKILL && was_storing(limits, memory)) return out_of_memory(limits);
  const std::string cause = words::one_line(std::string(line_after(print, runner::kCause)));
  const auto begins = [&](const char* mark) { return cause.rfind(mark, 0) == 0; };
  Termination end{"crashed", "signal", signal, cause};
  if (limits.sanitized && begins(runner::kFound)) {
    end = {"crashed", "sanitizer", signal, cause.substr(std::strlen(runner::kFound))};
  } else if (signal == SIGABRT) {
    end = of_abort(limits, print);
  } else if (signal == SIGSYS && begins(runner::kCall)) {
    end = of_refused_call(std::atoi(cause.c_str() + std::strlen(runner::kCall)));
  }
  if (end.status == "crashed") end.stack = stack_in(print);
  return end;
}

}  // namespace

Termination termination_of(int wait_status, const Limits& limits, const std::string& last_print,
                           std::size_t memory) {
  const bool signalled = WIFSIGNALED(wait_status);
  const int code = signalled ? 128 + WTERMSIG(wait_status) : WEXITSTATUS(wait_status);
  const bool is_signal = signalled || (code > 128 && code < 128 + 65);
  if (is_signal) return of_signal(code - 128, limits, last_print, memory);
  return {"no_answer", "exited", code};
}

Termination out_of_cpu_time(const Limits& limits, std::size_t memory) {
  if (was_storing(limits, memory)) return {"out_of_memory", "stored", limits.cpu_seconds};
  return {"timed_out", "worked", limits.cpu_seconds};
}

Termination out_of_memory(const Limits& limits) {
  return {"out_of_memory", "out of memory", static_cast<long>(limits.memory >> 20)};
}

std::string in_one_line(const Termination& end) {
  std::string line = end.status + ": " + end.what + " " + std::to_string(end.number);
  return words::one_line(line + (end.text.empty() ? "" : ", " + end.text), 750);
}

}  // namespace bounce::judge
