#!/usr/bin/env python3
"""Writes the tables of docs/results/libero.md from what scripts/measure-libero.sh measured.

Usage: libero-tables.py OUT PAGE           replaces what stands between the marks of PAGE
       libero-tables.py --opponents OUT    the teams that libero plays against, one per line
       libero-tables.py --training OUT     those that it is tuned against
       libero-tables.py --skills OUT       the skills that libero can do without
"""

import json
import math
import sys
from pathlib import Path

ROBOTS = ["vsss", "firasim"]
PHYSICS = ["standard", "fast"]
SIGHTS = {"exact": "exact", "camera": "2 mm, 2 ticks"}
SIZES = ["3v3", "5v5"]
SPARRING = ["training", "validation"]
YARDSTICKS = "others"
STILL = ["idle", "random"]  # these do not play
NORMAL = 1.959964  # two-sided 95 % point of the normal distribution


class Measured:
    """What the script measured, by file."""

    def __init__(self, out):
        self.out = Path(out)
        self.teams = self.read("teams")["teams"]

    def read(self, name):
        return json.loads((self.out / f"{name}.json").read_text(encoding="utf-8"))

    def opponents(self, *purposes):
        return [t["name"] for t in self.teams
                if (t["purpose"] or YARDSTICKS) in purposes and t["name"] not in STILL + ["libero"]]

    def series(self, cell, opponent):
        return self.read(f"series/{cell}/{opponent}")

    def libero(self):
        return next(t for t in self.teams if t["name"] == "libero")


def share_interval(shares):
    """Mean of shares with the interval of fulbito's shareInterval: Wilson's, for the effective number of trials."""
    n, mean = len(shares), sum(shares) / len(shares)
    most = mean * (1 - mean)
    if most > 0:
        n = n * n * most / (sum((s - mean) ** 2 for s in shares) + most)
    z2 = NORMAL * NORMAL
    centre = (mean + z2 / (2 * n)) / (1 + z2 / n)
    half = NORMAL * math.sqrt(mean * (1 - mean) / n + z2 / (4 * n * n)) / (1 + z2 / n)
    return mean, centre - half, centre + half


def pair_points(series):
    """libero's share of the points of each pair."""
    points = {}
    for match in series["matches"]:
        lead = match["goals_a"] - match["goals_b"]
        points[match["pair"]] = points.get(match["pair"], 0) + (1 if lead > 0 else 0.5 if lead == 0 else 0) / 2
    return list(points.values())


def pool(all_series):
    """Points with interval, goals, and means of play figures of several series together."""
    points = [p for s in all_series for p in pair_points(s)]
    time = sum(s["play"]["play_s"] for s in all_series)
    matches = sum(len(s["matches"]) for s in all_series)

    def over_time(key):
        return sum(s["play"]["a"][key] * s["play"]["play_s"] for s in all_series) / time

    return {
        "points": share_interval(points),
        "worst": min(s["points_share"] for s in all_series),
        "goals": (sum(s["goals_for"] for s in all_series), sum(s["goals_against"] for s in all_series)),
        "own_third": over_time("own_third_share"),
        "most_own_third": max(s["play"]["a"]["own_third_share"] for s in all_series),
        "keeper_away": over_time("keeper_away_share"),
        "uncovered": over_time("uncovered_share"),
        "slow": over_time("slow_share"),
        "locks": sum(s["play"]["a"]["locks_per_match"] * len(s["matches"]) for s in all_series) / matches,
        "long_contacts": sum(s["play"]["a"]["long_contacts_per_match"] * len(s["matches"]) for s in all_series) / matches,
    }


def percent(value, digits=1):
    return f"{100 * value:.{digits}f} %"


def interval(value, low, high):
    return f"{100 * value:.1f} % ({100 * low:.1f} … {100 * high:.1f})"


def table(heads, rows):
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def main_cell(robot):
    return f"{robot}-standard-exact-3v3"


def cells():
    for robot in ROBOTS:
        for physics in PHYSICS:
            for sight in SIGHTS:
                for size in SIZES:
                    yield robot, physics, sight, size


def opponents_table(m):
    rows = []
    for robot in ROBOTS:
        for purpose in SPARRING + [YARDSTICKS]:
            for name in m.opponents(purpose):
                s = m.series(main_cell(robot), name)
                a = s["play"]["a"]
                rows.append([
                    robot, f"`{name}`", purpose, s["pairs"], f"{s['wins']} – {s['draws']} – {s['losses']}",
                    interval(s["points_share"], s["points_share_low"], s["points_share_high"]),
                    f"{s['goals_for']} : {s['goals_against']}", percent(a["own_third_share"], 0),
                    percent(a["keeper_away_share"]), f"{a['locks_per_match']:.2f}"])
    return table(["robot", "opponent", "for", "pairs", "won – drawn – lost", "points", "goals", "own third", "keeper away",
                  "locks per match"], rows)


