"""A fifth part is added to a copy of the kit as CONTRIBUTING.md says, and graded."""

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT

# The new files of the recipe. The part computes the energy of the square, in ten lines.
NEW = {
    "student/include/bounce/part5_energy.hpp": """// Part 5: the energy of the square, J.
#pragma once

#include <bounce/types.hpp>

namespace bounce {

double energy(const Vector3& q, const Vector3& v, const Parameters& params);

}  // namespace bounce
""",
    "student/hints/part5_energy.md": """# Hints for part 5

## 5.1 Both kinds of energy

Checks: part5.AddsKineticAndPotentialEnergy
""",
    "student/src/part5_energy.cpp": """#include <bounce/part5_energy.hpp>

namespace bounce {

double energy(const Vector3&, const Vector3&, const Parameters&) { return 0; }

}  // namespace bounce
""",
    "solution/src/part5_energy.cpp": """#include <bounce/part5_energy.hpp>

namespace bounce {

double energy(const Vector3& q, const Vector3& v, const Parameters& params) {
  return 0.5 * v.dot(params.M() * v) - params.m * params.g.dot(q);
}

}  // namespace bounce
""",
    "tests/parts/part5_energy_test.cpp": """#include <gtest/gtest.h>

#include "answers.hpp"
#include "cases.hpp"
#include "submission.hpp"

namespace bounce::tests {
namespace {

double asked(const Case& c) { return submission::energy(c.q, c.v, c.params); }

[[maybe_unused]] const bool kPart5IsRegistered =
    register_call(5, [](const Case& c) -> Eigen::VectorXd {
      return Eigen::VectorXd::Constant(1, asked(c));
    });

TEST(part5, AddsKineticAndPotentialEnergy) {
  for_each_case([](const Case& c) { return compare(c, "energy", "J", c.energy, asked(c)); });
}

}  // namespace
}  // namespace bounce::tests
""",
    "tests/parts/linked/part5_energy.cpp": """#include <bounce/part5_energy.hpp>

#include "linked.hpp"

namespace bounce::tests {

[[maybe_unused]] const bool part5_is_linked = link_part('5', &Linked::energy, &bounce::energy);

}  // namespace bounce::tests
""",
    "solution/fixtures/part5_cases.cpp": """#include <bounce/part5_energy.hpp>

#include "cases.hpp"
#include "decidable.hpp"

namespace bounce::fixtures {

json part5_cases(const std::string& set, const std::string& secret) {
  RandomNumbers draw(set + secret + "part5");
  json checks;
  checks["part5.AddsKineticAndPotentialEnergy"] = collect(3, [&]() -> std::optional<json> {
    const Parameters params = draw.other_parameters();
    const Vector3 q(draw.either_sign(0.3, 4), draw.between(0.05, 2), draw.between(0.1, 1.4));
    const Vector3 v(draw.either_sign(0.5, 3), draw.either_sign(0.5, 3), draw.either_sign(1, 9));
    return make_case("a flying square", params, {{"q", list(q)}, {"v", list(v)}},
                     {{"energy", written(energy(q, v, params))}});
  });
  return checks;
}

}  // namespace bounce::fixtures
""",
}
# New lines: file, the line before which it is inserted, and the new line.
LINES = [
    (
        "grader/runner/messages.hpp",
        "};\n",
        '    "bounce::energy",\n',
    ),
    (
        "grader/runner/messages.hpp",
        "template <class... Arguments>\n",
        "inline void put(Frame& frame, double x) { frame.values[0] = x; }\n"
        "inline void take(const Frame& frame, double& x) { x = frame.values[0]; }\n\n",
    ),
    (
        "grader/runner/runner.cpp",
        "}  // namespace bounce\n",
        "[[gnu::weak]] double energy(const Vector3& q, const Vector3& v, const Parameters& params);\n",
    ),
    (
        "grader/runner/runner.cpp",
        "    } else if (question.part == 4 && simulate) {\n",
        "    } else if (question.part == 5 && energy) {\n"
        "      frames::answer(question, answer, energy);\n",
    ),
    (
        "grader/judge/submission_remote.cpp",
        "Trajectory simulate(",
        "double energy(const Vector3& q, const Vector3& v, const Parameters& params) {\n"
        "  return ask<double>(5, params, q, v);\n}\n\n",
    ),
    (
        "tests/parts/linked/linked.hpp",
        "  std::string parts;",
        "  double (*energy)(const Vector3& q, const Vector3& v, const Parameters& params) = nullptr;\n",
    ),
    (
        "tests/parts/linked/submission_linked.cpp",
        "Trajectory simulate(",
        "double energy(const Vector3& q, const Vector3& v, const Parameters& params) {\n"
        '  return naming_the_part("part 5", [&] { return linked().energy(q, v, params); });\n}\n\n',
    ),
    (
        "tests/parts/submission.hpp",
        "State step(",
        "double energy(const Vector3& q, const Vector3& v, const Parameters& params);\n",
    ),
    ("tests/parts/cases.hpp", "  Contact contact{", "  double energy = 0;  // expected, part 5\n"),
    (
        "tests/parts/cases.cpp",
        '  if (expected.contains("phi")) {\n',
        '  if (expected.contains("energy")) c.energy = expected.at("energy");\n',
    ),
    (
        "solution/fixtures/cases.hpp",
        "json part4_cases(",
        "json part5_cases(const std::string& set, const std::string& secret);\n",
    ),
    (
        "solution/fixtures/main.cpp",
        '  write(to, "part4_simulate"',
        '  write(to, "part5_energy", part5_cases(set, secret));\n',
    ),
]
MANIFEST = {
    "part": 5,
    "stem": "part5_energy",
    "title": "Energy",
    "function": "energy",
    "points": 10,
    "checks": [
        {
            "id": "part5.AddsKineticAndPotentialEnergy",
            "title": "the energy is kinetic and potential",
            "points": 10,
        }
    ],
}


