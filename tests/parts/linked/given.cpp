#include "given.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "../cases.hpp"

namespace bounce::tests {
namespace {

using Numbers = std::vector<double>;
using Table = std::map<Numbers, Numbers>;  // answers by questions
using json = nlohmann::ordered_json;

// Rows of a question and its answer, which has so many numbers.
Table read_rows(const json& rows, std::ptrdiff_t length_of_answer) {
  Table table;
  for (const json& row : rows) {
    const auto numbers = row.get<Numbers>();
    const auto answer = numbers.end() - length_of_answer;
    table.emplace(Numbers(numbers.begin(), answer), Numbers(answer, numbers.end()));
  }
  return table;
}

// Trajectories: parameters, then states, each of which is the answer to the one before.
Table read_states(const json& trajectories) {
  Table table;
  for (const json& rows : trajectories) {
    const auto columns = rows.get<std::vector<Numbers>>();
    for (std::size_t t = 1; t + 1 < columns.size(); ++t) {
      Numbers question = columns[0];
      question.insert(question.end(), columns[t].begin(), columns[t].end());
      table.emplace(question, columns[t + 1]);
    }
  }
  return table;
}

std::vector<Table> read_tables() {
  std::ifstream in(fixture_folders().at(0) / "given.json");
  const json given = json::parse(in);
  return {read_rows(given.at("part1"), 7), read_rows(given.at("part2"), 20),
          read_states(given.at("part3"))};
}

}  // namespace

const double* given_answer(int part, const std::vector<double>& question) {
  static const std::vector<Table> tables = read_tables();
  const Table& table = tables.at(static_cast<std::size_t>(part - 1));
  const bool is_finite =
      std::all_of(question.begin(), question.end(), [](double x) { return std::isfinite(x); });
  const auto found = is_finite ? table.find(question) : table.end();
  if (found != table.end()) return found->second.data();
  asked_what_is_not_recorded = true;
  throw std::runtime_error("an earlier part is asked what no right part asks");
}

}  // namespace bounce::tests
