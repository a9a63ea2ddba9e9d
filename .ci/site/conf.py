"""Makes a site of the pages of this repository (./mien docs).

The pages stay where they are, beside the code: Sphinx reads the repository as it is, MyST resolves
the links between pages and their headings, and other linked files are copied. A page that the
navigation does not name, and a link that leads nowhere, is an error (sphinx-build -W). The search
works without a server.
"""

import json
import re
from pathlib import Path

from pygments.lexers.data import YamlLexer

root = Path(__file__).resolve().parents[2]

# The order of a user's work. Each chapter: its heading, and its pages with the names they have in it.
chapters = [
    ("Start", [
        ("Your first study", "manifests/tutorials/first-study"),
        ("Your first farm", "manifests/tutorials/first-farm"),
        ("Your first guard", "manifests/tutorials/first-guard"),
        ("Questions and answers", "manifests/QUESTIONS"),
    ]),
    ("Motions and looks", [
        ("Motions and formats", "motion/README"),
        ("Looks", "scenes/README"),
        ("Gallery", "manifests/GALLERY"),
    ]),
    ("Stimuli", [
        ("Manifests", "manifests/README"),
        ("Tables of a run", "manifests/TABLES"),
        ("The studio", "pipeline/study/studio/README"),
        ("On a farm", "pipeline/farm/README"),
        ("Regression tests", "pipeline/regression/README"),
    ]),
    ("Studies with people", [
        ("Run the study", "pipeline/study/questionnaire/README"),
        ("Kinds of trials", "pipeline/study/trials/README"),
        ("Run it online", "pipeline/study/questionnaire/ONLINE"),
        ("The server", "pipeline/study/server/README"),
        ("Tables of a questionnaire", "pipeline/study/questionnaire/TABLES"),
        ("Results", "pipeline/study/results/README"),
        ("From answers to adjectives", "pipeline/study/analysis/README"),
        ("The next films", "pipeline/study/adaptive/README"),
        ("Adaptive experiments", "pipeline/study/chains/README"),
        ("Matching experiments", "pipeline/study/matching/README"),
        ("Live motions", "pipeline/study/live/README"),
    ]),
    ("About mien", [
        ("Changelog", "CHANGELOG"),
        ("Versions of files", "pipeline/VERSIONS"),
        ("Security", "SECURITY"),
        ("Decisions", "motion/decisions"),
        ("Rendering", "render/README"),
        ("Production", "pipeline/README"),
        ("Contributing", "CONTRIBUTING"),
        ("Tests", "tests/README"),
    ]),
]

project = "mien"
author = "the mien authors"
project_copyright = author
version = release = re.search(r"project\(mien VERSION (\S+)", (root / "CMakeLists.txt").read_text())[1]

extensions = ["myst_parser"]
root_doc = "README"
source_suffix = {".md": "markdown"}
exclude_patterns = ["build*", "out", ".*", "**/node_modules", "**/.*"]
myst_heading_anchors = 4
highlight_language = "none"

html_theme = "sphinx_rtd_theme"
html_theme_options = {"navigation_depth": 2, "titles_only": False}
html_title = f"mien {release}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_show_sourcelink = False
templates_path = ["templates"]
html_additional_pages = {"index": "to_start.html"}
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False


def add_navigation(_app, page, source):
    """The overview has the table of contents, which its readers elsewhere do not need."""
    if page != root_doc:
        return
    for caption, pages in chapters:
        entries = "".join(f"{name} <{target}>\n" for name, target in pages)
        source[0] += f"\n```{{toctree}}\n:hidden:\n:caption: {caption}\n\n{entries}```\n"


def add_texts_to_search(app, page, _template, _context, _doctree):
    """What static/from_disk.js needs."""
    if page == "search":
        app.add_js_file("page_texts.js")
        app.add_js_file("from_disk.js")


def write_texts(app, failure):
    if failure or app.builder.name != "html":
        return
    texts = {
        app.builder.get_target_uri(page): app.env.get_doctree(page).astext()
        for page in sorted(app.env.found_docs)
    }
    file = Path(app.outdir, "_static", "page_texts.js")
    file.write_text(f"const pageTexts = {json.dumps(texts, ensure_ascii=False)};\n")


def setup(app):
    app.add_lexer("yml", YamlLexer)
    app.connect("source-read", add_navigation)
    app.connect("html-page-context", add_texts_to_search)
    app.connect("build-finished", write_texts)
