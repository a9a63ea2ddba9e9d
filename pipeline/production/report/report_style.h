#pragma once

#include <string_view>

namespace mien::pipeline {

/// Style sheet of report.html: light and dark, screen and paper.
inline constexpr std::string_view report_style = R"(:root {
  color-scheme: light dark;
  --ink: #1d2126; --quiet: #5b6570; --paper: #ffffff; --card: #f4f6f8; --line: #d6dbe1;
  --target: #1f7a45; --created: #2a62b8; --reference: #b23c30; --warn: #fde9bd; --warn-ink: #5c4300;
}
@media (prefers-color-scheme: dark) {
  :root {
    --ink: #e7eaee; --quiet: #a3adb8; --paper: #15181c; --card: #1e2329; --line: #363d46;
    --target: #5cc389; --created: #7aa9f0; --reference: #ee8a7f; --warn: #4b3a10; --warn-ink: #ffe7ae;
  }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 86rem; padding: 2rem 1.5rem; background: var(--paper); color: var(--ink);
  font: 16px/1.5 "Noto Sans", "Noto Sans CJK JP", system-ui, sans-serif; }
h1 { font-size: 2rem; margin: 0 0 .5rem; }
h2 { font-size: 1.3rem; margin: 2.5rem 0 1rem; }
h3 { margin: 0 0 .6rem; font-size: 1.1rem; }
h3 small { color: var(--quiet); font-weight: 400; }
.cards { display: grid; gap: 1.5rem; grid-template-columns: repeat(auto-fill, minmax(22rem, 1fr)); }
article { background: var(--card); border-top: .3rem solid var(--line); border-radius: .4rem; padding: 1rem; }
article.target { border-color: var(--target); }
article.created { border-color: var(--created); }
article.reference { border-color: var(--reference); }
video, img { display: block; width: 100%; height: auto; border-radius: .3rem; margin-bottom: .6rem; background: #ccc; }
figure { margin: 1.5rem 0; }
figure img { border: 1px solid var(--line); background: #fff; }
figcaption, p, footer { color: var(--quiet); }
table { border-collapse: collapse; width: 100%; margin: .6rem 0; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: .2rem .6rem .2rem 0; border-bottom: 1px solid var(--line); font-weight: 400; }
thead th { color: var(--quiet); font-size: .85rem; }
.number { text-align: right; }
.wide { overflow-x: auto; }
.impressions th[scope="col"] { text-align: right; }
.impressions td { text-align: right; background: color-mix(in srgb, var(--tone) var(--far), transparent); }
.impressions .low { --tone: #d08a2e; }
.impressions .high { --tone: #3f8fb5; }
.expected { list-style: none; padding: 0; }
.holds::before { content: "✓ "; color: var(--target); font-weight: 700; }
.unsure::before { content: "? "; color: var(--quiet, #777); font-weight: 700; }
.fails::before { content: "✗ "; color: var(--reference); font-weight: 700; }
article, figure { content-visibility: auto; contain-intrinsic-size: auto 40rem; }
.parts a { margin-right: .6rem; }
summary { cursor: pointer; }
meter { width: 100%; min-width: 5rem; }
.simulated, .warnings { background: var(--warn); color: var(--warn-ink); border-radius: .4rem; padding: .7rem 1rem; }
.warnings { padding-left: 2rem; }
.errors { border-left: .3rem solid var(--reference); margin: .6rem 0; padding-left: 1.6rem; }
details ul { font-size: .9rem; padding-left: 1.2rem; }
a { color: inherit; }
@media print { video { display: none; } article, figure { break-inside: avoid; } }
)";

}  // namespace mien::pipeline