def copy_with_a_fifth_part(to: Path) -> Path:
    tracked = subprocess.run(
        ["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout.split("\0")
    for name in filter(None, tracked):
        target = to / name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(ROOT / name, target)
    for name, text in NEW.items():
        (to / name).write_text(text)
    for name, before, line in LINES:
        text = (to / name).read_text()
        assert text.count(before) >= 1, f"{name} has no line {before!r} any more"
        (to / name).write_text(text.replace(before, line + before, 1))
    manifest = json.loads((to / "grader/parts.json").read_text())
    manifest["parts"].append(MANIFEST)
    (to / "grader/parts.json").write_text(json.dumps(manifest))
    return to


def kit(copy: Path, *arguments: str) -> str:
    command = [str(copy / "kit"), *arguments]
    environment = {**os.environ, "KIT_NO_INSTALL": "1"}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def points(copy: Path, submission: Path) -> list[Any]:
    record = json.loads(kit(copy, "grade", str(submission), "--json", "-"))
    return [part["score"] for part in record["parts"]]


@pytest.mark.long
def test_a_fifth_part_is_graded_beside_the_four(tmp_path: Path) -> None:
    copy = copy_with_a_fifth_part(tmp_path / "kit")
    kit(copy, "fixtures")
    assert points(copy, copy / "solution" / "src") == [30, 30, 30, 10, 10]
    wrong = shutil.copytree(copy / "solution" / "src", tmp_path / "wrong")
    part = wrong / "part5_energy.cpp"
    part.write_text(part.read_text().replace("0.5 * ", ""))
    assert points(copy, wrong) == [30, 30, 30, 10, 0]
    part.unlink()
    assert points(copy, wrong) == [30, 30, 30, 10, 0]


def test_what_a_fifth_part_adds_compiles(tmp_path: Path) -> None:
    copy = copy_with_a_fifth_part(tmp_path)
    changed = {*NEW, *(name for name, _, _ in LINES)}
    files = [str(copy / name) for name in sorted(changed) if name.endswith(".cpp")]
    include = ["-I", str(copy / "student" / "include"), "-isystem", "/usr/include/eigen3"]
    fixtures = f'-DBOUNCE_FIXTURES="{ROOT / "fixtures" / "public"}"'
    command = ["g++", "-std=c++20", "-fsyntax-only", *include, fixtures, *files]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_the_recipe_names_every_file_that_a_part_needs() -> None:
    recipe = (ROOT / "CONTRIBUTING.md").read_text()
    for name in {*NEW, *(name for name, _, _ in LINES), "grader/parts.json"}:
        assert name.replace("part5_energy", "partN_*").replace("part5_", "partN_") in recipe, name
