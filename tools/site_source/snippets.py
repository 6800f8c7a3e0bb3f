"""What a search finds is shown with the words around it, also where the site is opened as files: a browser lets no page
read another file, so that the search page has the text of all pages."""

import html
import json
import pathlib
import re


def text_of(page):
    article = re.search(r'(?s)<article role="main">(.*?)</article>', page)
    text = re.sub(r"(?s)<(style|script)\b.*?</\1>|<a class=\"headerlink\".*?</a>|<[^>]+>", " ", article.group(1) if article else "")
    return " ".join(html.unescape(text).split())


def write(app, error):
    out = pathlib.Path(app.outdir)
    if error or app.builder.name != "html":
        return
    texts = {name: text_of((out / f"{name}.html").read_text(encoding="utf-8")) for name in sorted(app.env.found_docs)}
    (out / "_static/texts.js").write_text(f"const TEXTS = {json.dumps(texts, ensure_ascii=False)};\n", encoding="utf-8")


def only_where_one_searches(app, pagename, templatename, context, doctree):
    if pagename == "search":
        app.add_js_file("texts.js")
        app.add_js_file("snippets.js")


def setup(app):
    app.connect("html-page-context", only_where_one_searches)
    app.connect("build-finished", write)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
