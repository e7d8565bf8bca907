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

}  // namespace

const std::vector<Row> kBlock{{.part = 2,
                               .sentence = "The 3x3 block of your V is {} in every question.",
                               .targets = "V#",
                               .formula = "{0} {1} {each}",
                               .lists = {kDiagonals, kSteps},
                               .words = "{0} and {1}",
                               .each = "1; -1; 0"},
                              {.part = 2,
                               .sentence = "The 3x3 block of your V is {} in every question.",
                               .targets = "V#",
                               .formula = "(s# / m + t# / {0}) {1} {each}",
                               .lists = {kInertias, kSteps},
                               .words = "{0} for the inertia and {1}",
                               .each = "1; -1; 0"}};

const std::vector<Row> kRows{
    {.part = 1,
     .sentence = "Your arm is the right one, turned by a multiple of ({} - pi) / 4 in every "
                 "question. Often: pi is written with too few digits.",
     .targets = "turn + far",
     .formula = "round(turn / ({0} - pi) 4) ({0} - pi) / 4",
     .lists = {"3.14; 3.141; 3.142; 3.1415; 3.1416; 3.14159"},
     .where = "turn + far"},
    {.part = 1,
     .sentence = "Your answers are those of a square that is turned by {} in every question.",
     .targets = "a2; a5; a6",
     .formula = "-corner_y({0}); corner_x({0}); y + corner_y({0})",
     .lists = {"theta / 2; 2 theta; theta + 45 degrees := theta + pi / 4"},
     .right = "a0; a1; a3; a4"},
    {.part = 1,
     .sentence =
         "Your corner is {} away from the centre in every question, where l/sqrt(2) belongs.",
     .targets = "a2; a5; a6",
     .formula = "-{0} sqrt(2) / l r_y; {0} sqrt(2) / l r_x; y + {0} sqrt(2) / l r_y",
     .lists = {"1; l/4; sqrt(2) l; l^2 / 2; l^2"},
     .right = "a0; a1; a3; a4"},
    {.part = 1,
     .sentence = "Your J_t has the length 1 in every question.",
     .targets = "a0; a1; a2",
     .formula = "r0 / sqrt(1 + r2^2); r1 / sqrt(1 + r2^2); r2 / sqrt(1 + r2^2)"},
    {.part = 1,
     .sentence = "Your J_n has the length 1 in every question.",
     .targets = "a3; a4; a5",
     .formula = "r3 / sqrt(1 + r5^2); r4 / sqrt(1 + r5^2); r5 / sqrt(1 + r5^2)"},
    {.part = 1,
     .sentence = "Your phi is {} in every question.",
     .targets = "a6",
     .formula = "{0}",
     .lists = {kHeights},
     .bounds = "phi"},
    {.part = 1,
     .sentence = "The third entry of your J_t is {} in every question, where -r_y belongs.",
     .targets = "a2",
     .formula = "{0}",
     .lists = {kArms},
     .right = "a0"},
    {.part = 1,
     .sentence = "The third entry of your J_n is {} in every question, where r_x belongs.",
     .targets = "a5",
     .formula = "{0}",
     .lists = {kArms},
     .right = "a4"},
    {.part = 2,
     .sentence = "The last column of your V is {} in every question.",
     .targets = "a12; a13; a14; a15",
     .formula = "{each}; {each}; {each}; {each}",
     .words = "({each})",
     .each = kBorder},
    {.part = 2,
     .sentence = "The last row of your V is {} in every question.",
     .targets = "a3; a7; a11; a15",
     .formula = "{each}; {each}; {each}; {each}",
     .words = "({each})",
     .each = kBorder},
    {.part = 2,
     .sentence = "Your p(0) is J_n^T (v + dt M^-1 f_e), with epsilon J_n^T v only where the corner "
                 "comes down, in every question.",
     .targets = "a16",
     .formula = "v_n + min(0, epsilon v_n) + dt g_n"},
    {.part = 2,
     .sentence = "Your p(0) is {} in every question.",
     .targets = "a16",
     .formula = "{0} v_n + {1} g_n",
     .lists = {kVelocities, kGravities},
     .words = "J_n^T ({0} + {1})",
     .bounds = "p(0)"},
    {.part = 2,
     .sentence = "Your p(1) is {} in every question.",
     .targets = "a17",
     .formula = "{0} v_t + {1} g_t",
     .lists = {kVelocities, kGravities},
     .words = "J_t^T ({0} + {1})",
     .bounds = "p(1)"},
    {.part = 2,
     .sentence = "Your p(2) is {} in every question.",
     .targets = "a18",
     .formula = "{0} v_t + {1} g_t",
     .lists = {kVelocities, kGravities},
     .words = "J_t^T ({0} + {1})",
     .bounds = "p(2)"},
    {.part = 2,
     .sentence = "Your p(3) is {} in every question.",
     .targets = "a19",
     .formula = "{0}",
     .lists = {kBorder}},
    {.part = 3,
     .sentence = "Where a corner touches, your v' is that {}.",
     .targets = "n#",
     .formula = "v# + {0} g# + {each} c#",
     .lists = {kFalls},
     .words = "{0}, and with the forces' change of (v_x, v_y, omega) multiplied by ({each})",
     .each = std::string(kForces) + "; l^2 / ?; m / ?; m l^2 / ?",
     .where = "touching"},
    {.part = 3,
     .sentence = "Where a corner touches, your v' is that with {}.",
     .targets = "n0; n1; n2",
     .formula = "v0 + dt g0 + {1} c0; v1 + dt g1 + {0} c1; v2 + dt g2 + (r_x {0} m c1 - r_y {1} m "
                "c0) / inertia",
     .lists = {kForces, kForces},
     .words = "f_n multiplied by {0} and f_t by {1}",
     .where = "touching",
     .otherwise = true},
    {.part = 3,
     .sentence =
         "Where a corner touches, the moment of your forces, by omega', is {} in every question.",
     .targets = "inertia (n2 - v2 - dt g2)",
     .formula = "{0} m c1 + {1} m c0",
     .lists = {"0; r_x f_n := r_x; -r_x f_n := -r_x; r_y f_n := r_y; -r_y f_n := -r_y",
               "0; r_x f_t := r_x; -r_x f_t := -r_x; r_y f_t := r_y; -r_y f_t := -r_y"},
     .words = "{0} + {1}",
     .where = "touching",
     .right = "n0; n1",
     .otherwise = true},
    {.part = 3,
     .sentence = "In flight, your v' is that {}.",
     .targets = "n#",
     .formula = "v# + {0} g#",
     .lists = {kFalls},
     .where = "flying"},
    {.part = 3,
     .sentence = "",
     .targets = "n0; n1; n2",
     .bounds = "v_x'; v_y'; omega'",
     .otherwise = true},
    {.part = 3, .sentence = "", .targets = "q0 + m0 + dt n0", .right = "n0", .bounds = "x'"},
    {.part = 3, .sentence = "", .targets = "q1 + m1 + dt n1", .right = "n1", .bounds = "y'"},
    {.part = 3, .sentence = "", .targets = "q2 + m2 + dt n2", .right = "n2", .bounds = "theta'"},
    {.part = 3,
     .sentence = "Your theta' differs from the right one by whole turns.",
     .targets = "m2",
     .formula = "r2 + 2 pi round((m2 - r2) / (2 pi))",
     .right = "m0; m1"},
    {.part = 3,
     .sentence = "Your x' is x in every question.",
     .targets = "m0 + dt n0",
     .formula = "0",
     .wrong = "m0; m1; m2"},
    {.part = 3,
     .sentence = "Your y' is y in every question.",
     .targets = "m1 + dt n1",
     .formula = "0",
     .wrong = "m0; m1; m2"},
    {.part = 3,
     .sentence = "Your theta' is theta in every question.",
     .targets = "m2 + dt n2",
     .formula = "0",
     .wrong = "m0; m1; m2"},
    {.part = 3,
     .sentence = "Where a corner touches, your q' is {} in every question.",
     .targets = "m# + dt n#",
     .formula = "{0} + {1}",
     .lists = {kMoves, kLifts},
     .words = "q {0} {1}",
     .where = "touching",
     .wrong = "m0; m1; m2"},
    {.part = 3,
     .sentence = "In flight, your q' is {} in every question.",
     .targets = "m# + dt n#",
     .formula = "{0} + {1}",
     .lists = {kMoves, kLifts},
     .words = "q {0} {1}",
     .where = "flying",
     .wrong = "m0; m1; m2"},
    {.part = 4,
     .sentence = "Your q in columns 1 and 2 is the right one of columns 2 and 3 in every question: "
                 "is q one column ahead?",
     .targets = "a6; a7; a8; a12; a13; a14",
     .formula = "r12; r13; r14; r18; r19; r20",
     .where = "long"},
    {.part = 4,
     .sentence = "Your q in columns 1 and 2 is the right one of columns 0 and 1 in every question: "
                 "is q one column late?",
     .targets = "a6; a7; a8; a12; a13; a14",
     .formula = "r0; r1; r2; r6; r7; r8",
     .where = "long"},
    {.part = 4,
     .sentence = "Your v in columns 1 and 2 is the right one of columns 2 and 3 in every question: "
                 "is v one column ahead?",
     .targets = "a9; a10; a11; a15; a16; a17",
     .formula = "r15; r16; r17; r21; r22; r23",
     .where = "long"},
    {.part = 4,
     .sentence = "Your v in columns 1 and 2 is the right one of columns 0 and 1 in every question: "
                 "is v one column late?",
     .targets = "a9; a10; a11; a15; a16; a17",
     .formula = "r3; r4; r5; r9; r10; r11",
     .where = "long"},
    {.part = 4,
     .sentence = "Your column 0 is {} in every question.",
     .targets = "m#; n#",
     .formula = "{0}; {1}",
     .lists = {kStarts, kStartVelocities},
     .words = "{0}, and {1}"}};

}  // namespace bounce::tests
