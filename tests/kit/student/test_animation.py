"""The given animation in a real browser: what a reader of the page can do with it, and sees."""

from __future__ import annotations

import math
import subprocess
from pathlib import Path
from typing import Any

import golden
import pytest
from animation_page import PATIENCE, PROGRAM, Open, animation
from animation_page import file, open_page, scene, with_animation
from selenium.webdriver.common.keys import Keys

pytestmark = pytest.mark.xdist_group("browser")
TABLES = Path(__file__).with_name("animation.toml")
LAYOUT = """
const drawn = byId("ground").getBBox().width - byId("stage").clientWidth; // 9 more on each side
return {
  screen: [innerWidth, innerHeight, devicePixelRatio, drawn],
  width: document.documentElement.scrollWidth,
  side: l * camera().scale, // of the square, in the picture
  background: getComputedStyle(document.body).backgroundColor,
};
"""
# How many numbers of the grid reach beyond the picture's upper edge, from low motions to high ones.
CUT = """
return Array.from(Array(80), (_, i) => {
  const heights = q[1].map((y) => 1.04 * y);
  present({ l, dt, delta, q: [q[0], heights, q[2]], motion: null });
  return [...byId("grid").querySelectorAll("text")].filter((text) => text.getBBox().y < 0).length;
}).reduce((a, b) => a + b);
"""
# Of the lines of each plot: its name and how it is drawn.
LINES = """
return plotted.map(({ chart, svg }) => chart.lines.map(({ name }, i) => {
  const curve = svg.querySelectorAll(".curve")[i];
  return [name, getComputedStyle(curve).strokeDasharray, curve.getAttribute("d").length];
}));
"""


@pytest.mark.parametrize("row", golden.rows(TABLES, "program"))
def test_the_program_says_where_the_page_is_or_what_went_wrong(
    tmp_path: Path, row: dict[str, Any]
) -> None:
    command, status = [str(PROGRAM), *row["words"].split()], row["status"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=PATIENCE)
    said, other = (done.stderr, done.stdout) if status else (done.stdout, done.stderr)
    assert (done.returncode, other) == (status, "")
    assert said.startswith(row["says"].replace("FOLDER", str(tmp_path)))
    assert [file.name for file in tmp_path.iterdir()] == ([] if status else ["animation.html"])


# ---- time ----


def test_moves_on_by_time_at_a_speed_in_a_loop(open_page: Open) -> None:
    for speed, frames, expected in golden.table(TABLES)["time"]["rows"]:
        page = open_page()
        page.choose(speed)
        page.pass_time(0, *frames)
        assert page.number("time") == pytest.approx(expected, abs=0.011), (speed, frames)
        assert page.playing()


def test_obeys_the_keyboard_and_leaves_a_control_its_keys(open_page: Open) -> None:
    page = open_page()
    page.media(prefers_reduced_motion="reduce")  # then it starts paused
    page.driver.refresh()
    page.pass_time(0, 0.5)
    assert (page.playing(), page.column()) == (False, 0)
    page.press(Keys.SPACE)
    page.pass_time(0, 0.5)
    assert page.column() > 0
    for keys, plays, column in golden.table(TABLES)["keys"]["rows"]:
        page.press(*(getattr(Keys, key) for key in keys.split()))
        assert (page.playing(), page.column()) == (plays, column), keys
    assert page.find("speed").get_attribute("value") == "2"
    value = page.find("slider").get_attribute("aria-valuetext")
    assert value == "step 1 of 149, 0.01 seconds"
    assert page.find("slider").accessible_name == "Time step"
    assert "square" in page.find("stage").accessible_name


