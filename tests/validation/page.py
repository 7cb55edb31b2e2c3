#!/usr/bin/env python3
"""Writes docs/validation.md: runs what configs/paper and cases.txt say and holds it against the paper.

    page.py CAPSELLA WORK

Results go below WORK, where what an earlier call has computed is taken over; remove it to compute all anew.
The page is page.md.in with its {names} filled in; pictures go to docs/pictures.  A value that misses its mark is a
row like any other: the page is written, and says so.  Needs the standard library of Python only."""

import csv
import datetime
import json
import math
import pathlib
import platform
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PICTURES = ROOT / "docs" / "pictures"
CAPSELLA = str(pathlib.Path(sys.argv[1]).resolve())
WORK = pathlib.Path(sys.argv[2]).resolve()

Y_D, Y_C = 0.2, 2.0  # of the paper's reference membrane

# ---- running and reading ----


def capsella(*words):
    subprocess.run([CAPSELLA, *map(str, words)], check=True, stdout=subprocess.DEVNULL)


def study(name):
    capsella("study", ROOT / f"configs/paper/{name}.yaml", "--resume", "--quiet", "-o", WORK / name)
    if summary(WORK / name)["status"] != "done":
        sys.exit(f"{name} was interrupted; call again to go on")
    return table(WORK / name / "table.csv")


def run(name, scene, *settings):
    """A run, unless its folder has a summary already."""
    folder = WORK / name
    if not (folder / "summary.json").exists():
        capsella("run", scene, "--quiet", "-o", folder, *(w for s in settings for w in ("--set", s)))
    return summary(folder)


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def table(path):
    with open(path, newline="") as file:
        return [{key: number(value) for key, value in row.items()} for row in csv.DictReader(file)]


def history(folder):
    return table(folder / "history.csv")


def summary(folder):
    return json.loads((folder / "summary.json").read_text())


def case(name, row):
    return WORK / name / "cases" / row["case"]


def only(rows, **wanted):
    """The rows whose columns hold these values; a column is named by the end of its key."""
    def holds(row, end, value):
        return any(row[key] == value for key in row if key == end or key.endswith("." + end))
    return [row for row in rows if all(holds(row, end, value) for end, value in wanted.items())]


# ---- pictures ----


def picture(source, name):
    PICTURES.mkdir(exist_ok=True)
    shutil.copyfile(source, PICTURES / f"{name}.svg")


def maps(name, *words):
    PICTURES.mkdir(exist_ok=True)
    capsella("maps", *words, "-o", PICTURES / f"{name}.svg")


# ---- rows of the page ----


def show(value):
    return value if isinstance(value, str) else f"{value:.6g}"


def row(quantity, paper, here, tolerance, note=""):
    """Value against value: met when they differ by at most the tolerance."""
    difference = here - paper
    verdict = "met" if abs(difference) <= tolerance else f"not met, by {abs(difference) - tolerance:.2g}"
    return said(quantity, show(paper), show(here), f"{difference:+.2g} (within {show(tolerance)})",
                verdict + (f": {note}" if note else ""))


def below(quantity, bound, here, note=""):
    verdict = "met" if here <= bound else f"not met, by {here - bound:.2g}"
    return said(quantity, f"at most {show(bound)}", show(here), "", verdict + (f": {note}" if note else ""))


def holds(quantity, paper, here, is_met, note=""):
    """A statement in words."""
    verdict = "met" if is_met else "not met"
    return said(quantity, paper, here, "", verdict + (f": {note}" if note else ""))


def said(*cells):
    return "| " + " | ".join(cells) + " |"


def rows(*lines):
    return "\n".join(["| quantity | paper | here | difference | verdict |", "|---|---|---|---|---|", *lines])


# ---- inflation: figures 7, 8 and 17 ----


def release_rate(alpha):
    stretch = 1 + alpha
    return (2 * stretch**2 + stretch**-4 - 3) / 2


def inverse(level):
    """The inflation at which the release rate reaches a level."""
    low, high = 0.0, 10.0
    while high - low > 1e-14:
        middle = (low + high) / 2
        low, high = (middle, high) if release_rate(middle) < level else (low, middle)
    return high


def damage(Y):
    return min(max((Y - Y_D) / Y_C, 0), 1)


def pressure(alpha, d):
    stretch = 1 + alpha
    return 2 * (1 - d) * (1 - stretch**-6) / stretch


