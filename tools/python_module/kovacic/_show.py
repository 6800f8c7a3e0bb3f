"""How answers look in a notebook: theorem, table, picture.  Everything is escaped."""

from html import escape

from . import _core

TRUTH = {_core.Truth.yes: "abelian", _core.Truth.no: "not abelian", _core.Truth.unknown: "undecided"}


def table(rows, head=()):
    def line(cells, tag):
        return "<tr>" + "".join(f"<{tag} style='text-align:left'>{c}</{tag}>" for c in cells) + "</tr>"

    return "<table>" + (line(head, "th") if head else "") + "".join(line(r, "td") for r in rows) + "</table>"


def values(x):
    """A dict of plain values as a table."""
    if isinstance(x, dict):
        return table([(escape(key), values(value)) for key, value in x.items() if value not in (None, "", [], {})])
    if isinstance(x, list):
        return "<br>".join(map(values, x))
    return escape(str(x))


def math(text):
    return _core.latex(text)


def decision(d):
    text = getattr(d, "equation", None) or f"y'' = ({d.r})*y"
    rows = [("equation", math(text) if len(text) < 400 else escape(text))]
    rows.append(("answer", f"<b>{escape(d.headline)}</b>"))
    rows.append(("because", escape(d.reason)))
    if d.undecided is not None:
        rows.append(("undecided", escape(d.undecided.detail)))
    unknown = getattr(d, "unknown", "y")
    rows += [("solution", math(f"{unknown} = {s}") if len(str(s)) < 400 else escape(str(s)))
             for s in getattr(d, "solutions", d.liouvillian)]
    if isinstance(d, _core.Solved):
        rows += [("where", escape(f"{k} = {v}")) for k, v in d.constants.items()]
    return table(rows)


def strata(a):
    text = f"<p>assumed: {escape(', '.join(a.assumed))}</p>" if a.assumed else ""
    if a.contradictory:
        text += "<p>no parameters satisfy the assumptions</p>"
    text += "".join(f"<p>there is no equation unless {escape(c)}</p>" for c in a.domain)
    rows = [(escape(s.where), escape(s.group_text), TRUTH[s.abelian], escape(s.reason)) for s in a.strata]
    rows += [(escape(u), "", "not looked at", "") for u in a.unvisited]
    text += table(rows, ("where", "group", "identity component", "because"))
    if a.family is not None:
        text += f"<p>{escape(a.family.equation)}: {escape(a.family.summary)}</p>"
    return text + "".join(f"<p>trusted: {escape(t)}</p>" for t in a.trusted)


def manifold(m):
    text = f"<p><b>{escape(m.headline)}</b></p>"
    if m.not_checked is not None:
        text += f"<p>NOT CHECKED: {escape(m.not_checked)}</p>"
    text += "".join(f"<p>note: {escape(note)}</p>" for note in m.notes)
    for b in m.blocks:
        if b.change is not None:
            text += f"<p>{escape(b.change)}, y the variation of {escape(b.unknown)}</p>"
        if b.answer is not None:
            text += b.answer._repr_html_()
        text += "".join(f"<p>singular places meet where {escape(f)} = 0</p>" for f in b.merging)
        for condition, why, answer, note in b.levels:
            text += f"<p>at {escape(condition)} ({escape(why)}) {escape(note)}</p>"
            if answer is not None:
                text += answer._repr_html_()
        if b.note:
            text += f"<p>{escape(b.note)}</p>"
    if m.verdict == _core.VerdictKind.undecided or m.matrices is not None:
        text += "".join(f"<p>because {escape(r)}</p>" for r in m.reasons)
    if m.verdict != _core.VerdictKind.undecided:
        text += "".join(f"<p>trusted: {escape(t)}</p>" for t in m.trusted_steps)
    return text


def report(r):
    text = f"<h4>{escape(r.title)}</h4>"
    if r.values:
        text += "<p>" + escape(", ".join(f"{k} = {v}" for k, v in r.values.items())) + "</p>"
    if r.assumptions:
        text += f"<p>assumed: {escape(', '.join(r.assumptions))}</p>"
    for m in r.manifolds:
        text += f"<h5>manifold {escape(m.name)}</h5>" + manifold(m)
    return text