def test_fits_every_screen_and_takes_its_colours(open_page: Open) -> None:
    page = open_page()

    def layout() -> dict[str, Any]:
        return dict(page.driver.execute_script(LAYOUT))

    for width, height, ratio in [(320, 900, 1), (375, 667, 2), (844, 390, 2), (1600, 1000, 1)]:
        page.screen(width, height, ratio)
        page.wait_until(lambda: layout()["screen"] == [width, height, ratio, 18])
        now = layout()
        assert now["width"] <= width and page.find("plots").size["height"] >= 200
        assert page.pixels("square") > 100 and (height < 600 or now["side"] >= 59.9)
        if width == 375:  # on a phone the numbers come last, and the first plot is in view
            plots, numbers = page.find("plots").rect, page.find("numbers").rect
            assert plots["y"] + plots["height"] < numbers["y"] and plots["y"] + 200 < height
    assert page.driver.execute_script(CUT) == 0
    page.media(prefers_color_scheme="dark")
    page.wait_until(lambda: page.pixels("square") > 50)  # the dark scheme's blue
    assert layout()["background"] != now["background"]


# ---- numbers, forces, plots, and the true motion ----


def distance(scene: dict[str, Any], t: int) -> float:
    """phi of column t, eqs. (3) and (4)."""
    theta = scene["q"][2][t]
    arms = (math.sin(theta + math.pi / 4 + k * math.pi / 2) for k in range(4))
    return float(scene["q"][1][t] + scene["l"] / math.sqrt(2) * min(arms))


def forces(scene: dict[str, Any]) -> dict[int, list[float]]:
    """Of the ground, along x and y, in each column with a contact."""
    m, g, v = (scene["motion"][name] for name in "mgv")
    columns = range(len(scene["q"][0]) - 1)
    touching = [t for t in columns if distance(scene, t) < scene["delta"]]
    return {
        t: [m * ((v[i][t + 1] - v[i][t]) / scene["dt"] - g[i]) for i in range(2)] for t in touching
    }


def pushed(scene: dict[str, Any]) -> list[int]:
    """The columns in which the ground pushes: one a bounce, and in this scene far apart."""
    return [t for t, force in forces(scene).items() if force[1] > 1]


def test_a_column_is_chosen_and_shows_its_numbers(open_page: Open, scene: dict[str, Any]) -> None:
    page = open_page()
    for t in [0, 1, 75, 149]:
        page.slide(t)
        assert (page.playing(), page.column()) == (False, t)
        expected = [t * scene["dt"], *(row[t] for row in scene["q"]), distance(scene, t)]
        shown = [page.number(name) for name in ["time", "x", "y", "theta", "phi"]]
        assert shown == pytest.approx(expected, abs=0.51e-4)
    traces = []
    for t in [0, 30, 60, 149]:
        page.slide(t)
        traces.append(page.pixels("corner"))
    assert traces[0] < traces[2] < traces[-1], traces  # dots where it was in contact
    for lines in page.driver.execute_script(LINES):  # they differ by more than colour
        assert len({dash for _, dash, _ in lines}) == len(lines)
        assert all(length > 50 for *_, length in lines)
    page.point_at_plots(0.5)
    assert not page.playing() and page.column() == pytest.approx(149 / 2, abs=1.5)
    page.point_at_plots(1)
    assert page.column() == 149


def test_a_column_shows_its_contact_and_no_force_but_its_own(
    open_page: Open, scene: dict[str, Any]
) -> None:
    page = open_page()
    touching = forces(scene)
    assert pushed(scene)
    for t in sorted({0, *touching, *(t - 1 for t in touching)}):
        page.slide(t)
        assert page.find("contact").is_displayed() == (t in touching)
    for t in pushed(scene):
        for other in (t - 1, t + 1, t + 2):
            page.slide(other)
            text = "0.0" if other in touching else "\N{EN DASH}"
            assert (page.find("f_n").text, page.pixels("force")) == (text, 0)
        page.slide(t)
        shown = [page.number("f_t"), page.number("f_n")]
        assert shown == pytest.approx(touching[t], abs=0.051)
        assert page.pixels("force") > 10
    page.choose("1")
    page.slide(pushed(scene)[0])
    page.find("play").click()
    page.pass_time(0, scene["dt"] + 0.06)  # while it plays, the arrow lingers for the eye
    assert page.column() > pushed(scene)[0] and page.find("echo").get_dom_attribute("d")
    flight = f"return Array.from(Array({min(touching)}), (_, t) => energies(t).total)"
    energies = page.driver.execute_script(flight)  # the scheme's step changes it by m (g dt)^2 / 2
    assert len(energies) > 3 and max(energies) - min(energies) < 0.002 * len(energies)


