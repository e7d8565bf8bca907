#include "smallest.hpp"

#include <algorithm>
#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <cmath>
#include <numeric>

#include "../../solution/fixtures/decidable.hpp"

namespace bounce::judge {
namespace {

using fixtures::corner_gap;
using fixtures::mode_of_step;
using tests::Case;
using tests::Check;
using tests::complexity;
using tests::Complexity;
using tests::Entry;
using tests::Problem;
using words::kDegree;

constexpr int kMostQuestions = 200, kMostStarts = 50;
constexpr double kTie = 1e-12, kAlmostATie = 1e-6;  // m, of the two lowest corners
constexpr double kSlowest = 1e-7;                   // m/s, of a corner that slides

// --- the right answers, where correct programs can't differ ---

bool solve_contact(Case& c) {
  c.contact = get_contacts(c.q, c.params);
  c.other_J.reset();
  const double gap = corner_gap(c.q, c.params);
  if (gap < kTie) {
    c.other_J = c.contact.J;
    (*c.other_J)(2, 1) *= -1;
  }
  return gap < kTie || gap > kAlmostATie;
}

bool solve_step(Case& c) {
  c.state = step(c.q, c.v, c.params);
  c.has_decidable_steps = false;
  return mode_of_step({c.q, c.v}, c.params, kSlowest).has_value();
}

bool solve_trajectory(Case& c) {
  c.trajectory = simulate(c.q, c.v, c.params);
  c.has_decidable_steps = false;
  c.columns.clear();
  for (int t = 0; t < c.params.T; ++t) {
    c.columns.push_back(t);
    const State s{c.trajectory.q.col(t), c.trajectory.v.col(t)};
    if (t + 1 < c.params.T && !mode_of_step(s, c.params, kSlowest)) return false;
  }
  return true;
}

bool solve_lcp_of(Case& c) {
  c.lcp = form_lcp(c.J, c.v, c.params);
  return true;
}

// Fills in what is right. Returns whether that is decidable, and the part is known here. An LCP
// that has no solution isn't decidable.
bool solve(Case& c) try {
  c.hidden = false;
  c.corner.clear();
  if (c.check.starts_with("part1")) return solve_contact(c);
  if (c.check.starts_with("part2")) return solve_lcp_of(c);
  if (c.check.starts_with("part3")) return solve_step(c);
  return c.check.starts_with("part4") && solve_trajectory(c);
} catch (const std::exception&) {
  return false;
}

// --- simpler numbers ---

double rounded(double x, int digits) {
  if (x == 0) return 0;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(x))) + 1 - digits);
  const double steps = std::round(x / unit);
  return unit < 1 ? steps / std::round(1 / unit) : steps * unit;
}

// Simpler values of a number, the simplest first.
std::vector<double> simpler(const Entry& number) {
  const double unit = number.is_angle ? kDegree : 1, x = *number.value / unit;
  std::vector<double> all{number.usual};
  if (number.is_angle) {
    for (const double angle : {90.0, 60.0, 45.0, 30.0}) all.push_back(angle * unit);
    for (const double part : {90.0, 60.0, 45.0, 30.0, 10.0})
      all.push_back(std::round(x / part) * part * unit);
  } else {
    for (const double size : {1.0, 0.1}) all.push_back(std::copysign(size, x));
  }
  for (int digits = 1; digits < 8; ++digits) all.push_back(rounded(x, digits) * unit);
  return all;
}

// The case with this value of its number.
Case with(Case c, std::size_t number, double value) {
  *tests::numbers_in(c)[number].value = value;
  return c;
}

// How many numbers two cases of a check differ in.
std::ptrdiff_t distance(Case a, Case b) {
  const auto of_a = tests::numbers_in(a), of_b = tests::numbers_in(b);
  return std::inner_product(of_a.begin(), of_a.end(), of_b.begin(), std::ptrdiff_t{0},
                            std::plus<>(),
                            [](const Entry& x, const Entry& y) { return *x.value != *y.value; });
}

// The case with each number that it shares with `before` as it is `after`.
Case changed_alike(Case c, Case before, Case after) {
  const auto own = tests::numbers_in(c), old = tests::numbers_in(before),
             now = tests::numbers_in(after);
  for (std::size_t i = 0; i < own.size(); ++i)
    if (*own[i].value == *old[i].value) *own[i].value = *now[i].value;
  return c;
}

// The same, with y such that the corner stays as high, in units of delta, in so many digits.
Case with_at_the_same_height(const Case& c, std::size_t number, double value, int digits) {
  const double height = get_contacts(c.q, c.params).phi / c.params.delta;
  Case other = with(c, number, value);
  const double phi = get_contacts(other.q, other.params).phi;
  other.q(1) = rounded(other.q(1) + height * other.params.delta - phi, digits);
  return other;
}

// Whether a case that was made from this one can be shown. One made from a hidden case has none of
// its digits left, as it might have its answer, too: a program can be wrong for this case alone.
bool can_be_shown(const Case& failed, Case c) {
  constexpr int kMostDigits = 2;
  const auto numbers = tests::numbers_in(c);
  return !failed.hidden || std::all_of(numbers.begin(), numbers.end(), [&](const Entry& number) {
    return *number.value == number.usual || tests::digits_of(number) <= kMostDigits;
  });
}

