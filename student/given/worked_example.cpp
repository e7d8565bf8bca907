#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <iostream>

#include "drawing.hpp"

namespace bounce {

void worked_example() {
  const Parameters params{0.2, 0.3, 0.3, 0.5, {0, -9.81, 0}, 0.01, 0.001};  // whatever defaults are
  const Vector3 q(0.5, 0.1255, 0.3), v(3, -1, 2);
  const Eigen::IOFormat rows(6, 0, ", ", "\n", "    ", "");
  const Eigen::IOFormat row(6, Eigen::DontAlignCols, ", ", ", ", "", "", "(", ")");

  const Contact contact = get_contacts(q, params);  // step into your part 1 here
  std::cout << "phi = " << contact.phi << " m                (eq. 4)\n"
            << "J =                              (eq. 6)\n"
            << contact.J.format(rows) << "\n";

  const Lcp lcp = form_lcp(contact.J, v, params);  // part 2
  std::cout << "V =                              (eq. 9)\n"
            << lcp.V.format(rows) << "\np = " << lcp.p.format(row) << "   (eq. 10)\n";

  const State next = step(q, v, params);  // part 3
  std::cout << "v' = " << next.v.format(row) << " m/s, m/s, rad/s   (eq. 13)\n"
            << "q' = " << next.q.format(row) << " m, m, rad   (eq. 14)\n"
            << "The right numbers are in README.md, \"One contact by numbers\".\n";
}

}  // namespace bounce
