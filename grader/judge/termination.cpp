#include "termination.hpp"

#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <map>
#include <regex>
#include <string_view>

#include "../../student/given/check/sanitizer_report.hpp"
#include "../runner/crash.hpp"
#include "assertion.hpp"
#include "sanitize_line.hpp"
#include "system_call.hpp"

namespace bounce::judge {
namespace {

constexpr std::size_t kLongest = 120;  // characters of a program's text in a sentence

// Whether a program that was stopped from outside was storing without end.
bool was_storing(const Limits& limits, std::size_t memory) { return memory >= limits.memory / 8; }

// --- the text that a program printed last; it may be anything ---

std::string_view up_to(std::string_view text, std::string_view end) {
  return text.substr(0, text.find(end));
}

// The rest of the line after the last `mark`; empty if there is none.
std::string_view line_after(std::string_view print, std::string_view mark) {
  const std::size_t at = print.rfind(mark);
  if (at == std::string_view::npos) return "";
  return up_to(print.substr(at + mark.size()), "\n");
}

// The last such line counts: a submission can print one, too, but not after it has crashed. One
// that the runner can't have printed counts for nothing.
std::string stack_in(std::string_view print) {
  static const std::regex kAddresses("(?: 0x[0-9a-f]{" + std::to_string(runner::kDigits) + "}){1," +
                                     std::to_string(runner::kFrames) + "}");
  constexpr std::size_t kLongestStack = std::size_t{runner::kFrames} * (runner::kDigits + 3);
  const std::string line(line_after(print, runner::kStack).substr(0, kLongestStack + 1));
  return std::regex_match(line, kAddresses) ? line : "";
}

// Whether glibc reports that its heap data were overwritten.
bool is_about_freed_memory(std::string_view line) {
  for (const char* word : {"free(): ", "malloc(): ", "realloc(): ", "malloc_consolidate(): ",
                           "double free or corruption", "corrupted size", "corrupted double-linked",
                           "munmap_chunk(): ", "stack smashing detected"}) {
    if (line.find(word) != std::string_view::npos) return true;
  }
  return false;
}

// The last line of the text that isn't the runner's.
std::string_view last_words(std::string_view print) {
  print = print.substr(0, print.rfind(runner::kCause));
  while (!print.empty() && print.back() == '\n') print.remove_suffix(1);
  return print.substr(print.rfind('\n') + 1);
}

// --- how it ended ---

Termination of_abort(const Limits& limits, const std::string& print) {
  if (const std::string assertion = assertion_in(print); !assertion.empty()) {
    return {"crashed", "an assertion failed: " + sanitize_line(assertion, 3 * kLongest), "",
            "assertion"};
  }
  const std::string_view thrown =
      up_to(line_after(print, "terminate called after throwing an instance of '"), "'");
  if (thrown == "std::bad_alloc") return out_of_memory(limits);
  if (!thrown.empty()) {
    const std::string what = sanitize_line(line_after(print, "  what():  "), kLongest);
    return {"crashed",
            "the program threw where nothing catches it (before main, in a destructor, in a "
            "noexcept function or in what()): " +
                sanitize_line(thrown, kLongest) + (what.empty() ? "" : ": " + what)};
  }
  const std::string_view words = last_words(print);
  if (is_about_freed_memory(words)) {
    return {"crashed",
            "the program aborted: it wrote beyond the end of its memory, or freed some twice (" +
                sanitize_line(words, kLongest) + ")"};
  }
  return {"crashed", "the program aborted: it called abort() or std::terminate(), perhaps"};
}

std::string of_segmentation_fault(const std::string& cause) {
  const std::string what = "the program crashed with a segmentation fault: ";
  if (cause.empty()) {
    return what +
           "so early that it couldn't say where; global arrays that are too large, or a change of "
           "how signals are handled, do that";
  }
  if (cause == runner::kNull) return what + "it followed a null pointer";
  if (cause == runner::kFullStack) {
    return what + "its stack is full: a recursion without end, or a very large local array";
  }
  return what +
         "it read or wrote memory that isn't its own (an index out of range, or a pointer to what "
         "is gone)";
}

std::string of_refused_call(const std::string& cause) {
  const std::string what = "the program asked the system for what it isn't given: ";
  if (cause.rfind(runner::kCall, 0) != 0) {
    return what + "a process, a thread, a file, a connection";
  }
  return what + what_is_asked_by(std::atol(cause.c_str() + std::strlen(runner::kCall)));
}

std::string of_arithmetic_error(const std::string& cause) {
  const std::string what = "the program crashed with an arithmetic error: ";
  return what + (cause == runner::kFloat
                     ? "it turned floating-point traps on, and an operation set one off"
                     : "an integer division by zero");
}

std::string of_other_signal(int signal) {
  static const std::map<int, std::string> kWords = {
      {SIGILL, "crashed with an illegal instruction: a function that returns no value, perhaps"},
      {SIGBUS, "crashed with a bus error: it touched memory that isn't there"},
      {SIGTRAP, "stopped itself with a trap"},
      {SIGXFSZ, "tried to write a file"},
      {SIGKILL, "was killed: by itself, or by the system for want of memory or time"},
  };
  const auto known = kWords.find(signal);
  if (known != kWords.end()) return "the program " + known->second;
  const char* name = ::sigabbrev_np(signal);
  return "the program was ended by signal " +
         (name ? "SIG" + std::string(name) : std::to_string(signal)) + ", which it sent itself";
}

Termination of_signal(int signal, const Limits& limits, const std::string& print,
                      std::size_t memory) {
  if (signal == SIGXCPU) return out_of_cpu_time(limits, memory);
  if (signal == SIGKILL && was_storing(limits, memory)) return out_of_memory(limits);
  const std::string cause(line_after(print, runner::kCause));
  const std::optional<std::string> found =
      cause.rfind(runner::kFound, 0) == 0
          ? check::words_for_report(std::string_view(cause).substr(std::strlen(runner::kFound)))
          : std::nullopt;
  Termination termination = found               ? Termination{"crashed", *found, "", "sanitizer"}
                            : signal == SIGABRT ? of_abort(limits, print)
                            : signal == SIGSEGV
                                ? Termination{"crashed", of_segmentation_fault(cause)}
                            : signal == SIGFPE ? Termination{"crashed", of_arithmetic_error(cause)}
                            : signal == SIGSYS ? Termination{"crashed", of_refused_call(cause)}
                                               : Termination{"crashed", of_other_signal(signal)};
  if (termination.status == "crashed") termination.stack = stack_in(print);
  return termination;
}

}  // namespace

Termination termination_of(int wait_status, const Limits& limits, const std::string& last_print,
                           std::size_t memory) {
  if (WIFSIGNALED(wait_status)) {
    return of_signal(WTERMSIG(wait_status), limits, last_print, memory);
  }
  const int code = WEXITSTATUS(wait_status);
  if (code > 128 && code < 128 + 65) return of_signal(code - 128, limits, last_print, memory);
  return {"no_answer", "the program ended by itself (exit status " + std::to_string(code) +
                           ") in place of an answer: it called exit(), perhaps"};
}

Termination out_of_cpu_time(const Limits& limits, std::size_t memory) {
  if (was_storing(limits, memory)) {
    return {"out_of_memory", "the program was still storing more when its " +
                                 std::to_string(limits.cpu_seconds) +
                                 " s of CPU time were used up: a loop that stores without end, "
                                 "perhaps"};
  }
  return {"timed_out", "the program used more than " + std::to_string(limits.cpu_seconds) +
                           " s of CPU time: a loop without end, perhaps"};
}

Termination out_of_memory(const Limits& limits) {
  return {"out_of_memory", "the program ran out of memory (" + std::to_string(limits.memory >> 20) +
                               " MB): a size that is wrong, or a loop that stores without end, "
                               "perhaps"};
}

}  // namespace bounce::judge