def theorem(t):
    text = f"<h4>{escape(t.title)}</h4><p><b>{escape(t.conclusion)}</b></p>"
    if t.statement:
        text += f"<p>{escape(t.statement)}</p>"
    rows = [(escape(n.id), n.status.name, escape(n.title), escape(n.summary)) for n in t.nodes]
    page = escape(t.html(), quote=True)  # with its pictures; a document of its own
    return text + table(rows, ("step", "status", "what", "found")) + (
        f"<details><summary>the whole report</summary><iframe sandbox srcdoc=\"{page}\" "
        "style='width:100%;height:40em'></iframe></details>")


def verdict(v):
    if isinstance(v, _core.Rejected):
        return f"<p><b>rejected</b> at {escape(v.step)}: {escape(v.why)}</p>"
    lines = "".join(f"<br>{escape(line)}" for line in v.statement)
    return f"<p><b>accepted</b>, {v.trusted_steps} trusted steps{lines}</p>"


def integrals(s):
    said = [f"{f} = 0" for f in s.assumed_equations] + [f"{f} != 0" for f in s.assumed]
    text = f"<p>assumed: {escape(', '.join(said))}</p>" if said else ""
    if s.not_covered:
        text += f"<p>left out unless {escape(', '.join(f'{f} != 0' for f in s.not_covered))}</p>"
    rows = []
    for one in [*s.sets, *([s.elsewhere] if s.elsewhere is not None else [])]:
        where = ", ".join([f"{f} = 0" for f in one.equations] + [f"{f} != 0" for f in one.inequations])
        rows.append((escape(where or ("elsewhere" if s.sets else "these values" if text else "everywhere")),
                     "<br>".join(math(str(f.value)) for f in one.integrals),
                     escape(one.open or ("complete" if one.complete else ""))))
    return f"<p>{escape(s.searched)}</p>" + text + table(rows, ("where", "first integrals", ""))


def classification(c):
    rows = []
    for s in c.strata:
        why = ["<br>".join(math(str(f.value)) for f in s.integrals),
               "<br>".join(escape(f"{by.statement}; along {by.solution}: {by.reason}") for by in s.by),
               "<br>".join(escape(f"not checked: {by.not_checked}") for by in s.by if by.not_checked),
               "<br>".join(escape(tried) for tried in s.open_after)]
        rows.append((escape(", ".join(s.conditions) or "all parameters"), s.status.name, "<br>".join(filter(None, why))))
    assumed = f"<p>assumed: {escape(', '.join(c.assumptions))}</p>" if c.assumptions else ""
    trusted = f"<p>on trust: {escape('; '.join(c.trusted_steps))}</p>" if c.trusted_steps else ""
    return f"<p><b>{escape(c.statement)}</b></p>" + assumed + table(rows, ("parameters", "", "why")) + trusted


def monodromy(m):
    rows = []
    for loop in m.loops:
        matrix = table([[f"{z:.6g}" for z in row] for row in loop.matrix])
        rows.append((escape(loop.place), matrix, escape(loop.radius)))
    proof = "" if m.proves is None else "<p>the group of the normal form is SL(2, C)</p>"
    return table(rows, ("around", "matrix", "radius")) + proof


COLORS = ("#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#8c564b", "#17becf", "#7f7f7f")


def section(s, width=720, height=360, most=20000):
    """The points, one colour for each orbit; at most so many of them."""
    if s.drift > s.allowed_drift:
        return (f"<p>the integrals drift by {s.drift:.1e}, more than the {s.allowed_drift:.1e} that the scene "
                "allows: no picture</p>")
    step = max(1, len(s.x) // most)
    dots, low, high = [], (min(s.x, default=0), min(s.y, default=0)), (max(s.x, default=1), max(s.y, default=1))
    for i in range(0, len(s.x), step):
        x = width * (float(s.x[i]) - low[0]) / ((high[0] - low[0]) or 1)
        y = height * (high[1] - float(s.y[i])) / ((high[1] - low[1]) or 1)
        dots.append(f"<circle cx='{x:.1f}' cy='{y:.1f}' r='0.8' fill='{COLORS[int(s.orbit[i]) % len(COLORS)]}'/>")
    said = f"{len(s.orbits)} orbits, {len(s.x)} points, drift {s.drift:.1e}"
    if s.stopped or s.cut_short:
        said = "PARTIAL: " + said
    return (f"<svg viewBox='0 0 {width} {height}' width='{width}' height='{height}' "
            f"style='background:white;border:1px solid #888'>{''.join(dots)}</svg>"
            f"<p>{escape(s.title)}: {escape(s.labels[1])} over {escape(s.labels[0])}; {said}</p>")
