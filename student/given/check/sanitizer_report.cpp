#include "sanitizer_report.hpp"

#include <map>

namespace bounce::check {

// The names are those of LLVM's compiler-rt, lib/asan/asan_errors.h and lib/ubsan/ubsan_checks.inc.
std::optional<std::string> words_for_report(std::string_view kind) {
  static const std::map<std::string, std::string, std::less<>> kWords = {
      {"heap-buffer-overflow",
       "it reads or writes beyond the end of a std::vector, a matrix of dynamic size, or memory "
       "from new"},
      {"stack-buffer-overflow", "it reads or writes beyond the end of a local array or object"},
      {"stack-buffer-underflow", "it reads or writes before the begin of a local array or object"},
      {"global-buffer-overflow", "it reads or writes beyond the end of a global array or object"},
      {"dynamic-stack-buffer-overflow", "it reads or writes beyond the end of a local array"},
      {"container-overflow", "it reads or writes beyond the end of a container"},
      {"heap-use-after-free",
       "it uses memory that was freed: of a value that is gone, or a vector that has grown"},
      {"stack-use-after-return", "it uses a local variable of a function that has returned"},
      {"stack-use-after-scope", "it uses a variable that is gone"},
      {"double-free", "it frees the same memory twice"},
      {"attempting double-free", "it frees the same memory twice"},
      {"bad-free", "it frees what it didn't get from new or malloc"},
      {"alloc-dealloc-mismatch", "it frees with delete what it got with new[], or the like"},
      {"calloc-overflow", "it asks for an array of an impossible size"},
      {"allocation-size-too-big", "it asks for more memory than there is: a size is wrong"},
      {"stack-overflow", "its stack is full: a recursion without end, perhaps"},
      {"signed-integer-overflow", "an integer grows beyond what an int can hold"},
      {"integer-divide-by-zero", "it divides an integer by zero"},
      {"float-divide-by-zero", "it divides by zero"},
      {"float-cast-overflow",
       "it makes an integer of a number that is none, or too large for one: NaN or infinity, "
       "perhaps"},
      {"out-of-bounds-index", "an index is out of the bounds of a C array"},
      {"invalid-shift-exponent",
       "it shifts an integer by more bits than it has, or by less than none"},
      {"shift-out-of-bounds",
       "it shifts an integer by more bits than it has, or by less than none"},
      {"null-pointer-use", "it follows a null pointer"},
      {"misaligned-pointer-use", "it follows a pointer that isn't one to such an object"},
      {"insufficient-object-size", "it uses memory as an object that doesn't fit in there"},
      {"nullptr-with-offset", "it counts from a null pointer"},
      {"nullptr-with-nonzero-offset", "it counts from a null pointer"},
      {"nullptr-after-nonzero-offset", "it counts from a null pointer"},
      {"pointer-overflow", "it moves a pointer out of all memory"},
      {"missing-return", "a function ends without returning a value"},
      {"unreachable-call", "it reaches what it said can't be reached"},
      {"non-positive-vla-index", "a local array has a size below 1"},
      {"invalid-bool-load", "it reads a bool that was never set"},
      {"invalid-enum-load", "it reads an enumerator that was never set"},
      {"dynamic-type-mismatch", "it uses an object as one of another class"},
      {"invalid-null-argument", "it passes a null pointer where none may be"},
      {"invalid-null-return", "it returns a null pointer where none may be"},
      {"invalid-builtin-use", "it asks for the leading or trailing zeros of 0"},
  };
  const auto known = kWords.find(kind);
  if (known == kWords.end()) return std::nullopt;
  return known->second;
}

}  // namespace bounce::check
