"""Makes a site of the pages of this repository (./mien docs).

The pages stay where they are, beside the code: Sphinx reads the repository as it is, MyST resolves
the links between pages and their headings, and other linked files are copied. A page that the
navigation does not name, and a link that leads nowhere, is an error (sphinx-build -W).
"""

import re
from pathlib import Path

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

html_theme = "furo"
html_title = f"mien {release}"
html_static_path = ["static"]
html_css_files = ["site.css"]
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


def setup(app):
    app.connect("source-read", add_navigation)
