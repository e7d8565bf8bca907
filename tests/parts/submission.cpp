#include "submission.hpp"

#include <algorithm>
#include <string>

#include "sentences.hpp"

namespace bounce::submission {

constexpr std::size_t kLongestText = 150;  // bytes; a frame holds a few more

std::string threw(std::uint32_t part, const std::string& text) {
  const std::string who =
      "part " + std::to_string(part) + (part > 2 ? ", or what it calls," : "") + " threw ";
  if (text.empty()) return who + frames::kNoException;
  return who + "an exception: \"" + words::one_line(text, kLongestText) + "\"";
}

void require_columns(Eigen::Index q_columns, Eigen::Index v_columns, int T) {
  if (q_columns == T && v_columns == T) return;
  throw MissingColumns("q is 3x" + std::to_string(q_columns) + " and v is 3x" +
                       std::to_string(v_columns) + "; both should be 3x" + std::to_string(T) +
                       ", as T = " + std::to_string(T));
}

Eigen::Index columns_at_hand(Eigen::Index q_columns, Eigen::Index v_columns, int T) {
  const Eigen::Index columns = std::min({q_columns, v_columns, Eigen::Index{T}});
  if (columns < 1 || columns < T - 1) require_columns(q_columns, v_columns, T);
  return columns;
}

}  // namespace bounce::submission
