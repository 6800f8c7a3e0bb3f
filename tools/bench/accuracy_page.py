#!/usr/bin/env python3
"""accuracy_page.py [--quick] [--only PARTS] [DIR]: measures, draws, and writes the tables of docs/accuracy.md (see tools/bench/accuracy)."""

import argparse
import collections
import math
import os
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build/release/tools/kovacic"
BENCH = ROOT / "build/release/tools/bench"
PAGE = ROOT / "docs/accuracy.md"
SCENE = "cases/sliding_top/scenes/bench/asymmetric_sliding_32.toml"
NAMES = {"henon_heiles": "Hénon–Heiles", "three_degrees": "three degrees of freedom", "swinging_atwood": "swinging Atwood machine",
         "restricted": "restricted three bodies", "double_pendulum": "double pendulum", "sliding_top": "sliding top"}
# Colours that the colour-blind tell apart, shapes that differ without them.
STYLES = {"double": ("#1f4e9c", 7), "long-double": ("#2a8c6e", 9), "pairs": ("#8c4fa8", 5), "mpfr": ("#c98a1b", 13),
          "rkf78": ("#c4483a", 6), "dopri5": ("#808080", 8), "bulirsch-stoer": ("#60a0c0", 4)}
TITLES = {"double": "ours, double", "long-double": "ours, long double", "pairs": "ours, pairs of doubles", "mpfr": "ours, MPFR (40 digits)",
          "rkf78": "odeint rkf78", "dopri5": "odeint dopri5", "bulirsch-stoer": "odeint Bulirsch-Stoer"}


def said(*command):
    done = subprocess.run([str(x) for x in command], cwd=ROOT, capture_output=True, text=True, check=True)
    return done.stdout


def draw(out, name, script):
    (out / f"{name}.gp").write_text(script, encoding="utf-8")
    subprocess.run(["gnuplot", f"{name}.gp"], cwd=out, check=True)
    (out / f"{name}.gp").unlink()


def head(name, width, height):
    return (f'set encoding utf8\nset terminal pngcairo size {width},{height} enhanced font "sans,11" background "#ffffff"\n'
            f'set output "{name}.png"\nset grid lc rgb "#d8dce4" lt 1\nset tics nomirror\n')


def panels(name, title, key, x_label, y_label, settings, plots):
    """Six panels with one legend below them."""
    script = head(name, 1260, 940) + settings
    script += f'set multiplot title "{title}" font "sans,14"\n'
    for i, (system, plot) in enumerate(plots):
        column, row = i % 3, i // 3
        left, right = 0.075 + 0.31 * column, 0.075 + 0.31 * column + 0.275
        top = 0.905 - 0.415 * row
        script += (f"set lmargin at screen {left}\nset rmargin at screen {right}\nset tmargin at screen {top}\nset bmargin at screen {top - 0.325}\n"
                   f'set title "{NAMES[system]}" offset 0,-0.6\nset xlabel "{x_label if row else ""}"\nset ylabel "{"" if column else y_label}"\n'
                   f'set format y "{"" if column else "10^{%L}"}"\nunset key\n{plot}\n')
    # the legend: lines without points, in a panel that has nothing else
    script += ("unset title\nunset xlabel\nunset ylabel\nunset tics\nunset border\nunset grid\nunset logscale\nset lmargin at screen 0.05\nset rmargin at screen 0.97\n"
               "set tmargin at screen 0.075\nset bmargin at screen 0.005\nset xrange [0:1]\nset yrange [0:1]\n"
               "set key center center horizontal Left reverse maxrows 2 width 1 samplen 3 font \",11\"\n" + key + "\nunset multiplot\n")
    draw(out_of(), name, script)


_out = []


def out_of():
    return _out[0]


def machine():
    """The processor, and how busy it is: ratios depend on both."""
    cpu = pathlib.Path("/proc/cpuinfo")
    names = re.findall(r"model name\s*:\s*(.*)", cpu.read_text(encoding="utf-8")) if cpu.exists() else []
    return f"{' '.join(names[0].split()) if names else 'processor unknown'}, {os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}"