def grid_table(m):
    rows = []
    for robot, physics, sight, size in cells():
        for purpose in SPARRING:
            p = pool([m.series(f"{robot}-{physics}-{sight}-{size}", name) for name in m.opponents(purpose)])
            rows.append([robot, physics, SIGHTS[sight], size, purpose, interval(*p["points"]), percent(p["worst"]),
                         f"{p['goals'][0]} : {p['goals'][1]}", percent(p["own_third"], 0), percent(p["keeper_away"]),
                         f"{p['locks']:.2f}"])
    return table(["robot", "physics", "sight", "size", "against", "points", "worst opponent", "goals", "own third", "keeper away",
                  "locks per match"], rows)


def itself_table(m):
    rows = []
    for robot, physics, sight, size in cells():
        s = m.series(f"{robot}-{physics}-{sight}-{size}", "libero")
        play, a, b = s["play"], s["play"]["a"], s["play"]["b"]
        rows.append([robot, physics, SIGHTS[sight], size, percent(play["wall_share"], 0), percent(play["corner_share"], 0),
                     f"{a['goals_per_10min'] + b['goals_per_10min']:.1f}", percent((a["slow_share"] + b["slow_share"]) / 2, 0),
                     percent((a["keeper_away_share"] + b["keeper_away_share"]) / 2),
                     percent((a["uncovered_share"] + b["uncovered_share"]) / 2),
                     f"{a['locks_per_match'] + b['locks_per_match']:.2f}",
                     f"{max(a['longest_contact_s'], b['longest_contact_s']):.1f} s"])
    return table(["robot", "physics", "sight", "size", "ball at a wall", "in a corner", "goals per 10 min", "slow robots",
                  "keeper away", "nobody behind ball", "locks per match", "longest contact"], rows)


def tick_time(m, team):
    """Microseconds of a team's decision with navigation."""
    p = m.read(f"time/{team}")["compute_profile"]
    return (p["strategies_ns"] + p["navigation_ns"]) / p["ticks"] / 2 / 1000


def verdict(drill):
    if drill["verdict"] != "failed":
        return drill["verdict"]
    return f"**{sum(bar['passed'] for bar in drill['bars'])} of {len(drill['bars'])} bars**"


def reached(bar):
    if bar["value"] is None:
        return f"{bar['measure']} never"
    # Spaces that do not break keep each number with its unit.
    scale, unit = (100, "\u00a0%") if bar["statistic"] == "rate" else (1, "")
    if bar["measure"] == "error" and bar["statistic"] != "rate":
        scale, unit = 100, "\u00a0cm"
    if bar["measure"] in ("time", "excess") and bar["statistic"] != "rate":
        unit = "\u00a0x least" if bar["of_least"] else "\u00a0s"
    start = f"{bar['start']}: " if bar["start"] else ""
    return f"{start}{bar['measure']} {scale * bar['value']:.4g}{unit}"


def drills_table(m):
    reports = [m.read(f"drills/{robot}")["drills"] for robot in ROBOTS]
    rows = []
    for both in zip(*reports):
        cells_of = []
        for drill in both:
            failed = [reached(bar) for bar in drill["bars"] if not bar["passed"]]
            cells_of.append(verdict(drill) + (": " + "; ".join(failed) if failed else ""))
        rows.append([f"{both[0]['number']} `{both[0]['name']}`"] + cells_of)
    passed = [f"{sum(d['verdict'] == 'passed' for d in report)} of {len(report)}" for report in reports]
    return table(["drill"] + [f"`{robot}`" for robot in ROBOTS], rows + [["passed"] + passed])


def shown_drills(m, robot, skill):
    """The drills in which a skill's interval lies on one side of zero."""
    entry = next((s for s in m.read(f"worth/{robot}")["skills"] if s["skill"] == skill), None)
    shown = []
    for drill in entry["drills"] if entry else []:
        if drill["low"] is None or drill["changed"] == 0 or drill["low"] <= 0 <= drill["high"]:
            continue
        shown.append(f"{drill['name']} {100 * drill['worth']:+.1f}")
    return ", ".join(shown) or "–"


def left_out(m):
    """Each skill that libero can do without, once, in the order of its play book."""
    able = {s["skill"] for s in m.read("worth/vsss")["skills"]} if (m.out / "worth/vsss.json").exists() else None
    names = []
    for skill in m.libero()["skills"]:
        if skill["name"] not in names and (able is None or skill["name"] in able):
            names.append(skill["name"])
    return names


def without(m, robot, skill):
    """Points and goals of libero without a skill, against the training teams."""
    p = pool([m.read(f"without/{robot}/{skill}/{name}") for name in m.opponents("training")])
    return f"{percent(p['points'][0])}, {p['goals'][0]} : {p['goals'][1]}"