// --- the search ---

class Search {
 public:
  Search(const Begin& begin, const Check& check) : begin_(begin), check_(check) {}

  // What is wrong with the answer to the last of these questions. A new program is asked them all.
  Problem ask_anew(std::vector<Case> questions) {
    const auto program = begin_();
    Problem problem;
    for (Case& c : questions) problem = ask(*program, c);
    return problem;
  }

  Problem ask(Session& program, Case& c) {
    if (!solve(c)) return {};  // not decidable
    ++questions_;
    const tests::Outcome got = tests::ask(program, check_, c);
    if (got.ended) questions_ = kMostQuestions;  // what was found before stands
    if (!got.answer.has_value()) return {};
    return check_.compare(program, c, got.answer);
  }

  // Keeps each change that leaves the case wrong, until none does.
  template <class IsWrong>
  void simplify(Case& c, const IsWrong& is_wrong) {
    const auto take = [&](const Case& changed) {
      const bool better = complexity(changed) < complexity(c) && has_time() && is_wrong(changed);
      if (better) c = changed;
      return better;
    };
    for (Complexity before; before != complexity(c);) {
      before = complexity(c);
      if (c.check.starts_with("part4")) shorten(c, take);
      for (std::size_t i = 0; i < tests::numbers_in(c).size(); ++i) simplify_number(c, i, take);
    }
  }

  // Takes the first simpler value that leaves the case wrong.
  template <class Take>
  static void simplify_number(Case& c, std::size_t i, const Take& take) {
    const Entry number = tests::numbers_in(c)[i];
    const bool changes_height =
        number.is_angle || number.value == &c.params.l || number.value == &c.params.delta;
    const bool keeps_height = changes_height && c.check.starts_with("part3");
    for (const double value : simpler(number)) {
      if (take(with(c, i, value))) return;
      for (const int digits : {3, 4})
        if (keeps_height && take(with_at_the_same_height(c, i, value, digits))) return;
    }
  }

  // Twice as many columns until it is wrong, and then halfway between.
  template <class Take>
  static void shorten(Case& c, const Take& take) {
    int right = 0, T = 1;
    const auto is_taken = [&](int columns) {
      Case shorter = c;
      shorter.params.T = columns;
      return take(shorter);
    };
    while (T < c.params.T && !is_taken(T)) {
      right = T;
      T *= 2;
    }
    while (c.params.T - right > 1) {
      const int halfway = (right + c.params.T) / 2;
      if (!is_taken(halfway)) right = halfway;
    }
  }

  std::optional<words::Smallest> of_one(Case c) {
    const auto program = begin_();
    const Case failed = c;
    simplify(c, [&](Case changed) { return !ask(*program, changed).differences.empty(); });
    return can_be_shown(failed, c) ? shown({c}) : std::nullopt;
  }

  // Of a case that is wrong only after another: itself with the assignment's parameters, or one of
  // these, the most similar first.
  std::optional<words::Smallest> of_two(Case c, std::vector<Case> before) {
    const Case failed = c;
    before.push_back(c);
    before.back().params = {.T = c.params.T};
    std::stable_sort(before.begin(), before.end(),
                     [&](const Case& a, const Case& b) { return distance(a, c) < distance(b, c); });
    const auto is_wrong_after = [&](const Case& first, const Case& second) {
      ++starts_;
      return !ask_anew({first, second}).differences.empty();
    };
    for (Case first : before) {
      if (starts_ * 4 > kMostStarts) break;
      if (!is_wrong_after(first, c)) continue;
      // A number that both share may be why: it is changed in both, and only then in one.
      simplify(c, [&](const Case& changed) {
        const Case both = changed_alike(first, c, changed);
        const bool is_wrong = is_wrong_after(both, changed);
        if (is_wrong) first = both;
        return is_wrong;
      });
      simplify(c, [&](const Case& changed) { return is_wrong_after(first, changed); });
      simplify(first, [&](const Case& changed) { return is_wrong_after(changed, c); });
      return can_be_shown(failed, c) ? shown({first, c}) : std::nullopt;
    }
    return {};
  }

 private:
  const Begin& begin_;
  const Check& check_;
  int questions_ = 0, starts_ = 0;

  bool has_time() const { return questions_ < kMostQuestions && starts_ < kMostStarts; }

  std::optional<words::Smallest> shown(std::vector<Case> questions) {
    const Problem problem = ask_anew(questions);
    if (problem.differences.empty()) return {};
    Case& c = questions.back();
    solve(c);
    auto found = tests::smallest_of(*begin_(), c, problem);
    if (questions.size() == 2) found.before = tests::question_of(questions[0]);
    return found;
  }
};

}  // namespace

std::optional<words::Smallest> smallest(const Begin& begin, const Check& check, const Case& failed,
                                        const std::vector<Case>& before) {
  Search search(begin, check);
  const bool is_wrong_alone = !search.ask_anew({failed}).differences.empty();
  return is_wrong_alone ? search.of_one(failed) : search.of_two(failed, before);
}

}  // namespace bounce::judge
