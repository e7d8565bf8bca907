// The right program of each part and the wrong ones, as steps that work out one number after the
// other; read from fixtures/public/wrong_programs.txt, in which places stand for names.
#pragma once

#include <cmath>
#include <cstddef>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace bounce::examples {

// An input, or what comes out.
struct Quantity {
  std::size_t place;
  std::string name;
  double usual, least, most;  // its value where none is given, and between what it may be
  std::vector<int> parts;     // that have it
};

struct Program {
  int part;
  std::string name;                // "1A"; "-" is the right one
  std::vector<std::size_t> steps;  // in order
};

using Values = std::vector<double>;  // by place

class Table {
 public:
  explicit Table(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string kind;
      words >> kind;
      if (kind == "input" || kind == "output") {
        Quantity quantity;
        words >> quantity.place >> quantity.name >> quantity.usual >> quantity.least >>
            quantity.most;
        quantity.parts = rest_of<int>(words);
        (kind == "input" ? inputs : outputs).push_back(quantity);
      } else if (kind == "step") {
        Step step;
        words >> step.target >> step.kind;
        Product product;
        for (std::size_t n; step.kind == "sum" && words >> product.factor >> n;) {
          product.places.resize(n);
          for (std::size_t& place : product.places) words >> place;
          step.sum.push_back(product);
        }
        step.places = rest_of<std::size_t>(words);
        steps_.push_back(step);
      } else if (kind == "program") {
        Program program;
        words >> program.part >> program.name;
        program.steps = rest_of<std::size_t>(words);
        (program.name == "-" ? right[program.part] : wrong.emplace_back()) = program;
      }
    }
  }

  std::vector<Quantity> inputs, outputs;
  std::map<int, Program> right;  // by part
  std::vector<Program> wrong;

  Values usual_values() const {
    Values values(inputs.size() + steps_.size());
    for (const Quantity& input : inputs) values[input.place] = input.usual;
    return values;
  }

  // All values, worked out from those of the inputs.
  Values run(const Program& program, Values values) const {
    for (const std::size_t at : program.steps) {
      const Step& step = steps_[at];
      values[step.target] = value_of(step, values);
    }
    return values;
  }

 private:
  struct Product {
    double factor;
    std::vector<std::size_t> places;
  };
  struct Step {
    std::size_t target;
    std::string kind;                 // "sum", "cos", "sin", "inverse", "choose"
    std::vector<Product> sum;         // of products
    std::vector<std::size_t> places;  // otherwise
  };

  template <class T>
  static std::vector<T> rest_of(std::istream& line) {
    std::vector<T> all;
    for (T one; line >> one;) all.push_back(one);
    return all;
  }

  static double value_of(const Step& step, const Values& values) {
    const auto at = [&](std::size_t n) { return values[step.places[n]]; };
    if (step.kind == "cos") return std::cos(at(0));
    if (step.kind == "sin") return std::sin(at(0));
    if (step.kind == "inverse") return 1 / at(0);
    if (step.kind == "choose") return at(0) < at(1) ? at(2) : at(3);
    double sum = 0;
    for (const Product& product : step.sum) {
      double term = product.factor;
      for (const std::size_t place : product.places) term *= values[place];
      sum += term;
    }
    return sum;
  }

  std::vector<Step> steps_;
};

}  // namespace bounce::examples