def skills_table(m):
    rows = [["nothing", "–"] + [without(m, robot, "nothing") for robot in ROBOTS] + ["–" for _ in ROBOTS]]
    for name in left_out(m):
        roles = [s["role"] for s in m.libero()["skills"] if s["name"] == name]
        rows.append([f"`{name}`", ", ".join(roles)] + [without(m, robot, name) for robot in ROBOTS] +
                    [shown_drills(m, robot, name) for robot in ROBOTS])
    return table(["without", "roles"] + [f"matches on `{robot}`" for robot in ROBOTS] +
                 [f"drills on `{robot}`" for robot in ROBOTS], rows)


def bars_table(m):
    main = [m.series(main_cell(robot), name) for robot in ROBOTS for name in m.opponents(*SPARRING)]
    pools = {purpose: pool([m.series(main_cell(robot), n) for robot in ROBOTS for n in m.opponents(purpose)])
             for purpose in SPARRING}
    grid = [pool([m.series(f"{r}-{p}-{s}-{z}", n) for n in m.opponents(*SPARRING)]) for r, p, s, z in cells()]
    itself = [m.series(main_cell(robot), "libero")["play"] for robot in ROBOTS]
    both = pool(main)
    worst, low = min(s["points_share"] for s in main), min(s["points_share_low"] for s in main)
    gap = pools["training"]["points"][0] - pools["validation"]["points"][0]
    goals = min(p["a"]["goals_per_10min"] + p["b"]["goals_per_10min"] for p in itself)
    slow = max((p["a"]["slow_share"] + p["b"]["slow_share"]) / 2 for p in itself)
    drills = [d["verdict"] == "passed" for robot in ROBOTS for d in m.read(f"drills/{robot}")["drills"]]
    bars = [
        ("points against each team, both robots", "≥ 90 %", percent(worst), worst >= 0.9),
        ("its lower bound", "> 85 %", percent(low), low > 0.85),
        ("validation behind training", "≤ 5 points", f"{100 * gap:+.1f}", gap <= 0.05),
        ("points in each cell of the grid", "≥ 85 %", percent(min(p["points"][0] for p in grid)),
         min(p["points"][0] for p in grid) >= 0.85),
        ("locks per match", "< 0.05", f"{both['locks']:.3f}", both["locks"] < 0.05),
        ("keeper away", "< 3 %", percent(both["keeper_away"]), both["keeper_away"] < 0.03),
        ("own third against each team", "≤ 35 %", percent(both["most_own_third"]), both["most_own_third"] <= 0.35),
        ("against itself: ball at a wall", "≤ 60 %", percent(max(p["wall_share"] for p in itself)),
         max(p["wall_share"] for p in itself) <= 0.6),
        ("against itself: in a corner", "≤ 20 %", percent(max(p["corner_share"] for p in itself)),
         max(p["corner_share"] for p in itself) <= 0.2),
        ("against itself: goals per 10 min", "≥ 2", f"{goals:.2f}", goals >= 2),
        ("against itself: slow robots", "≤ 20 %", percent(slow), slow <= 0.2),
        ("drills passed on both robots", "all", f"{sum(drills)} of {len(drills)}", all(drills)),
    ]
    rows = [[what, bar, value if holds else f"**{value}**"] for what, bar, value, holds in bars]
    times = ", ".join(f"`{team}` {tick_time(m, team):.2f} µs" for team in ("libero", "classic"))
    return table(["what", "bar", "worst measured"], rows + [["a decision with navigation, per tick", "–", times]])


TABLES = {"bars": bars_table, "opponents": opponents_table, "grid": grid_table, "itself": itself_table,
          "drills": drills_table, "skills": skills_table}


def write_page(m, page):
    text = Path(page).read_text(encoding="utf-8")
    for name, make in TABLES.items():
        begin, end = f"<!-- measured: {name} -->", f"<!-- end of {name} -->"
        if text.count(begin) != 1 or text.count(end) != 1 or text.index(begin) > text.index(end):
            sys.exit(f"libero-tables.py: {page}: '{begin}' and '{end}' must stand once, in this order")
        head, rest = text.split(begin)
        text = head + begin + "\n" + make(m) + "\n" + end + rest.split(end)[1]
    Path(page).write_text(text, encoding="utf-8")


def main(arguments):
    if len(arguments) != 2:
        sys.exit(__doc__)
    if arguments[0] == "--opponents":
        print("\n".join(Measured(arguments[1]).opponents(*SPARRING, YARDSTICKS)))
    elif arguments[0] == "--training":
        print("\n".join(Measured(arguments[1]).opponents("training")))
    elif arguments[0] == "--skills":
        print("\n".join(left_out(Measured(arguments[1]))))
    else:
        write_page(Measured(arguments[0]), arguments[1])


if __name__ == "__main__":
    main(sys.argv[1:])
