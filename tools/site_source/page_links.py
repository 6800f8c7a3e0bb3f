"""A page of theory that another one names, as in "kimura.md 2.2", is a link."""

import re

from docutils import nodes
from sphinx.transforms import SphinxTransform

PAGE = re.compile(r"\b(\w+)\.md\b")


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
                         nodes.reference("", found.group(1), internal=True,
                                         refuri=self.app.builder.get_relative_uri(self.env.docname, page))]
                at = found.end()
        return made + [nodes.Text(text[at:])] if made else []


def ancestors(node):
    while node.parent is not None:
        node = node.parent
        yield node


def setup(app):
    app.add_transform(PageLinks)
    return {"parallel_read_safe": True}
