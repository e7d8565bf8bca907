// Turns a failed system call into an exception with the reason.
#pragma once

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

namespace bounce::box {

// libseccomp returns -errno, whereas system calls return -1 and set errno.
template <class Result>
Result require(Result result, const std::string& what) {
  if (result >= 0) return result;
  const int why = result == -1 ? errno : -static_cast<int>(result);
  throw std::runtime_error(what + ": " + std::strerror(why));
}

}  // namespace bounce::box
