// A part's answers to its public cases as a JSON list. Each is a list of numbers, with null for NaN
// and infinity, or the text of an exception.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "../diagnosis/answers.hpp"

namespace bounce::judge {

inline nlohmann::json answers_json(const std::vector<tests::Answer>& answers) {
  using nlohmann::json;
  json all = json::array();
  for (const tests::Answer& answer : answers) {
    json numbers = json::array();
    for (const double x : answer.numbers) {
      numbers.push_back(std::isfinite(x) ? json(x) : json(nullptr));
    }
    all.push_back(answer.thrown.empty() ? numbers : json(answer.thrown));
  }
  return all;
}

inline std::vector<tests::Answer> answers_of(const nlohmann::json& all) {
  std::vector<tests::Answer> answers;
  for (const auto& words : all) {
    tests::Answer answer;
    if (words.is_string()) {
      answer.thrown = words.get<std::string>();
    } else {
      answer.numbers.resize(static_cast<Eigen::Index>(words.size()));
      std::size_t i = 0;
      for (double& x : answer.numbers) {
        x = words[i].is_null() ? NAN : words[i].get<double>();
        ++i;
      }
    }
    answers.push_back(answer);
  }
  return answers;
}

}  // namespace bounce::judge