def off_theory(lines, is_damaged):
    """Largest errors of p and d of a history, as parts of the largest p and of 1."""
    reached, p_error, d_error, p_most = 0.0, 0.0, 0.0, 0.0
    for line in lines:
        reached = max(reached, release_rate(line["alpha"]))
        d = damage(reached) if is_damaged else 0.0
        p = pressure(line["alpha"], d)
        p_error, d_error = max(p_error, abs(line["p"] - p)), max(d_error, abs(line["d"] - d))
        p_most = max(p_most, p)
    return p_error / p_most, d_error


def largest_pressure(is_damaged):
    grid = [k * 1e-5 for k in range(100001)]
    return max((pressure(a, damage(release_rate(a)) if is_damaged else 0), a) for a in grid)


def inflation(name):
    damaged, sound = study(name)
    return damaged, history(case(name, damaged)), history(case(name, sound))


def fig07():
    damaged, lines, sound = inflation("fig07")
    for chart in "p_over_alpha", "d_over_alpha":
        picture(WORK / f"fig07/{chart}.svg", f"fig07_{chart}")
    p_error, d_error = (max(pair) for pair in zip(off_theory(lines, True), off_theory(sound, False)))
    top, top_sound = (max((line["p"], line["alpha"]) for line in some) for some in (lines, sound))
    p, alpha = largest_pressure(True)
    p_sound, alpha_sound = largest_pressure(False)
    return rows(
        below("error of p, relative to the largest", 1e-5, p_error),
        below("error of d", 1e-6, d_error),
        row("alpha_c, where Y = Y_D (eq. 4.2)", inverse(Y_D), damaged["t_c"], 1e-6),
        row("alpha_l, where Y = Y_D + Y_C", inverse(Y_D + Y_C), damaged["t_l"], 1e-6),
        row("p at alpha_l", 0, lines[-1]["p"], 1e-6),
        row("largest p (eqs 4.1 to 4.4)", p, top[0], 2e-4, "rows of the history are 0.005 apart"),
        row("alpha there", alpha, top[1], 0.0025),
        row("largest p without damage", p_sound, top_sound[0], 2e-4),
        row("alpha there", alpha_sound, top_sound[1], 0.0025),
    )


def fig08():
    _, lines, sound = inflation("fig08")
    for chart in "alpha_over_t", "p_over_alpha", "d_over_alpha":
        picture(WORK / f"fig08/{chart}.svg", f"fig08_{chart}")
    p_error, d_error = off_theory(lines, True)
    first = max(abs(a["p"] - b["p"]) for a, b in zip(lines, sound) if a["t"] <= 2)
    rising = [b["d"] - a["d"] for a, b in zip(lines, lines[1:]) if b["alpha"] < a["alpha"]]
    return rows(
        row("p with damage less p without, first cycle (A)", 0, first, 1e-12),
        row("change of d in the deflations", 0, max(map(abs, rising)), 1e-12),
        below("error of p against the monotone curve and the unloading ones", 1e-5, p_error),
        below("error of d", 1e-6, d_error),
        row("alpha at rupture", inverse(Y_D + Y_C), lines[-1]["alpha"], 1e-6),
    )


def fig17():
    marigo, bundle, fibres = study("fig17")
    picture(WORK / "fig17/d_over_alpha.svg", "fig17_d_over_alpha")
    one, two, many = (history(case("fig17", item)) for item in (marigo, bundle, fibres))
    apart = max(abs(a["d"] - b["d"]) for a, b in zip(one, two))
    share = max(abs(line["d"] - damage(release_rate(line["alpha"]))) for line in many)
    return rows(
        row("d of `fibre_bundle`, eq. (6.4), less that of `marigo`, eq. (2.29)", 0, apart, 1e-15),
        below("error of d of `fibre_bundle` against eq. (6.4)", 1e-12, off_theory(two, True)[1]),
        below("share of 1280 broken fibres less P_f, largest", round(1.63 / math.sqrt(1280), 4), share,
              "the bound is what chance keeps with a probability of 99 %"),
    )


# ---- the reference case: figures 10, 11 and 12 ----


def degrees_to(X, axis):
    return math.degrees(math.acos(min(1, abs(X[axis]) / math.hypot(*X))))


def maxima(lines, key):
    return max(lines, key=lambda line: line[key])


