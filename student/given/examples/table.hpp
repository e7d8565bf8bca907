// The right program of each part and the wrong ones, as steps that work out one number after the
// other; read from fixtures/public/wrong_programs.txt, in which places stand for names.
#pragma once

#include <cstddef>
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
  explicit Table(const std::string& text);

  std::vector<Quantity> inputs, outputs;
  std::vector<Program> programs;

  Values usual_values() const;
  // All values, worked out from those of the inputs.
  Values run(const Program& program, Values values) const;

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
  double value_of(const Step& step, const Values& values) const;

  std::vector<Step> steps_;
};

}  // namespace bounce::examples
