#include "formula_table.hpp"

namespace bounce::tests {
namespace {

constexpr const char* kHeights =
    "0; y, the height of the centre := y; y - l/2; y - l; y - l/sqrt(2); "
    "the height of the middle of the lowest side := "
    "y - l/2 max(abs(cos(theta)), abs(sin(theta))); "
    "y - (l/2) |cos(theta)| := y - (l/2) abs(cos(theta)); "
    "y - (l/sqrt(2)) |cos(theta)| := y - (l/sqrt(2)) abs(cos(theta)); "
    "y - (l/2) (cos(theta) + sin(theta)); -phi; the absolute value of phi := abs(phi); "
    "max(0, phi); max(0, -phi); min(delta, phi); min(l, phi); phi - delta; r_y; -r_y; "
    "x + r_x, the x of the corner := x + r_x; x + r_y; y + r_x; "
    "y - r_y, the height of the highest corner := y - r_y; y + 2 r_y";

constexpr const char* kArms =
    "r_x; -r_x; r_y; -r_y; 0; the absolute value of r_x := abs(r_x); "
    "y, the height of the centre := y; -y; phi; -phi; x + r_x";

constexpr const char* kBorder = "0; 1; -1; mu; -mu; 2 mu; dt; mu dt; -dt; epsilon";

constexpr const char* kVelocities =
    "0; v := 1; -v := -1; epsilon v := epsilon; -epsilon v := -epsilon; "
    "(1 + epsilon) v := 1 + epsilon; -(1 + epsilon) v := -1 - epsilon; "
    "(1 - epsilon) v := 1 - epsilon; (1 + sqrt(epsilon)) v := 1 + sqrt(epsilon); "
    "(1 + epsilon^2) v := 1 + epsilon^2; mu v := mu; (1 + mu) v := 1 + mu; (1 - mu) v := 1 - mu; "
    "m v := m; 2 v := 2";

constexpr const char* kGravities =
    "0; dt M^-1 f_e := dt; -dt M^-1 f_e := -dt; 2 dt M^-1 f_e := 2 dt; M^-1 f_e := 1; "
    "dt^2 M^-1 f_e := dt^2; (1 + epsilon) dt M^-1 f_e := (1 + epsilon) dt; "
    "-(1 + epsilon) dt M^-1 f_e := -(1 + epsilon) dt; epsilon dt M^-1 f_e := epsilon dt; "
    "m dt M^-1 f_e := m dt; dt M^-2 f_e := dt/m; m^2 dt M^-1 f_e := m^2 dt";

// Entries of V's block are (s / m + t / inertia) dt, eq. (11).
constexpr const char* kDiagonals =
    "the right M^-1 := s# / m + t# / inertia; M for M^-1 := s# m + t# inertia; the identity for "
    "M^-1 := s# + t#; "
    "0 for the last entry of M^-1 := s# / m";

constexpr const char* kInertias =
    "m l^2 / 24; 2 m l^2 / 3; m l^2 / 12; m l^2 / 8; m l^2 / 4; m l^2 / 3; m l^2 / 2; "
    "2 m l^2 / 5; m l^2; m l / 6; m l / sqrt(6); l^2 / 6; m; 6 / (m l^2)";

constexpr const char* kSteps =
    "dt for dt := dt; 1 for dt := 1; dt^2 for dt := dt^2; dt / 2 for dt := dt / 2; 1/dt for dt := "
    "1/dt";

// Gravity's part of v', by what g is multiplied by.
constexpr const char* kFalls =
    " := dt; without gravity := 0; with twice gravity := 2 dt; with gravity upwards := -dt; "
    "with gravity not multiplied by dt := 1; with gravity multiplied by dt^2 := dt^2; "
    "with half of gravity := dt / 2; with m g in place of g := m dt; "
    "with g / m in place of g := dt / m";

constexpr const char* kForces =
    "1; 0; -1; 2; 1/2; 1/dt; dt; m; m^2; m r_g^2 := inertia; (m r_g^2)^2 := inertia^2; "
    "r_g^2 := l^2 / 6; mu; epsilon";

constexpr const char* kMoves =
    "+ dt v' := dt n#; + dt v := dt v#; + dt (v + v') / 2 := dt (v# + n#) / 2; "
    "+ dt (v + dt M^-1 f_e) := dt (v# + dt g#); "
    "+ dt v + dt^2/2 M^-1 f_e := dt v# + dt^2 / 2 g#; "
    "+ dt v' + dt^2/2 M^-1 f_e := dt n# + dt^2 / 2 g#; + v' := n#; := 0";

constexpr const char* kLifts =
    " := 0; + (0, delta, 0) := delta y#; - (0, delta, 0) := -delta y#; "
    "+ (0, 2 delta, 0) := 2 delta y#; + (delta, 0, 0) := delta x#; + (0, 0, delta) := delta z#; "
    "+ (delta, delta, delta) := delta; + (delta, delta, 0) := delta (x# + y#); "
    "+ dt (0, delta, 0) := dt delta y#; + (0, -phi, 0) := -phi y#; "
    "+ (0, delta - phi, 0) := (delta - phi) y#; "
    "+ (0, delta + max(0, -phi), 0) := (delta + max(0, -phi)) y#";

// The moves and the velocities that may stand in column 0.
constexpr const char* kStarts =
    "q_0 := q#; q_0 in reverse order := theta x# + y y# + x z#; "
    "q_0 with theta multiplied by pi / 180 := q# (x# + y# + pi / 180 z#); "
    "q_0 with theta multiplied by 180 / pi := q# (x# + y# + 180 / pi z#)";
constexpr const char* kStartVelocities =
    "v_0 := v#; v_0 + dt/2 M^-1 f_e := v# + dt/2 g#; v_0 + dt M^-1 f_e := v# + dt g#; -v_0 := -v#";

const std::vector<Row> kRows1{
    {.where = "turn + far",
     .numbers = "turn + far = round(turn / ({0} - pi) 4) ({0} - pi) / 4",
     .lists = {"3.14; 3.141; 3.142; 3.1415; 3.1416; 3.14159"},
     .sentence = "Your arm is the right one, turned by a multiple of ({} - pi) / 4 in every "
                 "question. Often: pi is written with too few digits."},
    {.right = "a0; a1; a3; a4",
     .numbers = "a2 = -corner_y({0}); a5 = corner_x({0}); a6 = y + corner_y({0})",
     .lists = {"theta / 2; 2 theta; theta + 45 degrees := theta + pi / 4"},
     .sentence = "Your answers are those of a square that is turned by {} in every question."},
    {.right = "a0; a1; a3; a4",
     .numbers = "a2 = -{0} sqrt(2) / l r_y; a5 = {0} sqrt(2) / l r_x; a6 = y + {0} sqrt(2) / l r_y",
     .lists = {"1; l/4; sqrt(2) l; l^2 / 2; l^2"},
     .sentence =
         "Your corner is {} away from the centre in every question, where l/sqrt(2) belongs."},
    {.numbers = "a0 = r0 / sqrt(1 + r2^2); a1 = r1 / sqrt(1 + r2^2); a2 = r2 / sqrt(1 + r2^2)",
     .sentence = "Your J_t has the length 1 in every question."},
    {.numbers = "a3 = r3 / sqrt(1 + r5^2); a4 = r4 / sqrt(1 + r5^2); a5 = r5 / sqrt(1 + r5^2)",
     .sentence = "Your J_n has the length 1 in every question."},
    {.numbers = "a6 = {0}",
     .lists = {kHeights},
     .bounds = "phi",
     .sentence = "Your phi is {} in every question."},
    {.right = "a0",
     .numbers = "a2 = {0}",
     .lists = {kArms},
     .sentence = "The third entry of your J_t is {} in every question, where -r_y belongs."},
    {.right = "a4",
     .numbers = "a5 = {0}",
     .lists = {kArms},
     .sentence = "The third entry of your J_n is {} in every question, where r_x belongs."}};

const std::vector<Row> kRows2{
    {.numbers = "a12 = {each}; a13 = {each}; a14 = {each}; a15 = {each}",
     .words = "({each})",
     .each = kBorder,
     .sentence = "The last column of your V is {} in every question."},
    {.numbers = "a3 = {each}; a7 = {each}; a11 = {each}; a15 = {each}",
     .words = "({each})",
     .each = kBorder,
     .sentence = "The last row of your V is {} in every question."},
    {.numbers = "a16 = v_n + min(0, epsilon v_n) + dt g_n",
     .sentence = "Your p(0) is J_n^T (v + dt M^-1 f_e), with epsilon J_n^T v only where the corner "
                 "comes down, in every question."},
    {.numbers = "a16 = {0} v_n + {1} g_n",
     .words = "J_n^T ({0} + {1})",
     .lists = {kVelocities, kGravities},
     .bounds = "p(0)",
     .sentence = "Your p(0) is {} in every question."},
    {.numbers = "a17 = {0} v_t + {1} g_t",
     .words = "J_t^T ({0} + {1})",
     .lists = {kVelocities, kGravities},
     .bounds = "p(1)",
     .sentence = "Your p(1) is {} in every question."},
    {.numbers = "a18 = {0} v_t + {1} g_t",
     .words = "J_t^T ({0} + {1})",
     .lists = {kVelocities, kGravities},
     .bounds = "p(2)",
     .sentence = "Your p(2) is {} in every question."},
    {.numbers = "a19 = {0}", .lists = {kBorder}, .sentence = "Your p(3) is {} in every question."}};

const std::vector<Row> kRows3{
    {.where = "touching",
     .numbers = "n# = v# + {0} g# + {each} c#",
     .words = "{0}, and with the forces' change of (v_x, v_y, omega) multiplied by ({each})",
     .lists = {kFalls},
     .each = std::string(kForces) + "; l^2 / ?; m / ?; m l^2 / ?",
     .sentence = "Where a corner touches, your v' is that {}."},
    {.where = "touching",
     .numbers = "n0 = v0 + dt g0 + {1} c0; n1 = v1 + dt g1 + {0} c1; n2 = v2 + dt g2 + (r_x {0} m "
                "c1 - r_y {1} m c0) / inertia",
     .words = "f_n multiplied by {0} and f_t by {1}",
     .lists = {kForces, kForces},
     .otherwise = true,
     .sentence = "Where a corner touches, your v' is that with {}."},
    {.where = "touching",
     .right = "n0; n1",
     .numbers = "inertia (n2 - v2 - dt g2) = {0} m c1 + {1} m c0",
     .words = "{0} + {1}",
     .lists = {"0; r_x f_n := r_x; -r_x f_n := -r_x; r_y f_n := r_y; -r_y f_n := -r_y",
               "0; r_x f_t := r_x; -r_x f_t := -r_x; r_y f_t := r_y; -r_y f_t := -r_y"},
     .otherwise = true,
     .sentence =
         "Where a corner touches, the moment of your forces, by omega', is {} in every question."},
    {.where = "flying",
     .numbers = "n# = v# + {0} g#",
     .lists = {kFalls},
     .sentence = "In flight, your v' is that {}."},
    {.numbers = "n0; n1; n2", .bounds = "v_x'; v_y'; omega'", .otherwise = true},
    {.right = "n0", .numbers = "q0 + m0 + dt n0", .bounds = "x'"},
    {.right = "n1", .numbers = "q1 + m1 + dt n1", .bounds = "y'"},
    {.right = "n2", .numbers = "q2 + m2 + dt n2", .bounds = "theta'"},
    {.right = "m0; m1",
     .numbers = "m2 = r2 + 2 pi round((m2 - r2) / (2 pi))",
     .sentence = "Your theta' differs from the right one by whole turns."},
    {.wrong = "m0; m1; m2",
     .numbers = "m0 + dt n0 = 0",
     .sentence = "Your x' is x in every question."},
    {.wrong = "m0; m1; m2",
     .numbers = "m1 + dt n1 = 0",
     .sentence = "Your y' is y in every question."},
    {.wrong = "m0; m1; m2",
     .numbers = "m2 + dt n2 = 0",
     .sentence = "Your theta' is theta in every question."},
    {.where = "touching",
     .wrong = "m0; m1; m2",
     .numbers = "m# + dt n# = {0} + {1}",
     .words = "q {0} {1}",
     .lists = {kMoves, kLifts},
     .sentence = "Where a corner touches, your q' is {} in every question."},
    {.where = "flying",
     .wrong = "m0; m1; m2",
     .numbers = "m# + dt n# = {0} + {1}",
     .words = "q {0} {1}",
     .lists = {kMoves, kLifts},
     .sentence = "In flight, your q' is {} in every question."}};

const std::vector<Row> kRows4{
    {.where = "long",
     .numbers = "a6 = r12; a7 = r13; a8 = r14; a12 = r18; a13 = r19; a14 = r20",
     .sentence = "Your q in columns 1 and 2 is the right one of columns 2 and 3 in every question: "
                 "is q one column ahead?"},
    {.where = "long",
     .numbers = "a6 = r0; a7 = r1; a8 = r2; a12 = r6; a13 = r7; a14 = r8",
     .sentence = "Your q in columns 1 and 2 is the right one of columns 0 and 1 in every question: "
                 "is q one column late?"},
    {.where = "long",
     .numbers = "a9 = r15; a10 = r16; a11 = r17; a15 = r21; a16 = r22; a17 = r23",
     .sentence = "Your v in columns 1 and 2 is the right one of columns 2 and 3 in every question: "
                 "is v one column ahead?"},
    {.where = "long",
     .numbers = "a9 = r3; a10 = r4; a11 = r5; a15 = r9; a16 = r10; a17 = r11",
     .sentence = "Your v in columns 1 and 2 is the right one of columns 0 and 1 in every question: "
                 "is v one column late?"},
    {.numbers = "m# = {0}; n# = {1}",
     .words = "{0}, and {1}",
     .lists = {kStarts, kStartVelocities},
     .sentence = "Your column 0 is {} in every question."}};

}  // namespace

const std::vector<Row> kBlock{{.numbers = "V# = {0} {1} {each}",
                               .words = "{0} and {1}",
                               .lists = {kDiagonals, kSteps},
                               .each = "1; -1; 0",
                               .sentence = "The 3x3 block of your V is {} in every question."},
                              {.numbers = "V# = (s# / m + t# / {0}) {1} {each}",
                               .words = "{0} for the inertia and {1}",
                               .lists = {kInertias, kSteps},
                               .each = "1; -1; 0",
                               .sentence = "The 3x3 block of your V is {} in every question."}};

const std::map<int, std::vector<Row>> kRows{{1, kRows1}, {2, kRows2}, {3, kRows3}, {4, kRows4}};

}  // namespace bounce::tests