def fig10():
    end = run("fig10", ROOT / "configs/paper/fig10.yaml")
    lines = history(WORK / "fig10")
    t_1 = maxima(lines, "L1")["t"]
    times = ",".join(show(t) for t in (1.1, 2, t_1, 10))
    maps("fig10", WORK / "fig10", "--at", times, "--view", "transverse,shear,reference")
    angle = degrees_to(end["d_max_location"]["X"], 1)
    return rows(
        said("t_c", "not stated", show(end["t_c"]), "", "1.10 by an independent P2 program"),
        said("t_1, of the largest elongation L1", "not stated", show(t_1), "", ""),
        row("largest damage lies at P, P': degrees from the vorticity axis, on the sphere at rest", 0, angle, 8.0,
            "an element spans 8 degrees"),
        row("d_max in the steady state ([P])", 0.219, end["d_max"], 0.004),
        holds("d grows along e_1 first, and is nearly isotropic on the sphere at rest in the end", "stated",
              "seen in the maps", True, "by eye"),
    )


def fig11():
    run("fig11", ROOT / "configs/paper/fig11.yaml")
    lines = history(WORK / "fig11")
    times = ",".join(show(t) for t in (1.1, 2, maxima(lines, "L1")["t"], 10))
    maps("fig11_Y_T1", WORK / "fig11", "--at", times, "--field", "Y,T1")
    maps("fig11_load_T2", WORK / "fig11", "--at", times, "--field", "q.n,T2-")
    end = lines[-1]
    return rows(
        said("largest Y and T1, steady", "not stated", f"{end['Y_max']:.4g}, {end['T1_max']:.4g}", "", ""),
        holds("Y and T1 are largest around P, P' together", "stated", "seen in the maps", True, "by eye"),
        holds("the negative part of T2 is small beside T1", "stated",
              f"{end['T2_min']:.3g} of {end['T1_max']:.3g} in the steady state; "
              f"{min(line['T2_min'] for line in lines):.3g} at most in the start-up", end["T2_min"] > -0.1 * end["T1_max"]),
        holds("wrinkles are seen in the normal load", "stated", "seen in the maps, until about t_1", True, "by eye"),
    )


def fig12():
    damaged, sound = study("fig12")
    for chart in "L1_L2_L3", "D12", "beta", "area_strain":
        picture(WORK / f"fig12/{chart}_over_t.svg", f"fig12_{chart}")
    both = list(zip(history(case("fig12", damaged)), history(case("fig12", sound))))
    at_onset = max(abs(a[k] / b[k] - 1) for a, b in both if a["t"] <= damaged["t_c"] + 0.5 for k in ("L1", "L2", "L3"))

    def part(key):
        return damaged[key] / sound[key] - 1
    first = both[1][0]
    return rows(
        holds("L1 > L3 > 2 > L2", "stated", ", ".join(f"{damaged[k]:.4g}" for k in ("L1", "L3", "L2")),
              damaged["L1"] > damaged["L3"] > 2 > damaged["L2"]),
        row("beta/pi at the first sample (t = 0.05)", 0.25, first["beta"] / math.pi, 0.01, "\"near pi/4\""),
        holds("the onset of damage is not visible in L1, L2, L3", "stated",
              f"they differ by {100 * at_onset:.2g} % from the sound capsule up to t_c + 0.5", at_onset < 2e-3),
        holds("L_i, D12 and beta differ little from the sound capsule in the steady state", "\"only small differences\"",
              ", ".join(f"{k} {100 * part(k):+.1f} %" for k in ("L1", "L2", "L3", "D12", "beta")),
              max(abs(part(k)) for k in ("L1", "L2", "L3", "D12", "beta")) < 0.03, "small is read as below 3 %"),
        holds("the surface differs most, and by a few per cent", "\"a few per cent\"",
              f"{100 * part('area_strain'):+.1f} %", 0.02 < part("area_strain") < 0.08),
        row("D12 without damage ([S])", 0.5487, sound["D12"], 5e-4),
        row("beta without damage, degrees ([S])", 18.65, math.degrees(sound["beta"]), 0.1),
        row("D12 with damage ([P])", 0.5591, damaged["D12"], 5e-4),
    )


# ---- the diagrams: figures 13 to 16 ----

CA = "flow.capillary_number"


def brackets(cases):
    """Onset and rupture between neighbours of a sweep along Ca."""
    cases = sorted(cases, key=lambda item: item[CA])
    sound = [c[CA] for c in cases if c["d_max"] == 0]
    hurt = [c[CA] for c in cases if 0 < c["d_max"]]
    whole = [c[CA] for c in cases if c["status"] != "ruptured"]
    torn = [c[CA] for c in cases if c["status"] == "ruptured"]
    return (max(sound, default=math.nan), min(hurt, default=math.nan)), (max(whole), min(torn, default=math.nan))


