"""Sphinx: the pages of docs/ as a site.  tools/site runs it."""

import os
import sys

sys.path.insert(0, os.path.dirname(__file__))

project = "kovacic"
author = "the kovacic authors"
project_copyright = ""
html_title = "kovacic"
html_show_copyright = html_show_sphinx = html_copy_source = html_show_sourcelink = False
language = "en"
smartquotes = False  # y'' is not a quotation

extensions = ["myst_parser", "dark", "katex", "page_links", "repository", "snippets"]
html_math_renderer = "katex"
source_suffix = {".md": "markdown"}
exclude_patterns = ["accuracy", "guide/*.ipynb"]
myst_heading_anchors = 3
myst_enable_extensions = ["colon_fence", "dollarmath"]
myst_dmath_allow_digits = True
suppress_warnings = ["myst.header", "misc.highlighting_failure", "myst.xref_missing", "myst.nested_header"]
highlight_language = "none"
pygments_style = "friendly"
pygments_dark_style = "monokai"

html_theme = "furo"
html_static_path = [os.path.join(os.path.dirname(__file__), "static")]
html_css_files = ["site.css"]
html_theme_options = {"navigation_with_keys": True, "top_of_page_button": None}
