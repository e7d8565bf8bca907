// The tests of a build that has the code under test linked in: public fixtures only.
#include <gtest/gtest.h>

#include "../cases.hpp"

std::vector<std::filesystem::path> bounce::tests::fixture_folders() { return {BOUNCE_FIXTURES}; }

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
