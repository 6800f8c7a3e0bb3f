"""Small figures as SVG text: what the scripts of this folder share.

A figure is 640 wide, its background is transparent, and its colours are of middle lightness: it can be read on white and on black.
Texts are marked up a little: `_{2}` or `_2` an index, `^{2}` or `^2` a power, `*x*` slanted (so a star itself is `∗`).

    figure = Figure(200, "What the figure shows")
    a = figure.box(20, 20, 150, ["first line", "*y*'' = *r* *y*"])
    b = figure.box(300, 20, 150, ["second"], colour=GREEN)
    figure.join(a, "right", b, "left", "yes")
    figure.save(folder / "name.svg")
"""

import html
import math
import re

WIDTH = 640
BLUE, RED, GREEN, ORANGE, VIOLET, GREY = "#4a6fa5", "#c2554f", "#4b9460", "#c17f2c", "#8a63a8", "#888888"
TEXT = "#777777"  # contrast above 4 on white and on #111
SIZE = 14
MARK = re.compile(r"([_^])(?:\{([^}]*)\}|(.))|\*([^*]+)\*|([^_^*]+)")


def number(value):
    """At most one digit after the point; never -0."""
    return f"{round(value, 1) + 0:g}"


def spans(marked):
    """The markup of a text; an index moves the line of writing, and the next piece moves it back."""
    written, shift = "", 0
    for sign, long, short, slanted, plain in MARK.findall(marked):
        wanted = {"_": 4, "^": -5}.get(sign, 0)
        inner = long or short or slanted or plain
        attributes = f' dy="{wanted - shift}"' if wanted != shift else ""
        attributes += ' font-size="11"' if sign else ""
        attributes += ' font-style="italic"' if slanted else ""
        shift = wanted
        inner = html.escape(inner, quote=False)
        written += f"<tspan{attributes}>{inner}</tspan>" if attributes else inner
    return written


class Box:
    """A rectangle and the middles of its sides."""

    def __init__(self, x, y, width, height):
        self.x, self.y, self.width, self.height = x, y, width, height

    def side(self, name, along=0.5):
        """A place on the side `name`: `along` runs from left to right and from top to bottom."""
        across, down = self.x + along * self.width, self.y + along * self.height
        return {"left": (self.x, down), "right": (self.x + self.width, down),
                "top": (across, self.y), "bottom": (across, self.y + self.height)}[name]


