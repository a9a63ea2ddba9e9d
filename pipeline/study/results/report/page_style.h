#pragma once

#include <string_view>

namespace mien::pipeline {

/// Style sheet of the page of results, for light and dark themes, screen and print.
inline constexpr std::string_view results_style = R"(:root {
  color-scheme: light dark;
  --ink: #1d2126; --quiet: #5b6570; --paper: #ffffff; --line: #d6dbe1; --card: #f4f6f8;
  --good: #1f7a45; --warn: #fde9bd; --warn-ink: #5c4300; --edge: #00000038;
}
@media (prefers-color-scheme: dark) {
  :root { --ink: #e7eaee; --quiet: #a3adb8; --paper: #15181c; --line: #363d46; --card: #1e2329;
    --good: #5cc389; --warn: #4b3a10; --warn-ink: #ffe7ae;
    --edge: #ffffff40; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 76rem; padding: 2rem 1.5rem 4rem; background: var(--paper);
  color: var(--ink); font: 16px/1.5 "Noto Sans", "Noto Sans CJK JP", system-ui, sans-serif; }
h1 { font-size: 1.9rem; margin: 0 0 .3rem; }
h2 { font-size: 1.35rem; margin: 3rem 0 .6rem; padding-top: .8rem; border-top: 1px solid var(--line); }
h3 { font-size: 1.05rem; margin: 1.6rem 0 .4rem; }
p { max-width: 60rem; }
nav { display: flex; flex-wrap: wrap; gap: .3rem 1.1rem; margin: 1rem 0; }
.quiet, figcaption, nav { color: var(--quiet); }
.simulated { background: var(--warn); color: var(--warn-ink); border-radius: .4rem;
  padding: .6rem 1rem; font-weight: 600; }
h2 .mark { background: var(--warn); color: var(--warn-ink); border-radius: 1rem; font-size: .75rem;
  font-weight: 600; padding: .15rem .6rem; vertical-align: middle; }
.wide { overflow-x: auto; max-width: 100%; scrollbar-width: thin; }
/* Shadows at the edges beyond which a table goes on: they scroll with the page, their covers with
   the table. */
.wide { background: linear-gradient(to right, var(--paper) 30%, transparent) left / 3rem 100%
    no-repeat local, linear-gradient(to left, var(--paper) 30%, transparent) right / 3rem 100%
    no-repeat local, linear-gradient(to right, var(--edge), transparent) left / .9rem 100%
    no-repeat scroll, linear-gradient(to left, var(--edge), transparent) right / .9rem 100%
    no-repeat scroll; }
.wide:focus-visible { outline: 2px solid var(--quiet); outline-offset: 2px; }
.wide th:first-child, .wide td:first-child { position: sticky; left: 0; background: var(--paper);
  padding-right: 1rem; box-shadow: inset 0 -1px 0 var(--line); }
table { border-collapse: collapse; font-size: .86rem; font-variant-numeric: tabular-nums; }
th, td { padding: .16rem .7rem .16rem 0; border-bottom: 1px solid var(--line); text-align: right;
  font-weight: 400; white-space: nowrap; }
td:first-child, th:first-child, td.text, th.text { text-align: left; }
td.text { white-space: normal; min-width: 5.5rem; overflow-wrap: break-word; }
.wide td.text:first-child { min-width: 9rem; }
td.prose { text-align: left; white-space: normal; min-width: 9rem; }
thead th { color: var(--quiet); font-size: .78rem; vertical-align: bottom; white-space: normal; }
tr.found td { font-weight: 600; }
tr.found td:first-child::after { content: " *"; color: var(--good); }
figure { margin: 1.2rem 0 1.8rem; }
figure img { display: block; max-width: 100%; height: auto; background: #fff;
  border: 1px solid var(--line); border-radius: .3rem; }
figcaption { font-size: .85rem; margin-top: .3rem; }
details { margin: .6rem 0; }
summary { cursor: pointer; color: var(--quiet); }
a { color: inherit; }
@media print { figure, tr { break-inside: avoid; } details { display: block; }
  .wide { overflow: visible; } .wide table { width: 100%; }
  .wide :is(th, td) { font-size: .5rem; white-space: normal; position: static; min-width: 0;
    padding: 1px 3px 1px 0; overflow-wrap: break-word; } }
)";

}  // namespace mien::pipeline