def between(pair):
    return f"{pair[0]:g} to {pair[1]:g}"


def fig13():
    cases = study("fig13")
    picture(WORK / "fig13/d_max.svg", "fig13_d_max")
    shown = [case("fig13", only(cases, capillary_number=Ca)[0]) for Ca in (0.6, 0.7, 0.8)]
    maps("fig13_maps", *shown, "--range", "0:0.2")
    onset, rupture = brackets(cases)
    steady = [c for c in cases if 0 < c["d_max"] < 1]
    line = [c for c in steady if onset[1] <= c[CA] <= 0.6]
    slope = line[-1]["d_max"] / (0.6 - sum(onset) / 2)
    bent = max(abs(c["d_max"] - slope * (c[CA] - sum(onset) / 2)) for c in line) / line[-1]["d_max"]
    top = max(c["d_max"] for c in steady)
    sites = [degrees_to(summary(case("fig13", c))["d_max_location"]["X"], 1) for c in cases if c["d_max"] > 0]
    return rows(
        holds("Ca_c", "0.37", between(onset), abs(sum(onset) / 2 - 0.37) <= 0.01, "within 0.01; figure 16 has it finer"),
        holds("Ca_l", "0.73", between(rupture), abs(sum(rupture) / 2 - 0.73) <= 0.005, "within 0.005"),
        holds("d_max about linear in Ca up to 0.6", "\"almost linearly\"",
              f"leaves the chord by at most {100 * bent:.2g} % of d_max(0.6) = {line[-1]['d_max']:.3g}", bent <= 0.1,
              "convex; almost is read as within 10 %"),
        holds("largest steady d_max before it jumps to 1", "about 0.4", f"{top:.3g} at Ca = {rupture[0]:g}",
              abs(top - 0.4) <= 0.1, "within 0.1: the curve is vertical there, and 0.0025 in Ca is what we resolve"),
        holds("d = 0.8, 0.9 and 1 give the same Ca_l", "stated",
              f"no steady state with d_max between {top:.3g} and 1", all(not top < c["d_max"] < 1 for c in cases)),
        row("largest damage lies at P, P' for every Ca: degrees from the vorticity axis, at most", 0, max(sites), 8.0,
            "an element spans 8 degrees"),
    )


def fig14():
    cases = study("fig14")
    for chart in "D12", "beta":
        picture(WORK / f"fig14/{chart}.svg", f"fig14_{chart}")
    sound = {c[CA]: c for c in cases if not c["membrane.damage"]}
    hurt = {c[CA]: c for c in cases if c["membrane.damage"]}
    apart = {Ca: hurt[Ca]["D12"] / sound[Ca]["D12"] - 1 for Ca in sound}
    turned = {Ca: math.degrees(hurt[Ca]["beta"] - sound[Ca]["beta"]) for Ca in sound}
    far = max(abs(apart[Ca]) for Ca in apart if Ca <= 0.6)
    last = max(apart)
    spectral = {0.15: (0.2717, 30.91), 0.3: (0.3979, 25.18), 0.45: (0.4714, 22.01), 0.6: (0.5225, 19.80),
                0.7: (0.5487, 18.65)}
    return rows(
        holds("damage does not show in D12 and beta but close to Ca_l", "stated",
              f"D12 differs by at most {100 * far:.2g} % up to Ca = 0.6, by {100 * apart[last]:.2g} % and beta by "
              f"{turned[last]:.2g} degrees at {last:g}", far < 0.02),
        *(row(f"D12 without damage, Ca = {Ca:g} ([S])", D12, sound[Ca]["D12"], 5e-4 if Ca >= 0.3 else 5e-3,
              "" if Ca >= 0.3 else "wrinkled") for Ca, (D12, _) in spectral.items()),
        *(row(f"beta without damage, Ca = {Ca:g}, degrees ([S])", beta, math.degrees(sound[Ca]["beta"]),
              0.1 if Ca >= 0.3 else 1.0) for Ca, (_, beta) in spectral.items()),
    )


