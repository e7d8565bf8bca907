// Inputs of a part that make no difference to its answers and should, or the reverse.
#include <algorithm>
#include <array>

#include "findings.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;

constexpr std::size_t kInputs = 10;
using ByInput = std::array<Words, kInputs>;  // names of quantities

// Two questions that differ in one input alone; or in none, which is then kInputs.
struct Pair {
  std::size_t a, b, input;
};

std::vector<Pair> pairs(const Cases& cases) {
  std::vector<Pair> all;
  for (std::size_t a = 0; a < cases.size(); ++a) {
    const std::vector<Input> of_a = inputs_of(cases[a]);
    for (std::size_t b = a + 1; b < cases.size(); ++b) {
      const Case &one = cases[a], &other = cases[b];
      if (one.v != other.v || one.J != other.J || one.params.T != other.params.T) continue;
      const std::vector<Input> of_b = inputs_of(other);
      const auto differ = [](const Input& x, const Input& y) { return x.value != y.value; };
      std::size_t count = 0, input = kInputs;
      for (std::size_t i = 0; i < kInputs; ++i) {
        if (!differ(of_a[i], of_b[i])) continue;
        input = i;
        ++count;
      }
      if (count < 2) all.push_back({a, b, input});
    }
  }
  return all;
}

// Whether two answers differ in a quantity, as far as they have it.
bool differ(const Quantity& quantity, const Answer& a, const Answer& b) {
  return std::any_of(quantity.entries.begin(), quantity.entries.end(), [&](Index i) {
    return i < std::min(a.numbers.size(), b.numbers.size()) && !same(a.numbers(i), b.numbers(i));
  });
}

// Whether a quantity is 0 in all answers: then it isn't filled in, which is said in other words.
bool is_zero(const Quantity& quantity, const Answers& got) {
  return std::all_of(got.begin(), got.end(), [&](const Answer& answer) {
    return std::all_of(quantity.entries.begin(), quantity.entries.end(), [&](Index i) {
      return i >= answer.numbers.size() || answer.numbers(i) == 0;
    });
  });
}

// What was seen of an input and a quantity in all questions that differ in this input alone.
struct Seen {
  bool any = false;
  bool ought_to = false;   // the right answers differ somewhere
  bool responds = false;   // the part's differ somewhere
  bool everywhere = true;  // the part's differ each time
};

// In free flight these make no difference. Where none of them does, the program takes no contact
// step in these questions, which is another mistake.
void leave_out_what_needs_a_contact(ByInput& missing) {
  Words &l = missing[0], &mu = missing[2], &epsilon = missing[3];
  if (l.empty() || mu.empty() || epsilon.empty()) return;
  for (Words* names : {&l, &mu, &epsilon}) names->clear();
}

// One pattern for all inputs that have the same quantities.
void add(Patterns& patterns, ByInput quantities, const std::string& id) {
  const std::vector<Input> inputs = inputs_of({});
  for (std::size_t i = 0; i < kInputs; ++i) {
    const Words changed = quantities[i];
    if (changed.empty()) continue;
    Words names;
    for (std::size_t j = i; j < kInputs; ++j) {
      if (quantities[j] != changed) continue;
      names.push_back(inputs[j].name);
      quantities[j].clear();
    }
    const Words about = names.size() == 1 ? names : Words();
    patterns.push_back({id, {joined(names, " or "), joined(changed)}, about});
  }
}

}  // namespace

bool answers_differ_when_asked_again(const WrongPart& part) {
  const std::vector<Pair> all = pairs(part.cases);
  return std::any_of(all.begin(), all.end(), [&](const Pair& pair) {
    return pair.input == kInputs && !same(part.got[pair.a], part.got[pair.b]);
  });
}

Patterns inputs(const WrongPart& part) {
  ByInput missing, intruding;
  const std::vector<Pair> all = pairs(part.cases);
  for (const Quantity& quantity : quantities(part.part)) {
    if (is_zero(quantity, part.got)) continue;
    std::array<Seen, kInputs + 1> seen;
    for (const auto& [a, b, input] : all) {
      if (!is_finite(part.got[a]) || !is_finite(part.got[b])) continue;
      Seen& of = seen[input];
      const bool ought_to = differ(quantity, part.right[a], part.right[b]);
      const bool responds = differ(quantity, part.got[a], part.got[b]);
      of = {true, of.ought_to || ought_to, of.responds || responds, of.everywhere && responds};
    }
    // Where only a threshold depends on it, no difference may be chance: y, and delta in part 4.
    const std::size_t threshold = part.part == 3 ? 8 : part.part == 4 ? 6 : kInputs;
    // The move of part 3 tells of v', too, where v' doesn't move q.
    const bool is_move = part.part == 3 && quantity.entries[0] == 0;
    for (std::size_t i = 0; i < kInputs; ++i) {
      const auto& [any, ought_to, responds, everywhere] = seen[i];
      if (ought_to && !responds && i != threshold) missing[i].push_back(quantity.name);
      if (any && everywhere && !ought_to && !is_move) intruding[i].push_back(quantity.name);
    }
  }
  if (part.part >= 3) leave_out_what_needs_a_contact(missing);
  Patterns patterns;
  add(patterns, missing, "input_missing");
  add(patterns, intruding, "input_intrudes");
  return patterns;
}

}  // namespace bounce::tests
