#include <bits/stdc++.h>
#include <bounce/part1_contacts.hpp>

using namespace std;
using namespace Eigen;
using namespace bounce;

Contact bounce::get_contacts(const bounce::Vector3& q, const Parameters& params) {
  vector<Vector2d> r;
  for (double x : {-0.5, 0.5})
    for (double y : {-0.5, 0.5})
      r.push_back(params.l * Vector2d(x * cos(q(2)) - y * sin(q(2)), x * sin(q(2)) + y * cos(q(2))));
  sort(r.begin(), r.end(), [](Vector2d a, Vector2d b) { return a(1) < b(1); });

  Contact c;
  c.J << 1, 0,
         0, 1,
         -r[0](1), r[0](0);
  c.phi = q(1) + r[0](1);
  return c;
}