class Figure:
    def __init__(self, height, title, width=WIDTH):
        self.width, self.height, self.title, self.parts = width, height, title, []

    def raw(self, part):
        self.parts.append(part)

    def text(self, x, y, marked, anchor="middle", size=SIZE, colour=TEXT, bold=False):
        """One line; y is the line of writing."""
        attributes = f' text-anchor="{anchor}"' if anchor != "start" else ""
        attributes += f' font-size="{size}"' if size != SIZE else ""
        attributes += f' fill="{colour}"' if colour != TEXT else ""
        attributes += ' font-weight="bold"' if bold else ""
        self.raw(f'<text x="{number(x)}" y="{number(y)}"{attributes}>{spans(marked)}</text>')

    def texts(self, x, y, lines, step=18, **how):
        for k, line in enumerate(lines):
            self.text(x, y + k * step, line, **how)

    def box(self, x, y, width, lines, height=None, colour=BLUE, fill=0.12, round=6, size=SIZE, bold=False):
        """A rectangle with lines of text in its middle; returns where it is."""
        height = height or 18 * len(lines) + 14
        self.raw(f'<rect x="{number(x)}" y="{number(y)}" width="{number(width)}" height="{number(height)}" rx="{round}" '
                 f'fill="{colour}" fill-opacity="{fill}" stroke="{colour}" stroke-width="1.5"/>')
        first = y + height / 2 - 9 * (len(lines) - 1) + 5
        for k, line in enumerate(lines):
            self.text(x + width / 2, first + 18 * k, line, size=size, bold=bold and k == 0)
        return Box(x, y, width, height)

    def line(self, points, colour=GREY, width=1.5, dash="", fill="none", opacity=1, closed=False):
        """A polyline, or with `closed` a polygon."""
        written = " ".join(f"{number(x)},{number(y)}" for x, y in points)
        attributes = f' stroke-dasharray="{dash}"' if dash else ""
        attributes += f' fill-opacity="{opacity}"' if fill != "none" else ""
        self.raw(f'<{"polygon" if closed else "polyline"} points="{written}" fill="{fill}" stroke="{colour}" '
                 f'stroke-width="{width}"{attributes}/>')

    def path(self, data, colour=GREY, width=1.5, dash="", fill="none", opacity=1):
        """A path in SVG's own letters (M, L, C, A, Z, ...)."""
        attributes = f' stroke-dasharray="{dash}"' if dash else ""
        attributes += f' fill-opacity="{opacity}"' if fill != "none" else ""
        self.raw(f'<path d="{data}" fill="{fill}" stroke="{colour}" stroke-width="{width}"{attributes}/>')

    def curve(self, function, start, stop, steps=60, **how):
        """The points function(t) = (x, y), t from start to stop."""
        self.line([function(start + (stop - start) * k / steps) for k in range(steps + 1)], **how)

    def circle(self, x, y, radius, colour=GREY, width=1.5, fill="none", opacity=0.12, dash=""):
        attributes = f' stroke-dasharray="{dash}"' if dash else ""
        attributes += f' fill-opacity="{opacity}"' if fill != "none" else ""
        self.raw(f'<circle cx="{number(x)}" cy="{number(y)}" r="{number(radius)}" fill="{fill}" stroke="{colour}" '
                 f'stroke-width="{width}"{attributes}/>')

    def point(self, x, y, marked="", colour=RED, radius=4, dx=0, dy=-10, anchor="middle", open=False):
        """A dot (or with `open` a small circle) and its name at (dx, dy) from it."""
        self.raw(f'<circle cx="{number(x)}" cy="{number(y)}" r="{radius}" fill="{"none" if open else colour}" stroke="{colour}" '
                 f'stroke-width="1.5"/>')
        if marked:
            self.text(x + dx, y + dy, marked, anchor=anchor)

    def arrow(self, points, marked="", colour=GREY, width=1.5, dash="", dx=0, dy=-6, anchor="middle", both=False):
        """A broken line that ends in an arrow head; its name stands at (dx, dy) from the middle of its longest piece."""
        points = list(points)
        heads = [(points[-2], points[-1])] + ([(points[1], points[0])] if both else [])
        pieces = sorted(zip(points, points[1:]), key=lambda ab: -math.dist(*ab))
        middle = ((pieces[0][0][0] + pieces[0][1][0]) / 2, (pieces[0][0][1] + pieces[0][1][1]) / 2)
        self.line(points, colour=colour, width=width, dash=dash)
        for (x0, y0), (x1, y1) in heads:
            angle = math.atan2(y1 - y0, x1 - x0)
            wings = [(x1 - 9 * math.cos(angle + turn), y1 - 9 * math.sin(angle + turn)) for turn in (0.4, -0.4)]
            self.line([wings[0], (x1, y1), wings[1]], colour=colour, width=1, fill=colour, closed=True)
        if marked:
            self.text(middle[0] + dx, middle[1] + dy, marked, anchor=anchor)

    def join(self, one, side, other, towards, marked="", along=0.5, onto=0.5, **how):
        """An arrow from a side of a box to a side of another, with right angles where they do not face each other."""
        a, b = one.side(side, along), other.side(towards, onto)
        upright, upright_end = side in ("top", "bottom"), towards in ("top", "bottom")
        if abs(a[0] - b[0]) < 0.5 or abs(a[1] - b[1]) < 0.5:
            points = [a, b]
        elif upright and upright_end:
            points = [a, (a[0], (a[1] + b[1]) / 2), (b[0], (a[1] + b[1]) / 2), b]
        elif not upright and not upright_end:
            points = [a, ((a[0] + b[0]) / 2, a[1]), ((a[0] + b[0]) / 2, b[1]), b]
        else:
            points = [a, (a[0], b[1]) if upright else (b[0], a[1]), b]
        self.arrow(points, marked, **how)

    def axes(self, x, y, right, up, across="", upwards="", left=0, down=0):
        """Two axes through (x, y), with their names at the ends."""
        self.arrow([(x - left, y), (x + right, y)])
        self.arrow([(x, y + down), (x, y - up)])
        if across:
            self.text(x + right + 6, y + 5, across, anchor="start")
        if upwards:
            self.text(x, y - up - 8, upwards)

    def svg(self):
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" width="{self.width}" '
                f'height="{self.height}" font-family="DejaVu Sans,Verdana,sans-serif" font-size="{SIZE}" fill="{TEXT}">')
        return "\n".join([head, f"<title>{html.escape(self.title, quote=False)}</title>", *self.parts, "</svg>", ""])

    def save(self, path):
        path.write_text(self.svg(), encoding="utf-8")


def run(figures, folder):
    """Writes every figure of {name: function that makes it}; the scripts end with it."""
    for name, make in figures.items():
        make().save(folder / f"{name}.svg")
