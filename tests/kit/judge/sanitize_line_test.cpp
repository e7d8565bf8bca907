// Turning a submission's text into one line of printable characters.
#include "../../../grader/judge/sanitize_line.hpp"

#include <gtest/gtest.h>

#include <string>

namespace bounce::tests {
namespace {

using judge::sanitize_line;
using namespace std::string_literals;

constexpr std::size_t kRoom = 1000;
const std::string kMark = "\xEF\xBF\xBD";

TEST(SanitizeLine, KeepsWhatPrints) {
  for (const std::string text :
       {"", "q is 3x149", "Übung ½ θ → 日本 🙂", "<b>&amp;=1+1,;"}) {
    EXPECT_EQ(sanitize_line(text, kRoom), text);
  }
}

TEST(SanitizeLine, MakesLineBreaksAndTabsBlanks) {
  EXPECT_EQ(sanitize_line("a\nb\r\tc", kRoom), "a b  c");
}

TEST(SanitizeLine, ReplacesControls) {
  EXPECT_EQ(sanitize_line("\x1b[2J\a\x7f", kRoom), kMark + "[2J" + kMark + kMark);
  EXPECT_EQ(sanitize_line("a\0b"s, kRoom), "a" + kMark + "b");
  EXPECT_EQ(sanitize_line("\u009b31m", kRoom), kMark + "31m");
}

TEST(SanitizeLine, ReplacesMarksThatTurnTheDirection) {
  EXPECT_EQ(sanitize_line("\u202egnorw\u2066\u200f\ufeff\u2028", kRoom),
            kMark + "gnorw" + kMark + kMark + kMark + kMark);
}

TEST(SanitizeLine, ReplacesEachByteThatIsNoUtf8) {
  EXPECT_EQ(sanitize_line("Gr\xf6\xdf"
                          "e",
                          kRoom),
            "Gr" + kMark + kMark + "e");                                   // Latin-1
  EXPECT_EQ(sanitize_line("\xc0\xaf", kRoom), kMark + kMark);              // overlong
  EXPECT_EQ(sanitize_line("\xed\xa0\x80", kRoom), kMark + kMark + kMark);  // a surrogate
  EXPECT_EQ(sanitize_line("\xf4\x90\x80\x80", kRoom),
            kMark + kMark + kMark + kMark);                    // past the last
  EXPECT_EQ(sanitize_line("\xe2\x82", kRoom), kMark + kMark);  // cut off
}

TEST(SanitizeLine, CutsBetweenCharacters) {
  EXPECT_EQ(sanitize_line("θθθθ", 3), "θθθ...");
  EXPECT_EQ(sanitize_line("θθθ", 3), "θθθ");
}

}  // namespace
}  // namespace bounce::tests
