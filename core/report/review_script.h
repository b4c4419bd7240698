// SPDX-License-Identifier: MIT
#pragma once

namespace mocapress {

/// The texts that the script below and the viewer pass to say().
inline constexpr const char* kReviewTexts[] = {
    "View", "%1 cannot be shown: %2", "%1 cannot be loaded", "Previous clip", "Next clip",
    // core/report/viewer/viewer.js
    "Loading", "Frame", "Key: %1", "Play", "Pause", "Overlay", "Side by side", "Wipe", "Swap",
    "Original", "Compressed", "Colour by error", "Follow", "Worst frame before", "Next worst frame",
    "Reset camera", "Frame %1 of %2, %3 s.", "On the bones, %1 is %2 cm off.",
    "The lightest colour is %1 cm."};

/// Unpacks the viewer when the first clip is opened. Takes clips from the page, or from scripts
/// beside it. Must contain neither < nor &, since pages are XML.
inline constexpr const char* kReviewScript = R"(
const mocapressClips = new Map();
function mocapressReview(name, original, compressed) {
  mocapressClips.set(name, { name, original, compressed });
}
function runScript(fill) {
  return new Promise(function (resolve, reject) {
    const script = document.createElement("script");
    script.onload = resolve;
    script.onerror = function () { reject(new Error(say("%1 cannot be loaded", script.src))); };
    fill(script);
    document.head.append(script);
  });
}
let viewerScript;
function loadViewer() {
  const text = document.getElementById("viewer").textContent;
  const packed = Uint8Array.from(atob(text.trim()), function (letter) { return letter.charCodeAt(0); });
  const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(unpacked).text().then(function (code) {
    const url = URL.createObjectURL(new Blob([code], { type: "text/javascript" }));
    return runScript(function (script) { script.src = url; });
  });
}
function addReviewButton(name, facts) {
  const button = document.createElement("button");
  button.textContent = say("View");
  button.onclick = function () { showClip(name, facts); };
  document.currentScript.before(button);
}
let asked = 0;
async function showClip(name, facts, notes) {
  const call = ++asked;
  const section = document.getElementById("review");
  section.hidden = false;
  section.scrollIntoView();
  try {
    if (!mocapressClips.has(name)) {
      const path = name.split("/").map(encodeURIComponent).join("/") + ".review.js";
      await runScript(function (script) { script.src = path; });
    }
    viewerScript = viewerScript || loadViewer();
    await viewerScript;
    if (call !== asked) return; // another clip was asked for meanwhile
    await mocapressViewer.show(section, Object.assign({ facts, notes, say }, mocapressClips.get(name)));
  } catch (error) {
    if (call === asked) section.textContent = say("%1 cannot be shown: %2", name, error.message);
  }
}
)";

/// Adds a button to each row of the table of clips. Must run after kReportScript, which defines the
/// rows and finds their columns. Facts from the row are shown with the clip. Buttons beside the
/// clip that is shown, and the keys Q and Shift+Q, go to the next and previous clip of the table as
/// it is sorted and filtered.
inline constexpr const char* kReviewButtons = R"(
const told = ["preset", "ratio", "max", "visibility", "verdict", "note"];
for (const row of rows) {
  const name = row.cells[0].textContent;
  const button = document.createElement("button");
  button.textContent = say("View");
  button.onclick = function () {
    const facts = told.map(function (head) {
      const cell = row.cells[column(head)];
      const unit = head === "max" ? " cm" : "";
      return cell.textContent.length > 1 ? say(head) + " " + cell.textContent + unit : "";
    });
    const notes = Array.from(document.querySelectorAll("#notes tbody tr"))
      .filter(line => line.cells[0].textContent === name)
      .map(line => ({ frame: Number(line.dataset.frame), text: line.dataset.note }));
    showClip(name, facts.filter(Boolean), notes);
  };
  row.cells[0].append(" ", button);
}
const section = document.getElementById("review");
const neighbours = document.createElement("nav");
neighbours.className = "neighbours";
let viewed;
function neighbour(step) {
  const found = rows.filter(row => tests.every(test => test(row)));
  return found[found.indexOf(viewed) + step];
}
function go(step) {
  const row = neighbour(step);
  if (row) row.cells[0].querySelector("button").click();
}
for (const [sign, step, name, key] of [["\u2039", -1, say("Previous clip"), "Shift+Q"],
                                       ["\u203a", 1, say("Next clip"), "Q"]]) {
  const button = document.createElement("button");
  button.textContent = sign;
  button.setAttribute("aria-keyshortcuts", key);
  button.onclick = () => go(step);
  button.tell = function () {
    const row = neighbour(step);
    button.disabled = !row;
    const label = row ? name + ": " + row.cells[0].firstChild.textContent : name;
    button.setAttribute("aria-label", label);
    button.title = label + ". " + say("Key: %1", key);
  };
  neighbours.append(button);
}
function tellNeighbours() {
  for (const button of neighbours.children) button.tell();
}
bar.addEventListener("input", tellNeighbours);
table.tHead.addEventListener("click", tellNeighbours);
for (const row of rows)
  row.cells[0].querySelector("button").addEventListener("click", function () {
    if (viewed) viewed.classList.remove("viewed");
    viewed = row;
    viewed.classList.add("viewed");
    tellNeighbours();
    section.before(neighbours);
  });
section.addEventListener("keydown", function (event) {
  if (event.key.toLowerCase() !== "q" || event.ctrlKey || event.metaKey || event.altKey) return;
  go(event.shiftKey ? -1 : 1);
});
)";

/// The viewer's style sheet.
inline constexpr const char* kReviewStyle = R"css(
.review canvas { display: block; width: 100%; height: min(64vh, 720px); border-radius: 10px; outline: none; }
.review canvas.strip { height: 44px; border-radius: 4px; margin-top: 8px; background: var(--page); cursor: pointer; }
.review p { max-width: none; } .review .stage { position: relative; }
.stage .names { position: absolute; inset: 10px 14px auto; display: flex; justify-content: space-between; pointer-events: none; font-size: 13px; }
.stage.swapped .names { flex-direction: row-reverse; }
.stage .names span::before { content: ""; display: inline-block; width: 26px; height: 10px; margin-right: 7px; border-radius: 3px; background: var(--colour); }
.stage .divider { position: absolute; inset: 0 auto 0 50%; width: 17px; margin-left: -8px; cursor: ew-resize; touch-action: none;
  background: linear-gradient(var(--accent), var(--accent)) center / 1px 100% no-repeat; }
.review .notes { display: flex; flex-direction: column; align-items: start; gap: 6px; margin-top: 8px; } .review .notes button { text-align: left; }
.review input { width: 100%; margin: 6px 0; accent-color: var(--accent); }
.review .buttons { display: flex; flex-wrap: wrap; gap: 6px; }
.review button, .neighbours button, td button, th button, figcaption button { font: inherit; font-size: 13px; padding: 2px 10px; color: var(--ink);
  background: var(--card); border: 1px solid var(--rule); border-radius: 6px; cursor: pointer; }
.review button[aria-pressed="true"] { color: var(--card); background: var(--ink); }
.review .status { margin: 8px 0 0; font-variant-numeric: tabular-nums; }
.neighbours { float: right; position: relative; margin: 44px 26px 0 10px; }
.neighbours button { font-size: 18px; line-height: 24px; width: 34px; padding: 0; margin-left: 6px; }
.neighbours button:disabled { opacity: 0.4; cursor: default; }
#clips tr.viewed :is(th, td) { background: color-mix(in srgb, var(--accent) 12%, transparent); }
@media print { .review, .neighbours { display: none; } }
)css";

}  // namespace mocapress
