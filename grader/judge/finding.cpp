#include "finding.hpp"

#include <map>
#include <sstream>

#include "one_line.hpp"

namespace bounce::judge {

namespace {

// UBSan's message without addresses, which say nothing and differ each time.
std::string without_addresses(const std::string& message) {
  std::string kept;
  std::istringstream words(message);
  for (std::string word; words >> word;) {
    if (word.rfind("0x", 0) != 0) kept += " " + word;
  }
  return kept;
}

}  // namespace

// The names are those of LLVM's compiler-rt, lib/asan/asan_errors.h.
std::string what_was_found(const std::string& finding) {
  static const std::map<std::string, std::string> kWords = {
      {"heap-buffer-overflow",
       "it reads or writes beyond the end of a std::vector, a matrix of dynamic size, or memory "
       "from new"},
      {"stack-buffer-overflow", "it reads or writes beyond the end of a local array or object"},
      {"stack-buffer-underflow", "it reads or writes before the begin of a local array or object"},
      {"global-buffer-overflow", "it reads or writes beyond the end of a global array or object"},
      {"dynamic-stack-buffer-overflow", "it reads or writes beyond the end of a local array"},
      {"container-overflow", "it reads or writes beyond the end of a container"},
      {"heap-use-after-free", "it uses memory that was freed: of a vector that has grown, perhaps"},
      {"stack-use-after-return", "it uses a local variable of a function that has returned"},
      {"stack-use-after-scope",
       "it uses a variable that is gone: `auto` for an expression of Eigen's keeps references to "
       "temporary values, for one"},
      {"double-free", "it frees the same memory twice"},
      {"attempting double-free", "it frees the same memory twice"},
      {"bad-free", "it frees what it didn't get from new or malloc"},
      {"alloc-dealloc-mismatch", "it frees with delete what it got with new[], or the like"},
      {"calloc-overflow", "it asks for an array of an impossible size"},
      {"allocation-size-too-big", "it asks for more memory than there is: a size is wrong"},
      {"stack-overflow", "its stack is full: a recursion without end, perhaps"},
  };
  const auto known = kWords.find(finding);
  return known != kWords.end() ? known->second
                               : "undefined behaviour:" + one_line(without_addresses(finding), 160);
}

}  // namespace bounce::judge