def fig15():
    cases = study("fig15")
    picture(WORK / "fig15/d_max.svg", "fig15_d_max")
    key = "membrane.damage.parameters"
    found = {}
    for c in cases:
        found.setdefault(c[key], []).append(c)
    lines, limits = [], {}
    theory = {0.1: 0.217, 0.2: 0.377, 0.3: 0.518}
    for text, some in found.items():
        y_d, y_c = map(float, re.findall(r"[\d.]+", text))
        onset, rupture = brackets(some)
        limits[y_d, y_c] = onset, rupture
        lines.append(holds(f"Ca_c, Ca_l for Y_D = {y_d:g}, Y_C = {y_c:g}",
                           f"{theory[y_d]} ([S]), " + ("0.73" if (y_d, y_c) == (Y_D, Y_C) else "not stated"),
                           f"{between(onset)}, {between(rupture)}", onset[0] <= theory[y_d] <= onset[1] and
                           ((y_d, y_c) != (Y_D, Y_C) or rupture[0] <= 0.73 <= rupture[1])))
    up = [limits[y_d, 2.0] for y_d in (0.1, 0.2, 0.3)]
    across = [limits[0.2, y_c] for y_c in (1.0, 2.0, 3.0)]

    def ordered(pairs):
        return all(a[0] <= b[0] and a[1] <= b[1] and a != b for a, b in zip(pairs, pairs[1:]))
    return rows(
        *lines,
        holds("(a) Ca_c and Ca_l grow with Y_D", "stated", "they do", ordered([a for a, _ in up]) and
              ordered([b for _, b in up])),
        holds("(b) Ca_c does not depend on Y_C, Ca_l grows with it", "stated", "so it is",
              len({a for a, _ in across}) == 1 and ordered([b for _, b in across])),
    )


def fig16():
    points = study("fig16")
    picture(WORK / "fig16/diagram.svg", "fig16_diagram")
    cost = summary(WORK / "fig16")
    Y_key, C_key = "membrane.damage.parameters.Y_D", "membrane.damage.parameters.Y_C"
    lines = []
    reference = [p for p in points if abs(p[Y_key] - Y_D) < 1e-9 and p[C_key] == Y_C][0]
    curves = {y_c: sorted((p for p in points if p[C_key] == y_c), key=lambda p: p[Y_key]) for y_c in (1, 2, 3)}

    def rises(key):
        return all(a[key] < b[key] for some in curves.values() for a, b in zip(some, some[1:]))
    shifted = all(a["Ca_l"] < b["Ca_l"] for low, high in ((1, 2), (2, 3)) for a, b in zip(curves[low], curves[high]))
    for y_c, some in curves.items():
        lines.append(f"| {y_c:g} | " + " | ".join(f"{p['Ca_l']:.3f}" for p in some) + " |")
    head = [f"{p[Y_key]:g}" for p in curves[2]]
    diagram = "\n".join(["| Ca_l: Y_C \\ Y_D | " + " | ".join(head) + " |", "|---" * (len(head) + 1) + "|", *lines,
                         "| Ca_c | " + " | ".join(f"{p['Ca_c']:.3f}" for p in curves[2]) + " |"])
    return rows(
        row("Ca_c for Y_D = 0.2", 0.37, reference["Ca_c"], 0.01, "0.377 also by a spectral solver"),
        row("Ca_l for Y_D = 0.2, Y_C = 2", 0.73, reference["Ca_l"], 0.005),
        holds("Ca_c and Ca_l rise with Y_D, Ca_l with Y_C", "stated", "they do",
              rises("Ca_c") and rises("Ca_l") and shifted),
        holds("Ca_c does not depend on Y_C", "stated", "it does not",
              all(len({p["Ca_c"] for p in points if p[Y_key] == y}) == 1 for y in {p[Y_key] for p in points})),
        said("runs", "not stated", f"{cost['elastic_runs']} elastic and {cost['trial_runs']} with damage for "
             f"{2 * len(points)} values", "", f"{cost['runs_by_plain_halving']} by halving each bracket"),
    ) + "\n\n" + diagram


# ---- figure 18 ----


