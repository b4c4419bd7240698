// SPDX-License-Identifier: MIT
#pragma once

namespace mocapress {

/// Hides the section around it until kReportScript shows the first rows, since browsers take a
/// second to lay out thousands of rows.
inline constexpr const char* kHidingScript = "document.currentScript.parentNode.hidden = true;";

/// The texts that kReportScript, and the buttons of review_buttons(), pass to say().
inline constexpr const char* kReportTexts[] = {
    "any visibility", "visible", "borderline", "not visible", "any verdict", "approved", "rejected",
    "stale", "none", "with warnings or without", "with warnings", "without warnings",
    "max over, cm", "ratio below", "name, preset, reason ...", "show all", "%1 of %2 clips",
    "%1 of %2 clips, the first %3 of them below",
    // headings by which the script finds columns
    "visibility", "verdict", "note", "warnings", "ratio", "max", "preset"};

/// Sorts the table of clips: at first by visibility, later by the heading that was clicked, largest
/// first. Filters clips by visibility, verdict, error, ratio, warnings and words. Shows the first
/// rows, or all on demand. Without this script the page is complete, too. The script must contain
/// neither < nor &, since the page is XML.
inline constexpr const char* kReportScript = R"(
const table = document.getElementById("clips");
const body = table.tBodies[0];
const heads = Array.from(table.tHead.rows[0].cells);
const column = name => heads.findIndex(head => head.textContent === say(name));
const text = (row, name) => row.cells[column(name)].textContent;
const number = (row, name) => parseFloat(text(row, name).replace(",", ""));
const tests = [];
const bar = document.createElement("p");
bar.className = "filters";
function add(field, test) {
  field.oninput = filter;
  tests.push(row => field.value === "" ? true : test(row, field.value));
  bar.append(field, " ");
}
function choice(first, others, test) {
  const field = document.createElement("select");
  field.append(new Option(say(first), ""), ...others.map(word => new Option(say(word), word)));
  add(field, test);
}
function input(type, hint, test) {
  const field = document.createElement("input");
  field.type = type;
  field.step = "any";
  field.placeholder = say(hint);
  field.setAttribute("aria-label", say(hint));
  add(field, test);
}
choice("any visibility", ["visible", "borderline", "not visible"],
  (row, word) => row.cells[column("visibility")].dataset.sight === word);
choice("any verdict", ["approved", "rejected", "stale", "none"],
  (row, word) => row.cells[column("verdict")].dataset.verdict.split(" ").includes(word));
choice("with warnings or without", ["with warnings", "without warnings"],
  (row, word) => number(row, "warnings") > 0 === (word === "with warnings"));
input("number", "max over, cm", (row, least) => number(row, "max") > Number(least));
input("number", "ratio below", (row, most) => Number(most) > number(row, "ratio"));
input("search", "name, preset, reason ...",
  (row, words) => row.textContent.toLowerCase().includes(words.toLowerCase()));
const shown = document.createElement("span");
const more = document.createElement("button");
more.textContent = say("show all");
bar.append(shown, " ", more);
table.parentNode.before(bar);
const first = 200;
let rows = Array.from(body.rows);
let most = first;
function filter() {
  const found = rows.filter(row => tests.every(test => test(row)));
  body.replaceChildren(...found.slice(0, most));
  more.hidden = most >= found.length;
  shown.textContent = more.hidden ? say("%1 of %2 clips", found.length, rows.length)
    : say("%1 of %2 clips, the first %3 of them below", found.length, rows.length, most);
}
more.onclick = () => {
  most = Infinity;
  filter();
  most = first;
};
function key(row, at) {
  const cell = row.cells[at];
  const words = cell.dataset.key || cell.textContent;
  const value = at === 0 ? NaN : parseFloat(words);
  return isNaN(value) ? words : value;
}
function order(a, b) {
  if (typeof a === "number") return typeof b === "number" ? b - a : -1;
  return typeof b === "number" ? 1 : a.localeCompare(b);
}
let sorted = -1;
function sort(at) {
  if (sorted === at) {
    rows.reverse();
  } else {
    const keyed = rows.map(row => [key(row, at), row]);
    rows = keyed.sort((a, b) => order(a[0], b[0])).map(pair => pair[1]);
  }
  sorted = at;
  filter();
}
for (const head of heads) {
  head.style.cursor = "pointer";
  head.onclick = () => sort(head.cellIndex);
}
sort(column("visibility"));
table.closest("section").hidden = false;
)";

}  // namespace mocapress
