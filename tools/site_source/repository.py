"""Links of docs/ to the rest of the repository: the site has the pages of docs/ only, so that such a link is its text."""

from docutils import nodes
from sphinx import addnodes
from sphinx.transforms.post_transforms import SphinxPostTransform


class OutsideLinks(SphinxPostTransform):
    default_priority = 5

    def run(self, **_):
        for link in list(self.document.findall(addnodes.download_reference)):
            link.replace_self(nodes.literal("", link.astext()))
        for link in list(self.document.findall(addnodes.pending_xref)):
            target = link.get("reftarget", "")
            if target == "README.md" or target.endswith("/README.md"):
                link["reftarget"] = target.replace("README.md", "where.md")


def setup(app):
    app.add_post_transform(OutsideLinks)
    return {"parallel_read_safe": True}