def fig18():
    cases = study("fig18")
    stop = run("fig18f", WORK / "fig18/scene.yaml", "flow.capillary_number=0.010", "stop.rupture=stop",
               "output.snapshot_every=0")
    picture(WORK / "fig18/D12_over_t.svg", "fig18_D12")
    at = {c[CA]: c for c in cases}
    maps("fig18e", case("fig18", at[0.005]), "--field", "q.n", "--view", "shear,flow")
    maps("fig18fg", WORK / "fig18f", case("fig18", at[0.012]), "--view", "shear,transverse", "--range", "0:1")
    torn = [Ca for Ca in sorted(at) if at[Ca]["t_l"] != ""]
    whole = [Ca for Ca in sorted(at) if at[Ca]["t_l"] == ""]
    rupture = stop["rupture"]
    return rows(
        said("Ca_l", "0.01", f"no rupture at {', '.join(map(str, whole))}; rupture at {', '.join(map(str, torn))} "
             "up to t = 15", "", "not met, by about 0.001: rupture is there at 0.010, but from about 0.009 on; wrinkles of "
             "the size of an element decide it, and smooth theory has no damage below 0.01265 "
             "([low_capillary.md](low_capillary.md))"),
        row("D12 at Ca = 0.005 without wrinkles, 25/12 Ca", 25 / 12 * 0.005, at[0.005]["D12"], 0.02 * 25 / 12 * 0.005,
            "wrinkles of the size of an element add to it"),
        holds("rupture at Ca = 0.010 begins near the vorticity axis", "stated",
              f"{rupture['angle_to_vorticity_deg']:.3g} degrees from it at t_l = {stop['t_l']:.3g}" if rupture
              else "no rupture", bool(rupture) and rupture["angle_to_vorticity_deg"] < 30, "near is read as 30 degrees"),
        holds("after rupture d = 1 spreads in the plane perpendicular to e_1", "stated", "seen in the map of Ca = 0.012",
              True, "by eye"),
        holds("at Ca = 0.012 the capsule diverges along e_1 after rupture", "stated, D12 without end",
              f"D12 = {at[0.012]['D12']:.3g}, L1 = {at[0.012]['L1']:.3g} at t = {at[0.012]['t']:.3g}",
              at[0.012]["L1"] > 3, "it begins to: without rupture D12 would be about 0.03; then the torn mesh folds and "
              "the run ends"),
    )


# ---- whole runs ----


def whole_runs():
    lines = ["| case | quantity | expected | source | here | difference | verdict |", "|---|---|---|---|---|---|---|"]
    for line in (HERE / "cases.txt").read_text().splitlines():
        words = line.split()
        if words and words[0] in ("quick", "full"):
            end = run(f"runs/{words[1]}", ROOT / "configs/shear_reference.yaml", *words[2:])
        elif words and words[0] == "value":
            _, name, key, expected, tolerance, *source = words
            here = end["rupture"][key] if key == "angle_to_vorticity_deg" else end[key]
            if tolerance == "is":
                cells = str(here), "", "met" if here == expected else "not met"
            else:
                difference = here - float(expected)
                cells = show(here), f"{difference:+.2g} (within {tolerance})", \
                    "met" if abs(difference) <= float(tolerance) else "not met"
            lines.append(said(name, key, expected, " ".join(source), *cells))
    drift = summary(WORK / "runs/paper_rule")["volume_error_max"]
    return "\n".join(lines) + "\n\n" + rows(
        below("largest volume error with the paper's rule, where nothing is corrected (`paper_rule`)", 1e-3, drift,
              "the flux of the finite-element traction, see below"),
        below("the same with the defaults", 1e-3, summary(WORK / "runs/reference")["volume_error_max"]))


# ---- the page ----


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def compiler():
    cache = (pathlib.Path(CAPSELLA).parent / "CMakeCache.txt")
    if cache.exists():
        path = re.search(r"^CMAKE_C_COMPILER:\w+=(.*)$", cache.read_text(), re.M)
        if path:
            return subprocess.run([path[1], "--version"], capture_output=True, text=True).stdout.splitlines()[0]
    return "unknown compiler"


def main():
    WORK.mkdir(parents=True, exist_ok=True)
    version = subprocess.run([CAPSELLA, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    page = (HERE / "page.md.in").read_text()
    parts = {"made": f"{version}, {datetime.date.today()}, {processor()}, {compiler()}"}
    for part in (fig07, fig08, fig17, fig10, fig11, fig12, fig13, fig14, fig15, fig16, fig18, whole_runs):
        if "{" + part.__name__ + "}" in page:
            print(part.__name__, flush=True)
            parts[part.__name__] = part()
    for name, text in parts.items():
        page = page.replace("{" + name + "}", text)
    (ROOT / "docs/validation.md").write_text(page)
    missed = sum("| not met" in line for line in page.splitlines())
    print(f"docs/validation.md: {missed} values are not met")


if __name__ == "__main__":
    main()