def write_table(mark, text):
    """Between <!-- mark --> and <!-- end --> of docs/accuracy.md, or, with another DIR, of DIR/tables.md."""
    if out_of() != PAGE.with_suffix(""):
        tables = out_of() / "tables.md"
        old = tables.read_text(encoding="utf-8") if tables.exists() else ""
        old = re.sub(rf"<!-- {mark} -->\n.*?<!-- end -->\n", "", old, flags=re.S)
        tables.write_text(f"{old}<!-- {mark} -->\n{text.rstrip()}\n<!-- end -->\n", encoding="utf-8")
        return
    page = PAGE.read_text(encoding="utf-8")
    new, count = re.subn(rf"(<!-- {mark} -->\n).*?(<!-- end -->)", lambda m: m[1] + text.rstrip() + "\n" + m[2], page, flags=re.S)
    if count != 1:
        raise SystemExit(f"{PAGE}: no place for the table '{mark}'")
    PAGE.write_text(new, encoding="utf-8")


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def plain(x):
    """Two digits, or all before the point."""
    return f"{x:.0f}" if x >= 99.5 else f"{x:.2g}"


def power(x):
    """The power of ten that is not below x."""
    return "10" + str(math.ceil(math.log10(x))).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


# ---- six systems ----

def systems(quick):
    before = machine()
    lines = said(BENCH / "kovacic-systems", "tools/bench/systems", 0.1 if quick else 0.5).splitlines()
    (out_of() / "systems.dat").write_text("\n".join(line for line in lines if not line.startswith("growth")) + "\n", encoding="utf-8")
    (out_of() / "points.dat").write_text("\n".join(line for line in lines if line.startswith("growth")) + "\n", encoding="utf-8")
    ratios = [line.split()[1:] for line in lines if line.startswith("ratio")]
    text = "# time of Boost.odeint over ours (double), by turns in one process, each with the loosest tolerance that keeps the drift\n"
    text += f"# {before} before, {os.getloadavg()[0]:.1f} after\n"
    text += "system method drift median least greatest turns\n" + "\n".join(" ".join(r) for r in ratios) + "\n"
    (out_of() / "ratios.txt").write_text(text, encoding="utf-8")


def read(name):
    return [line.split() for line in (out_of() / name).read_text(encoding="utf-8").splitlines() if line and not line.startswith("#")]


def systems_page(_):
    cost = collections.defaultdict(lambda: collections.defaultdict(list))
    for row in read("systems.dat"):
        if row[0] == "cost":
            cost[row[1]][row[2]].append([float(x) for x in row[3:]])
    blocks, plots = "", []
    styles = "".join(f'set style line {i + 1} lc rgb "{c}" lw 1.6 pt {p} ps 0.9\n' for i, (c, p) in enumerate(STYLES.values()))
    for system in NAMES:
        parts = []
        for i, method in enumerate(STYLES):
            data = [(r[3], r[1]) for r in cost[system][method] if 0 < r[3] < 1]
            if not data:
                continue
            block = f"$d_{system}_{i}"
            blocks += f"{block} << EOD\n" + "\n".join(f"{-math.log10(e):.3f} {t:.5g}" for e, t in data) + "\nEOD\n"
            parts.append(f"{block} with linespoints ls {i + 1}")
        plots.append((system, "plot " + ", ".join(parts)))
    settings = (styles + blocks + 'set logscale y\nset xrange [1:29]\nset yrange [0.3:60000]\nset xtics 4\nset ytics 10\nset mytics 1\n')
    key = "plot " + ", ".join(f'NaN with linespoints ls {i + 1} title "{TITLES[m]}"' for i, m in enumerate(STYLES))
    panels("systems", "What digits cost: processor time of a return against correct digits of its first ten points", key,
           "correct decimal digits of the points", "microseconds a return", settings, plots)

    best = collections.defaultdict(dict)
    for name, method, drift, median, least, greatest, turns in read("ratios.txt")[1:]:
        if median != "-" and (drift not in best[name] or float(median) < float(best[name][drift][1])):
            best[name][drift] = (method, median, least, greatest, turns)
    rows = []
    for system in NAMES:
        cells = [best[system].get(d) for d in ("1e-06", "1e-09", "1e-12")]
        rows.append([NAMES[system]] + ["does not arrive" if c is None else f"{float(c[1]):.2g} ({float(c[2]):.2g}–{float(c[3]):.2g}; {c[4]}) {c[0]}" for c in cells])
    said_of = [line[2:] for line in (out_of() / "ratios.txt").read_text(encoding="utf-8").splitlines() if line.startswith("# ")][1:]
    where = f"\n\nMeasured on: {said_of[0]}." if said_of else ""
    write_table("systems", table(["system", "drift 10⁻⁶", "10⁻⁹", "10⁻¹²"], rows) + where)


