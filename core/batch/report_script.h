// SPDX-License-Identifier: MIT
#pragma once

namespace mocapress {

/// Sorts the table of clips by a click on a heading, largest first, and at the start by what the
/// eye sees; filters it by that, by verdict, error, ratio, warnings and words. The page reads well
/// without it. Neither < nor & may stand here: the page is XML, too.
inline constexpr const char* kReportScript = R"(
const table = document.getElementById("clips");
const body = table.tBodies[0];
const heads = Array.from(table.tHead.rows[0].cells);
const column = name => heads.findIndex(head => head.textContent === name);
const text = (row, name) => row.cells[column(name)].textContent;
const number = (row, name) => parseFloat(text(row, name).replace(",", ""));
const tests = [];
const bar = document.createElement("p");
function add(field, test) {
  field.oninput = filter;
  tests.push(row => field.value === "" ? true : test(row, field.value));
  bar.append(field, " ");
}
function choice(first, others, test) {
  const field = document.createElement("select");
  field.append(new Option(first, ""), ...others.map(word => new Option(word)));
  add(field, test);
}
function input(type, hint, test) {
  const field = document.createElement("input");
  field.type = type;
  field.step = "any";
  field.placeholder = hint;
  field.setAttribute("aria-label", hint);
  add(field, test);
}
choice("any visibility", ["visible", "borderline", "not visible"],
  (row, word) => text(row, "to the eye").startsWith(word));
choice("any verdict", ["approved", "rejected", "stale", "none"],
  (row, word) => word === "none" ? text(row, "verdict").length === 1
    : text(row, "verdict").includes(word));
choice("with warnings or without", ["with warnings", "without warnings"],
  (row, word) => number(row, "warnings") > 0 === (word === "with warnings"));
input("number", "max over, cm", (row, least) => number(row, "max") > Number(least));
input("number", "ratio below", (row, most) => Number(most) > number(row, "ratio"));
input("search", "name, preset, reason ...",
  (row, words) => row.textContent.toLowerCase().includes(words.toLowerCase()));
const shown = document.createElement("span");
bar.append(shown);
table.parentNode.before(bar);
function filter() {
  let count = 0;
  for (const row of body.rows) {
    row.hidden = !tests.every(test => test(row));
    count += row.hidden ? 0 : 1;
  }
  shown.textContent = count + " of " + body.rows.length + " clips";
}
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
  const rows = Array.from(body.rows);
  if (sorted === at) rows.reverse();
  else rows.sort((a, b) => order(key(a, at), key(b, at)));
  sorted = at;
  body.append(...rows);
}
for (const head of heads) {
  head.style.cursor = "pointer";
  head.onclick = () => sort(head.cellIndex);
}
sort(column("to the eye"));
filter();
)";

}  // namespace mocapress