def test_shows_the_true_motion_beside_it(open_page: Open, file: Path, tmp_path: Path) -> None:
    page = open_page()
    page.slide(100)
    both = page.pixels("right")
    assert both > 20 and page.find("other").is_displayed()
    shown = animation(file.read_text("utf-8"))
    first = next(t for t in range(150) if distance(shown, t) < shown["delta"])
    fallen = 100 * 9.81 * shown["dt"] * (first - 1) * shown["dt"] / 2
    assert f"just before its first contact, it is {fallen:.2g} cm off" in page.find("apart").text
    assert [name for name, *_ in page.driver.execute_script(LINES)[0]] == [
        "\N{GREEK SMALL LETTER PHI}",
        "dashed",
    ]
    page.find("compare").click()
    assert page.pixels("right") == 0 and not page.find("other").is_displayed()
    page.press("c")
    assert page.pixels("right") == both
    page.press(Keys.SPACE)  # the box has the focus, and a space is its own
    assert page.pixels("right") == 0 and not page.playing()

    still = tmp_path / "still.html"  # without velocities no true motion is known
    text = file.read_text("utf-8")
    still.write_text(with_animation(text, {**animation(text), "motion": None}), "utf-8")
    page = open_page(still)
    assert not any(page.find(id_).is_displayed() for id_ in ("choice", "other", "key"))
    page.press("c")
    assert page.pixels("right") == 0


# ---- any trajectory ----


def bounces(columns: int = 150, x_0: float = 0, **other: float) -> dict[str, Any]:
    steps = range(columns)
    heights = [abs(1.5 * math.cos(t / 40)) + 0.2 for t in steps]
    q = [[x_0 + 0.6 * t / 100 for t in steps], heights, [t / 25 for t in steps]]
    return {"q": q, **other}


ODD: dict[str, dict[str, Any]] = {
    "far below the ground": {"q": [[0.0] * 150, [-t * t / 100 for t in range(150)], [0.0] * 150]},
    "to infinity, nearly": {
        "motion": {"m": 0.3, "mu": 0.3, "epsilon": 0.5, "g": [0, -9.81], "v": [[1e300] * 150] * 3},
        "q": [[1.4**t * f for t in range(150)] for f in (1e285, -3e280, 1.0)],
    },
    "at rest on the ground": {"q": [[2.0] * 150, [0.1] * 150, [0.0] * 150]},
}


def test_shows_any_trajectory(
    open_page: Open, file: Path, scene: dict[str, Any], tmp_path: Path
) -> None:
    table = golden.table(TABLES)["trajectory"]
    for name, changes in (ODD | {name: bounces(**row) for name, row in table.items()}).items():
        data: dict[str, Any] = {**scene, "motion": None, **changes}
        other = tmp_path / "other.html"
        other.write_text(with_animation(file.read_text("utf-8"), data), "utf-8")
        page = open_page(other)
        page.pass_time(0, 0.5, 3, 20)
        last = len(data["q"][0]) - 1
        for t in {0, last // 2, last}:
            page.slide(t)
            assert page.find("column").text == f"{t} / {last}"
            x = pytest.approx(data["q"][0][t], rel=1e-6, abs=data["l"] / 1000)
            assert page.number("x") == x, name
            assert page.pixels("square") > 50, f"{name}: the square cannot be seen"