def points_page(_):
    growth = collections.defaultdict(list)
    for row in read("points.dat"):
        growth[row[1]].append([float(x) for x in row[2:]])
    blocks, plots = "", []
    for system in NAMES:
        blocks += f"$g_{system} << EOD\n" + "\n".join(" ".join(f"{x:.4g}" for x in r) for r in growth[system]) + "\nEOD\n"
        plots.append((system, f"set xrange [0:{growth[system][-1][0] * 1.03:.0f}]\n"
                      f"plot $g_{system} using 1:4 with lines ls 1, $g_{system} using 1:3 with lines ls 2, $g_{system} using 1:5 with lines ls 3"))
    settings = ('set style line 1 lc rgb "#c4483a" lw 2\nset style line 2 lc rgb "#1f4e9c" lw 2\nset style line 3 lc rgb "#404040" lw 2 dt 2\n' + blocks +
                'set logscale y\nset yrange [1e-17:10]\nset ytics 1e-16,1e4,1\nset mytics 1\n')
    key = ('plot NaN with lines ls 1 title "error of the points: the worst orbit", NaN with lines ls 2 title "the median orbit", '
           'NaN with lines ls 3 title "drift of the energy, all orbits"')
    panels("points", "A small drift is not a small error: double, tolerance 10^{-14}", key, "return", "relative error", settings, plots)


# ---- the rigid body's own kernels, and leaving an unstable plane ----

def top(quick):
    said(PROGRAM, "bench", "accuracy", "--scene", SCENE, "--seconds", 0.5 if quick else 8, "--peers", BENCH / "kovacic-peers", "-o", out_of())
    (out_of() / "top_ratios.txt").write_text(
        said(BENCH / "kovacic-peers", "--ratios", SCENE, 0.5 if quick else 2, 200), encoding="utf-8")


def escape(_):
    said(PROGRAM, "bench", "escape", "--scene", "cases/sliding_top/scenes/hess_sliding.toml", "--pictures", "none", "-o", out_of())


def escape_page(_):
    rows = read("escape.dat")[1:]
    times = collections.defaultdict(dict)
    for l, _, digits, time in rows:
        times[int(digits)][l] = float(time)
    shortest = {d: min(t.values()) for d, t in times.items()}
    first, last = min(times), max(times)
    slope = (shortest[last] - shortest[first]) / (last - first)
    starts = ["1/2", "1", "4", "5"]
    blocks = ""
    parts = []
    for i, l in enumerate(starts):
        blocks += f"$l{i} << EOD\n" + "\n".join(f"{d + (i - 1.5) * 0.4:.2f} {t[l]}" for d, t in sorted(times.items())) + "\nEOD\n"
        parts.append(f'$l{i} with points pt {(7, 5, 9, 13)[i]} ps 1.4 lc rgb "{("#1f4e9c", "#c4483a", "#2a8c6e", "#8c4fa8")[i]}" title "start at l = {l}"')
    draw(out_of(), "escape", head("escape", 960, 600) + blocks +
         'set title "An unstable invariant plane: every digit keeps an orbit on it for longer"\n'
         'set xlabel "decimal digits of the arithmetic"\nset ylabel "time until |G| > 1/100"\nset xrange [12:64]\n'
         f'set yrange [0:{math.ceil(max(shortest.values()) / 10) * 25:.0f}]\nset xtics (16, 19, 24, 28, 32, 40, 50, 60)\n'
         'set key outside right top Left reverse spacing 1.3 samplen 2\n'
         'set label "stays far above the line: luck in the last bit (the longest are not shown)" at graph 0.03, graph 0.95 tc rgb "#606060" font ",10"\n'
         f'plot [12:64] {shortest[first]} + {slope:.4f}*(x - {first}) with lines lw 1.5 dt 2 lc rgb "#404040" title "{slope:.2f} a digit", ' + ", ".join(parts) + "\n")


# ---- certainty ----

def proofs(quick):
    said(PROGRAM, "bench", "certainty", "-o", out_of(), "--seconds", 2 if quick else 10)
    (out_of() / "proofs.dat").write_text("what scene n numerically proved error\n" + said(BENCH / "kovacic-proofs", "cases"), encoding="utf-8")


def seconds(x):
    x = float(x)
    return f"{1000 * x:.2g} ms" if x < 0.1 else f"{x:.2g} s"


