"""Notebooks as pages of the site, with the output of a run of now.

usage: notebooks.py NOTEBOOK PAGE
"""

import ast
import contextlib
import html
import io
import json
import pathlib
import re
import sys


def cells(notebook):
    """(source, what it printed, its last value) of each cell; a text cell has None for both.  Also the names at the end."""
    names, found = {"__name__": "notebook"}, []
    for cell in json.loads(pathlib.Path(notebook).read_text(encoding="utf-8"))["cells"]:
        source = "".join(cell["source"])
        if cell["cell_type"] != "code":
            found.append((source, None, None))
            continue
        tree = ast.parse(source)
        last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(compile(tree, "notebook", "exec"), names)
            value = eval(compile(ast.Expression(last.value), "notebook", "eval"), names) if last else None
        found.append((source, printed.getvalue(), value))
    return found, names


def shown(value):
    """A value as Jupyter shows it: as a formula, as HTML, as text."""
    if hasattr(value, "_repr_html_") and value._repr_html_():
        text = re.sub(r"\$+([^$]*)\$+", r'<span class="math">\1</span>', value._repr_html_())
        return f"```{{raw}} html\n<div class=\"table-wrapper shown\">{text}</div>\n```\n"
    try:
        import sympy
    except ImportError:
        sympy = None
    if sympy and isinstance(value, sympy.Basic):
        return f'```{{raw}} html\n<div class="math display">{html.escape(sympy.latex(value))}</div>\n```\n'
    return printed_text(repr(value))


def printed_text(text):
    return f"```{{raw}} html\n<pre class=\"shown\">{html.escape(text)}</pre>\n```\n"


def page(notebook):
    parts = []
    for source, printed, value in cells(notebook)[0]:
        if printed is None:
            parts.append(source + "\n")
            continue
        parts.append(f"```python\n{source}\n```\n")
        if printed:
            parts.append(printed_text(printed.rstrip()))
        if value is not None:
            parts.append(shown(value))
    return "\n".join(parts)


def main():
    notebook, target = sys.argv[1:]
    sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "build/release/python"))
    pathlib.Path(target).write_text(page(notebook), encoding="utf-8")


if __name__ == "__main__":
    main()
