"""Links say the title of the page that they lead to: "[x.md](x.md)", and "kimura.md 2.2" on a page of theory."""

import pathlib
import re

from docutils import nodes
from sphinx.transforms import SphinxTransform

PAGE = re.compile(r"\b(\w+)\.md\b")
LINK = re.compile(r"\[[\w/-]*\w\.md\]\(([\w/.-]*\.md)\)")


def title(path):
    """The heading of a page up to its first colon."""
    first = path.read_text(encoding="utf-8").partition("\n")[0]
    return re.sub(r"[`$*]", "", first.lstrip("# ")).partition(":")[0]


def write_titles(app, docname, source):
    folder = pathlib.Path(app.env.doc2path(docname)).parent
    source[0] = LINK.sub(lambda found: f"[{title(folder / found[1])}]({found[1]})", source[0])


class PageLinks(SphinxTransform):
    default_priority = 820

    def apply(self, **_):
        if not self.env.docname.startswith("theory/"):
            return
        for text in list(self.document.findall(nodes.Text)):
            apart = (nodes.literal, nodes.FixedTextElement, nodes.raw, nodes.comment, nodes.reference, nodes.math)
            if not any(isinstance(parent, apart) for parent in ancestors(text)):
                made = self.linked(text.astext())
                if made:
                    text.parent.replace(text, made)

    def linked(self, text):
        made, at = [], 0
        for found in PAGE.finditer(text):
            page = f"theory/{found.group(1)}"
            if page in self.env.found_docs:
                made += [nodes.Text(text[at:found.start()]),
                         nodes.reference("", title(pathlib.Path(self.env.doc2path(page))), internal=True,
                                         refuri=self.app.builder.get_relative_uri(self.env.docname, page))]
                at = found.end()
        return made + [nodes.Text(text[at:])] if made else []


def ancestors(node):
    while node.parent is not None:
        node = node.parent
        yield node


def setup(app):
    app.connect("source-read", write_titles)
    app.add_transform(PageLinks)
    return {"parallel_read_safe": True}
