"""Formulas by KaTeX, from Debian's package: the site needs no network.  docs/ writes them as TeX between dollars."""

import html
import pathlib
import shutil

KATEX = pathlib.Path("/usr/share/javascript/katex")
FILES = ["katex.min.css", "katex.min.js"]


def inline(writer, node):
    writer.body.append(f'<span class="math">{html.escape(node.astext())}</span>')
    return skip()


def block(writer, node):
    writer.body.append(f'<div class="math display">{html.escape(node.astext())}</div>\n')
    return skip()


def skip():
    from docutils import nodes
    raise nodes.SkipNode


def copy(app, error):
    target = pathlib.Path(app.outdir) / "_static" / "katex"
    if error:
        return
    shutil.rmtree(target, ignore_errors=True)
    (target / "fonts").mkdir(parents=True)
    for name in FILES:
        shutil.copy(KATEX / name, target / name)
    for font in (KATEX / "fonts").glob("*.woff2"):
        shutil.copy(font, target / "fonts" / font.name)


def setup(app):
    app.add_html_math_renderer("katex", (inline, None), (block, None))
    app.add_css_file("katex/katex.min.css")
    app.add_js_file("katex/katex.min.js", defer="defer")
    app.add_js_file("formulas.js", defer="defer")
    app.connect("build-finished", copy)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
