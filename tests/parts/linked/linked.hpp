// The functions under test that are linked into a student's own test program. A program has those
// of one part; each linked/<stem>.cpp enters its own, and the others stay null.
#pragma once

#include <bounce/types.hpp>
#include <string>

namespace bounce::tests {

struct Linked {
  Contact (*get_contacts)(const Vector3& q, const Parameters& params) = nullptr;
  Lcp (*form_lcp)(const Jacobian& J, const Vector3& v, const Parameters& params) = nullptr;
  State (*step)(const Vector3& q, const Vector3& v, const Parameters& params) = nullptr;
  Trajectory (*simulate)(const Vector3& q_0, const Vector3& v_0,
                         const Parameters& params) = nullptr;
  std::string parts;  // "134": the numbers of the parts that are linked in
};

Linked& linked();

// For a variable's initializer: enters a part's function, and returns true.
template <class Function>
bool link_part(char part, Function* Linked::*place, Function* function) {
  linked().*place = function;
  linked().parts += part;
  return true;
}

}  // namespace bounce::tests