def proofs_page(_):
    rows = []
    for what, scene, n, numerically, proved, error in read("proofs.dat")[1:]:
        energy = "E = 1/" + scene.rsplit("_", 1)[1]
        name = f"fixed points of P{'' if n == '1' else '^' + n}" if what == "fixed" else f"a homoclinic point, {n} returns"
        rows.append([f"Hénon–Heiles, {energy}: {name}", seconds(numerically), seconds(proved), plain(float(proved) / float(numerically)),
                     power(float(error))])
    write_table("proofs", table(["", "numerically", "proved", "ratio", "each coordinate right to"], rows))


# ---- bars of exponents ----

def bars(quick):
    (out_of() / "bars.dat").write_text(said(BENCH / "kovacic-bars", 4 if quick else 8, 300 if quick else 1000), encoding="utf-8")


FAMILIES = {"linear": "x' = A x, 60 matrices, t = {}", "chaotic": "Hénon–Heiles, chaotic, {} returns", "regular": "Hénon–Heiles, regular, {} returns",
            "Lorenz": "Lorenz, t = {}", "Duffing": "damped driven Duffing, t = {}"}


def bars_page(_):
    rows = collections.defaultdict(dict)
    for family, length, exponent, orbits, one, two, truth, bar in read("bars.dat")[1:]:
        rows[family, length][exponent] = (orbits, one, two, truth, bar)
    lines = []
    for (family, length), found in rows.items():
        orbits = next(iter(found.values()))[0]
        cells = [f"{found[e][1]}, {found[e][2]}" if e in found else "" for e in ("1", "2", "3", "4", "megno's")]
        lines.append([FAMILIES[family].format(length), orbits, *cells, f"{float(found['1'][3]):.3g} ± {float(found['1'][4]):.2g}"])
    write_table("bars", table(["", "orbits", "λ₁", "λ₂", "λ₃", "λ₄", "MEGNO's λ", "λ₁ and its bar, means"], lines))


# ---- monodromy ----

def monodromy(quick):
    (out_of() / "monodromy.txt").write_text(said(ROOT / "tools/bench/monodromy", PROGRAM, "--most", 300 if quick else 1000), encoding="utf-8")


def monodromy_page(_):
    rows, peer = [], {}
    for part in (out_of() / "monodromy.txt").read_text(encoding="utf-8").split("\n\n"):
        lines = [line.split() for line in part.splitlines() if line[:1].isdigit()]
        if "mpmath" in part:
            peer = {line[0]: line[2] for line in lines if len(line) == 4}
        elif "Lemma 2, six" in part:
            rows = lines
    cells = [[r[0] for r in rows], [r[1] for r in rows], [peer.get(r[0], "") for r in rows]]
    write_table("monodromy", table(["Lemma 2's equation (six singularities, b = 3): digits"] + cells[0],
                                   [["seconds"] + cells[1],
                                    ["mpmath's `odefun`, one circle about one singularity, no bounds, by turns with ours"] + cells[2]]))
    block = "$m << EOD\n" + "\n".join(f"{r[0]} {r[1]}" for r in rows) + "\nEOD\n$p << EOD\n" + "\n".join(f"{d} {t}" for d, t in peer.items()) + "\nEOD\n"
    other = ', $p with linespoints lw 1.6 pt 6 ps 1.3 lc rgb "#c4483a" title "mpmath, one circle, no bounds"' if peer else ""
    draw(out_of(), "monodromy", head("monodromy", 900, 560) + block + 'set logscale xy\nset title "What digits of monodromy matrices cost"\n'
         'set xlabel "decimal digits, proved"\nset ylabel "seconds of the processor"\nset xtics (10, 30, 100, 300, 1000, 3000)\nset xrange [8:4000]\n'
         'set yrange [0.05:200]\nset key right bottom Left reverse\nplot $m with linespoints lw 1.6 pt 7 ps 1.3 lc rgb "#1f4e9c" title "ours, six loops with radii"' + other + "\n")


PARTS = {"systems": (systems, systems_page), "points": (None, points_page), "top": (top, None), "escape": (escape, escape_page),
         "proofs": (proofs, proofs_page), "bars": (bars, bars_page), "monodromy": (monodromy, monodromy_page)}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", nargs="?", default=str(ROOT / "docs/accuracy"))
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--only", default=",".join(PARTS))
    parser.add_argument("--draw", action="store_true", help="nothing is measured again")
    options = parser.parse_args()
    _out.append(pathlib.Path(options.out).resolve())
    out_of().mkdir(parents=True, exist_ok=True)
    for part in options.only.split(","):
        measure, page = PARTS[part]
        print(f"{part} ...", flush=True)
        if measure and not options.draw:
            measure(options.quick)
        if page:
            page(options.quick)


if __name__ == "__main__":
    main()
