// The message about a part that throws, in a student's own build.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "../../parts/linked/thrown.hpp"

namespace bounce::tests {
namespace {

template <class Thrown>
std::string told(const Thrown& what) {
  try {
    naming_the_part("part 1", [&]() -> int { throw what; });
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(thrown, NamesThePartAndSaysWhatItSaid) {
  EXPECT_EQ(told(std::out_of_range("oh")), "part 1 threw an exception: oh");
  EXPECT_EQ(told(std::string("oh")), "part 1 threw: oh");
  EXPECT_EQ(told<const char*>("oh"), "part 1 threw: oh");
  EXPECT_EQ(told(5), "part 1 threw something that isn't a std::exception");
  EXPECT_EQ(naming_the_part("part 1", [] { return 5; }), 5);
}

}  // namespace
}  // namespace bounce::tests
