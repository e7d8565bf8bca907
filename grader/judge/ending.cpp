#include "ending.hpp"

#include <sys/wait.h>

#include <csignal>
#include <map>

#include "../runner/crash.hpp"
#include "assertion.hpp"

namespace bounce::judge {
namespace {

const std::map<int, std::string> kSignals = {
    {SIGSEGV,
     "crashed with a segmentation fault: it read or wrote memory that isn't its own "
     "(a null pointer, an index out of range, or a recursion without end)"},
    {SIGABRT, "aborted"},
    {SIGFPE, "crashed with an arithmetic error, such as an integer division by zero"},
    {SIGILL, "crashed with an illegal instruction (a function that returns no value, perhaps)"},
    {SIGBUS, "crashed with a bus error: it touched memory that isn't there"},
    {SIGTRAP, "stopped itself with a trap"},
    {SIGSYS, "asked the system for what it isn't given: a process, a thread, a connection"},
    {SIGXFSZ, "tried to write a file"},
    {SIGKILL, "was killed"},
    {SIGTERM, "ended itself with SIGTERM"},
};

// The last line of its kind: a submission may print what it likes, but only before it crashes.
std::string stack_in(const std::string& print) {
  const std::size_t at = print.rfind(runner::kStack);
  if (at == std::string::npos) return "";
  const std::size_t from = at + sizeof runner::kStack - 1;
  const std::string line = print.substr(from, print.find('\n', from) - from);
  return line.find_first_not_of(" 0123456789abcdefx") == std::string::npos ? line : "";
}

Ending of_signal(int signal, int cpu_seconds, const std::string& last_print) {
  if (signal == SIGXCPU) {
    return {"timed_out",
            "the program used more than " + std::to_string(cpu_seconds) +
                " s of CPU time: a loop without end, perhaps",
            ""};
  }
  const auto words = kSignals.find(signal);
  std::string sentence =
      "the program " +
      (words == kSignals.end() ? "was ended by signal " + std::to_string(signal) : words->second);
  if (const std::string assertion = assertion_in(last_print); !assertion.empty()) {
    sentence += ": " + assertion;
  }
  return {"crashed", sentence, stack_in(last_print)};
}

}  // namespace

Ending ending_of(int wait_status, int cpu_seconds, const std::string& last_print) {
  if (WIFSIGNALED(wait_status)) return of_signal(WTERMSIG(wait_status), cpu_seconds, last_print);
  const int code = WEXITSTATUS(wait_status);
  if (code > 128 && code < 128 + 65) return of_signal(code - 128, cpu_seconds, last_print);
  return {"no_answer",
          "the program ended by itself (exit status " + std::to_string(code) +
              ") in place of an answer",
          ""};
}

}  // namespace bounce::judge
