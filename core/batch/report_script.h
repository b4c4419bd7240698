// SPDX-License-Identifier: MIT
#pragma once

namespace mocapress {

/// Sorts the table of clips by a click on a heading, largest first, and filters it by what the eye
/// sees and by words. The page reads well without it. Neither < nor & may stand here: the page is
/// XML, too.
inline constexpr const char* kReportScript = R"(
const table = document.getElementById("clips");
const body = table.tBodies[0];
const sight = document.createElement("select");
for (const word of ["any visibility", "visible", "borderline", "not visible"])
  sight.append(new Option(word));
const words = document.createElement("input");
words.type = "search";
words.placeholder = "name, preset, verdict, stale ...";
const shown = document.createElement("span");
table.parentNode.before(sight, " ", words, " ", shown);
function filter() {
  const text = words.value.toLowerCase();
  let count = 0;
  for (const row of body.rows) {
    const seen = sight.selectedIndex === 0 ? true
      : row.querySelector("[data-key]")?.textContent.startsWith(sight.value);
    row.hidden = seen ? !row.textContent.toLowerCase().includes(text) : true;
    count += row.hidden ? 0 : 1;
  }
  shown.textContent = count + " of " + body.rows.length + " clips";
}
sight.oninput = words.oninput = filter;
function key(row, column) {
  const cell = row.cells[column];
  const text = cell.dataset.key || cell.textContent;
  const number = column === 0 ? NaN : parseFloat(text);
  return isNaN(number) ? text : number;
}
function order(a, b) {
  if (typeof a === "number") return typeof b === "number" ? b - a : -1;
  return typeof b === "number" ? 1 : a.localeCompare(b);
}
let sorted = -1;
for (const head of table.tHead.rows[0].cells) {
  head.style.cursor = "pointer";
  head.onclick = function () {
    const column = head.cellIndex;
    const rows = Array.from(body.rows);
    if (sorted === column) rows.reverse();
    else rows.sort(function (a, b) { return order(key(a, column), key(b, column)); });
    sorted = column;
    body.append(...rows);
  };
}
filter();
)";

}  // namespace mocapress
