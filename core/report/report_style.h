// SPDX-License-Identifier: MIT
#pragma once

namespace mocapress {

/// The style sheet of a report: light or dark by the reader's system, and light on paper. The
/// colours of series, s0 to s11, differ in lightness; markers tell series apart without colour.
inline constexpr const char* kReportStyle = R"css(
:root { color-scheme: light dark;
  --page: #f6f4f0; --card: #fffefb; --ink: #211f1d; --muted: #6d6862; --rule: #e2ddd4;
  --accent: #c23b2b; --far-sky: #fdfcf9; --near-sky: #ebe6dd; --floor: #8d8478; --shade: #3a3026;
  --g0: #a9a7a6; --g1: #b6b4b2; --g2: #c3c1be; --g3: #cfccc9;
  --f0: #8a281d; --f1: #a53124; --f2: #bf3b2c; --f3: #d84a38; --edge: #fffaf4;
  --s0: #cc3d2b; --s1: #2a69ad; --s2: #1f8a70; --s3: #bd7f00; --s4: #8459c4; --s5: #5f5b57;
  --s6: #b14d89; --s7: #728124; --s8: #8c5a2b; --s9: #0f8fa6; --s10: #15171c; --s11: #a08a00; }
@media (prefers-color-scheme: dark) { :root {
  --page: #121315; --card: #1b1d20; --ink: #ecebe8; --muted: #a09c96; --rule: #33363b;
  --accent: #ff7a66; --far-sky: #24272b; --near-sky: #16181a; --floor: #a7a197; --shade: #000000;
  --g0: #5a5d61; --g1: #696c70; --g2: #797c80; --g3: #8a8d91;
  --f0: #a8382b; --f1: #c84637; --f2: #e35846; --f3: #ff7561; --edge: #1b1d20;
  --s0: #ff7763; --s1: #69aef0; --s2: #45c9a5; --s3: #efb43c; --s4: #b796f2; --s5: #b5b0aa;
  --s6: #ef8cc5; --s7: #b7c95c; --s8: #d6a06c; --s9: #4fd2e8; --s10: #ffffff; --s11: #e6d04a; } }
@media print { :root { color-scheme: light; --page: #fff; --card: #fff; --ink: #000;
  --muted: #444; --rule: #bbb; --far-sky: #fff; --near-sky: #f1efeb; --edge: #fff;
  --floor: #8d8478; --shade: #3a3026; --accent: #b03020;
  --g0: #a9a7a6; --g1: #b6b4b2; --g2: #c3c1be; --g3: #cfccc9;
  --f0: #8a281d; --f1: #a53124; --f2: #bf3b2c; --f3: #d84a38;
  --s0: #cc3d2b; --s1: #2a69ad; --s2: #1f8a70; --s3: #a87000; --s4: #8459c4; --s5: #5f5b57;
  --s6: #b14d89; --s7: #728124; --s8: #8c5a2b; --s9: #0f8fa6; --s10: #15171c; --s11: #a08a00; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  body { font-size: 10pt; } main { max-width: none; padding: 0; }
  section, .tile { box-shadow: none; border-color: #ccc; padding: 0; border: 0; }
  figure, tr, .tile, .clip { break-inside: avoid; } h2 { break-after: avoid; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--ink);
  font: 15px/1.5 system-ui, "Segoe UI", "Helvetica Neue", Arial, sans-serif; }
main { max-width: 1120px; margin: 0 auto; padding: 40px 24px 64px; }
h1 { font-size: 30px; line-height: 1.15; letter-spacing: -0.02em; margin: 0 0 6px; }
h2 { font-size: 19px; letter-spacing: -0.01em; margin: 0 0 4px; }
h3 { font-size: 15px; margin: 22px 0 6px; }
p { margin: 0 0 12px; max-width: 76ch; } .muted, figcaption, small { color: var(--muted); }
section { background: var(--card); border: 1px solid var(--rule); border-radius: 12px;
  padding: 24px 26px; margin-top: 22px; }
.tiles { display: grid; grid-template-columns: repeat(auto-fit, minmax(230px, 1fr)); gap: 16px;
  margin-top: 24px; }
.tile { background: var(--card); border: 1px solid var(--rule); border-radius: 12px;
  padding: 16px 20px; }
.tile b { display: block; font-size: 32px; line-height: 1.15; letter-spacing: -0.02em;
  font-variant-numeric: tabular-nums; }
.tile.doubtful b { color: var(--s3); } .tile.wrong b { color: var(--accent); }
.tile span { color: var(--muted); font-size: 13.5px; }
.scroll { overflow-x: auto; } table { border-collapse: collapse; font-size: 13.5px; margin: 6px 0; }
th, td { padding: 5px 8px; text-align: right; border-bottom: 1px solid var(--rule);
  font-variant-numeric: tabular-nums; white-space: nowrap; }
th { font-weight: 600; vertical-align: bottom; } thead th { color: var(--muted); font-size: 13px;
  white-space: normal; max-width: 9em; }
thead th.group { max-width: none; }
th[scope=row], td.name, th.name { text-align: left; } .group { text-align: center; }
table:has(thead th:nth-child(9)) :is(th, td) { padding: 5px 5px; font-size: 12.5px;
  letter-spacing: -0.01em; }
td.paper, th.paper { color: var(--muted); background: color-mix(in srgb, var(--rule) 28%, transparent); }
td.best { font-weight: 700; } tr.sum td, tr.sum th { border-top: 2px solid var(--rule); }
td small { font-size: 12px; } td.wrap { white-space: normal; text-align: left; }
.signed :is(th, td) { vertical-align: top; } .signed td.wrap { min-width: 7em; }
.signed th[scope=row] { white-space: normal; min-width: 11em; }
.signed :is(th[scope=row], td.wrap) { overflow-wrap: anywhere; }
section + p { margin-top: 16px; }
#clips :is(th, td) { vertical-align: top; padding-inline: 4px; font-size: 12px; }
#clips td.wrap { min-width: 6em; } #clips td[data-key] { min-width: 12em; }
#clips :is(th[scope=row], td.name) { white-space: normal; }
@media screen { section:has(#clips) { padding-inline: 14px;
  margin-inline: min(0px, (1072px - min(100vw - 48px, 1800px)) / 2); } }
.filters { display: flex; flex-wrap: wrap; align-items: center; gap: 6px 8px; max-width: none; }
.filters :is(select, input, button) { font: inherit; font-size: 13px; padding: 3px 8px; color: var(--ink);
  background: var(--card); border: 1px solid var(--rule); border-radius: 6px; }
.legend { display: flex; flex-wrap: wrap; gap: 4px 20px; margin: 8px 0 4px; padding: 0;
  list-style: none; font-size: 13.5px; }
.sign { width: 26px; height: 12px; margin-right: 7px; vertical-align: middle; }
.chart { width: 100%; height: auto; display: block; font-size: 12px; }
.chart text { fill: var(--muted); } .chart .label { font-size: 13px; font-weight: 600; }
.chart .grid { stroke: var(--rule); stroke-width: 1; fill: none; }
.chart .guide { stroke: var(--muted); stroke-width: 1; stroke-dasharray: 2 4; fill: none; }
.chart .leader { stroke: var(--rule); stroke-width: 1; fill: none; }
.line { fill: none; stroke: currentColor; stroke-width: 2; stroke-linejoin: round; }
.line.s0 { stroke-width: 3; } .mark { fill: currentColor; stroke: var(--card); stroke-width: 1; }
.mark.paper { fill: var(--card); stroke: currentColor; stroke-width: 1.6; }
.chart text.label { fill: currentColor; }
.s0 { color: var(--s0); } .s1 { color: var(--s1); } .s2 { color: var(--s2); }
.s3 { color: var(--s3); } .s4 { color: var(--s4); } .s5 { color: var(--s5); }
.s6 { color: var(--s6); } .s7 { color: var(--s7); } .s8 { color: var(--s8); }
.s9 { color: var(--s9); } .s10 { color: var(--s10); } .s11 { color: var(--s11); }
.multiples { display: grid; grid-template-columns: repeat(auto-fill, minmax(310px, 1fr));
  gap: 18px; margin-top: 10px; } figure { margin: 0; } .clip h3 { margin: 0; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(300px, 1fr)); gap: 14px;
  margin: 10px 0 6px; }
.pair figcaption, .strip figcaption { padding: 7px 2px 0; font-size: 13.5px; }
.strip { margin-top: 16px; } .cells { display: flex; gap: 2px; }
.cells .scene { border-radius: 0; flex: 1 1 0; min-width: 0; } .cells .scene:first-child { border-radius: 10px 0 0 10px; }
.cells .scene:last-child { border-radius: 0 10px 10px 0; }
figcaption b { color: var(--ink); }
.scene { width: 100%; height: auto; display: block; border-radius: 10px;
  background: linear-gradient(var(--far-sky), var(--near-sky)); }
.scene .floor { fill: none; stroke: var(--floor); stroke-width: 1; stroke-linecap: round; }
.scene .f0 { opacity: 0.55; } .scene .f1 { opacity: 0.4; } .scene .f2 { opacity: 0.24; }
.scene .f3 { opacity: 0.1; }
.scene .shadow { fill: var(--shade); opacity: 0.17; filter: blur(2px); }
.scene .ghost path { stroke: var(--edge); stroke-width: 0.5; } .scene .ghost { opacity: 0.9; }
.scene .figure path { stroke: var(--edge); stroke-width: 0.7; }
.ghost .b0 { fill: var(--g0); } .ghost .b1 { fill: var(--g1); } .ghost .b2 { fill: var(--g2); }
.ghost .b3 { fill: var(--g3); } .figure .b0 { fill: var(--f0); } .figure .b1 { fill: var(--f1); }
.figure .b2 { fill: var(--f2); } .figure .b3 { fill: var(--f3); }
.scene .gap { fill: none; stroke: var(--ink); stroke-width: 1.4; }
.scene .gap circle { stroke-dasharray: 3 3; }
.scene .gap text { fill: var(--ink); stroke: var(--far-sky); stroke-width: 4;
  paint-order: stroke; font-size: 15px; font-weight: 600; }
.scene .trail path { fill: none; stroke-width: 3; stroke-linejoin: round; stroke-linecap: round; }
.scene .trail.was { stroke: var(--g1); fill: var(--g1); } .scene .trail.is { stroke: var(--ink); fill: var(--ink); }
.scene .trail circle { stroke: none; }
.sights { width: 100%; max-width: 720px; height: auto; display: block; font-size: 11px; }
.sights text { fill: var(--muted); } .seen0 { fill: var(--rule); }
.seen1 { fill: #f2b705; } .seen2 { fill: #d53e1a; }
summary { cursor: pointer; color: var(--muted); }
dl { margin: 0; display: grid; grid-template-columns: max-content 1fr; gap: 5px 18px; }
dt { font-weight: 600; } dd { margin: 0; color: var(--muted); }
@media (max-width: 640px) { main { padding: 20px 12px; } section { padding: 16px 14px; }
  dl { grid-template-columns: 1fr; } }
)css";

}  // namespace mocapress
