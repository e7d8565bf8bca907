// Linked with a submission that is built with g++'s sanitizers: reports what they find as the cause
// of the crash with which they end it.
#include "crash.hpp"

extern "C" {

// The sanitizers' interface: we call the first two functions, and they call the others.
const char* __asan_get_report_description();
void __ubsan_get_current_report_data(const char** kind, const char** message, const char** file,
                                     unsigned* line, unsigned* column, char** address);

void __asan_on_error() { bounce::runner::note_finding(__asan_get_report_description()); }

void __ubsan_on_report() {
  const char *kind = "", *message = "", *file = "";
  unsigned line = 0, column = 0;
  char* address = nullptr;
  __ubsan_get_current_report_data(&kind, &message, &file, &line, &column, &address);
  bounce::runner::note_finding(kind);  // a name that stays valid
}

// The runner's handler gets the faults, because it reports the place; leaks aren't checked.
const char* __asan_default_options() {
  return "abort_on_error=1:handle_segv=0:handle_sigbus=0:handle_sigfpe=0:handle_sigill=0:"
         "disable_coredump=0:detect_leaks=0:symbolize=0:allocator_may_return_null=0:"
         "max_allocation_size_mb=1024:detect_stack_use_after_return=1";
}

const char* __ubsan_default_options() { return "abort_on_error=1:print_stacktrace=0"; }

}  // extern "C"
