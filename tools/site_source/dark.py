"""Debian's furo is compiled without the rules for a browser that prefers dark pages; these are its rules for the dark
theme, once more, for such a browser."""
import os
import re

from sphinx.errors import SphinxError


def write(app, error):
    """_static/dark.css, from what the theme says of data-theme="dark\""""
    static = os.path.join(app.outdir, "_static")
    if error or not os.path.isdir(static):
        return
    with open(os.path.join(static, "styles", "furo.css"), encoding="utf-8") as f:
        theme = f.read()
    rules = re.findall(r'(?:html )?body\[data-theme="dark"\][^{}]*\{[^{}]*\}', theme)
    rules = [rule.replace('[data-theme="dark"]', ':not([data-theme="light"])') for rule in rules if "theme-toggle" not in rule]
    if not rules:
        raise SphinxError("the theme has no rules for dark pages")
    with open(os.path.join(static, "dark.css"), "w", encoding="utf-8") as f:
        f.write("@media (prefers-color-scheme: dark) {\n" + "\n".join(rules) + "\n}\n")


def setup(app):
    app.add_css_file("dark.css")
    app.connect("build-finished", write)
    return {"parallel_read_safe": True}
