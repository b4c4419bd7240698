// SPDX-License-Identifier: MIT
#include "core/batch/report.h"

#include <algorithm>
#include <map>
#include <optional>
#include <ostream>
#include <set>
#include <utility>

#include "core/base/file.h"
#include "core/base/frame_text.h"
#include "core/base/utf8_path.h"
#include "core/batch/report_script.h"
#include "core/codec/methods/compression_method.h"
#include "core/metrics/sight_limits.h"
#include "core/report/clip_link.h"
#include "core/report/markup.h"
#include "core/report/page_script.h"
#include "core/report/report_phrases.h"
#include "core/report/report_style.h"
#include "core/report/review_page.h"
#include "core/report/verdict.h"

namespace mocapress {

namespace fs = std::filesystem;

void write_batch_report(const fs::path& folder, const std::string& suffix, const BatchRows& rows,
                        std::size_t waiting, const ReportLanguage& language) {
  const ReportStamp stamp = report_stamp();
  const auto named = [&](const char* extension) {
    return folder / ("report" + suffix + extension);
  };
  write_stream(named(".csv"), [&](std::ostream& out) {
    out << csv_head();
    rows([&](const BatchRow& row) { out << to_csv_line(row, stamp); });
  });
  write_stream(named(".json"), [&](std::ostream& out) {
    const char* before = "[\n";
    rows([&](const BatchRow& row) {
      out << before << to_report_line(row, stamp);
      before = ",\n";
    });
    out << (*before == '[' ? "[]\n" : "\n]\n");
  });
  write_stream(named(".html"),
               [&](std::ostream& out) { write_batch_html(out, rows, waiting, stamp, language); });
}

using namespace html;

namespace {

constexpr std::size_t kPictures = 6;

constexpr std::size_t kSightCharts = 24;

double times_noticed(const BatchRow& row) {
  return row.measured->seen.times_noticed;
}

/// True if row `a` is worse than `b`: by the visibility of the error first, then by the largest
/// distance.
bool is_worse(const BatchRow& a, const BatchRow& b) {
  return std::pair(times_noticed(a), a.measured->max_cm(a.preset.weighting)) >
         std::pair(times_noticed(b), b.measured->max_cm(b.preset.weighting));
}

/// Inserts a row into `worst`, which holds the `most` worst rows, the worst first.
void add_worst(const BatchRow& row, std::size_t most, std::vector<BatchRow>& worst) {
  if (worst.size() == most && !is_worse(row, worst.back())) return;
  worst.insert(std::ranges::upper_bound(worst, row, is_worse), row);
  if (worst.size() > most) worst.pop_back();
}

/// Totals over the batch.
struct Totals {
  const ReportLanguage& say;
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t warned = 0;
  std::size_t visible = 0;
  std::size_t borderline = 0;
  std::size_t not_visible = 0;
  std::size_t approved = 0;  // with a verdict that is not stale
  std::size_t rejected = 0;
  std::size_t stale = 0;  // with a stale verdict
  std::size_t noted = 0;  // with notes on frames
  std::size_t shown = 0;  // with a file for the page's viewer
  double raw_bytes = 0;
  double motion_bytes = 0;
  double worst_eps_cm = 0;
  double worst_cm = 0;
  std::vector<BatchRow> worst;      // clips whose worst pose is drawn
  std::vector<BatchRow> most_seen;  // clips whose visible errors are charted
  std::set<std::string> limits;     // all limits by which visibility was judged, as text

  void add(const BatchRow& row) {
    warned += !row.warnings.empty();
    const bool is_stale = stale_reason(row).has_value();
    stale += is_stale;
    approved += !is_stale && row.review.verdict == Verdict::Approved;
    rejected += !is_stale && row.review.verdict == Verdict::Rejected;
    noted += !row.review.notes.empty();
    if (!row.done() || !row.measured) {
      failed += !row.done();
      return;
    }
    ++done;
    shown += std::ranges::find(row.formats, OutputFormat::Review) != row.formats.end();
    count_sight(row);
    raw_bytes += static_cast<double>(row.measured->raw_bytes);
    motion_bytes += static_cast<double>(row.measured->motion_bytes);
    const Spread spread = row.measured->spread(row.preset.weighting);
    worst_eps_cm = std::max(worst_eps_cm, spread.rms);
    worst_cm = std::max(worst_cm, spread.max.cm);
    if (row.worst) add_worst(row, kPictures, worst);
  }

 private:
  void count_sight(const BatchRow& row) {
    const Sight sight = row.measured->seen.sight();
    limits.insert(say(limits_text(row.measured->seen.limits)));
    visible += sight == Sight::Visible;
    borderline += sight == Sight::Borderline;
    not_visible += sight == Sight::NotVisible;
    if (sight != Sight::NotVisible) add_worst(row, kSightCharts, most_seen);
  }
};

/// Says by which limits the visibility of errors was judged.
std::string visibility_note(const ReportLanguage& say, const std::set<std::string>& limits) {
  std::string all;
  for (const std::string& one : limits) all += (all.empty() ? "" : "; ") + one;
  return say(
      "Errors from 1 to 2 times the noticeable size are borderline, larger ones visible. Each clip "
      "is judged from the viewing distance that its verdict names, by %1. report.csv lists "
      "distance and own limits of each clip.",
      {escaped(all)});
}

std::string tiles(const ReportLanguage& say, const Totals& totals, std::size_t waiting) {
  // A count of 0 is good news, and gets no alarming colour.
  const auto toned = [](std::size_t count, const std::string& meaning, const char* tone) {
    return tile(std::to_string(count), meaning, count > 0 ? tone : "");
  };
  std::string all;
  if (totals.visible + totals.borderline + totals.not_visible > 0)
    all = toned(totals.visible, say("clips with visible errors"), "wrong") +
          toned(totals.borderline, say("clips with borderline errors"), "doubtful") +
          tile(std::to_string(totals.not_visible), say("without visible errors"));
  all += tile(std::to_string(totals.done), say("clips done, each read back and measured"));
  if (totals.failed > 0) all += toned(totals.failed, say("failed"), "wrong");
  if (const std::size_t reviewed = totals.approved + totals.rejected; reviewed > 0)
    all += tile(
        say("%1 of %2", {std::to_string(reviewed), std::to_string(totals.done + totals.failed)}),
        say("reviewed: %1 approved, %2 rejected",
            {std::to_string(totals.approved), std::to_string(totals.rejected)}),
        totals.rejected > 0 ? "wrong" : "");
  if (totals.stale > 0) all += toned(totals.stale, say("stale verdicts"), "doubtful");
  if (waiting > 0) all += tile(std::to_string(waiting), say("still waiting"));
  if (totals.motion_bytes > 0)
    all += tile(ratio_text(totals.raw_bytes / totals.motion_bytes),
                say("compression ratio of all clips together: %1 KB to %2 KB",
                    {format_significant(totals.raw_bytes / 1024),
                     format_significant(totals.motion_bytes / 1024)}));
  if (totals.done > 0)
    all += tile(format_significant(totals.worst_cm) + " cm",
                say("largest error of any point at any frame; largest %1 %2 cm",
                    {kEpsX, format_significant(totals.worst_eps_cm)}));
  return element("div", attribute("class", "tiles"), all);
}

/// A frame of a clip as text: a link to open it in the studio, if the clip's path is absolute.
std::string moment(const BatchRow& row, int frame, const std::string& joint,
                   const std::string& text) {
  if (!utf8_path(row.input).is_absolute()) return escaped(text);
  const ClipLink link{.clip = row.input, .take = row.reading.take, .frame = frame, .joint = joint};
  return element("a", attribute("href", link_text(link)), escaped(text));
}

std::string pictures(const ReportLanguage& say, const Totals& totals) {
  std::string figures;
  for (const BatchRow& row : totals.worst) {
    const WorstPose& pose = *row.worst;
    const std::string scene =
        worst_scene(pose, say("%1 over its original at its worst frame", {row.output}));
    figures +=
        element("figure", "",
                scene + element("figcaption", "",
                                element("b", "", escaped(row.output)) + ", " +
                                    say("%1, %2 s: error of %3 cm at the %4.",
                                        {moment(row, pose.frame, pose.landmark,
                                                say("frame %1", {frame_text(pose.frame)})),
                                         fixed(pose.frame / row.measured->sample_rate_hz, 2),
                                         format_significant(pose.off_cm), escaped(pose.landmark)}) +
                                    " " + escaped(row.preset.name) + ", " +
                                    ratio_text(row.measured->ratio) + "."));
  }
  if (figures.empty()) return "";
  return element("section", "",
                 element("h2", "", say("Worst frames")) +
                     muted(say("The frame with the largest error of each of the clips whose errors "
                               "are most visible: original in grey, compressed in red.")) +
                     element("div", attribute("class", "multiples"), figures));
}

std::string figure_cell(const std::optional<double>& value) {
  return cell(value ? format_significant(*value) : std::string(kNothing));
}

std::string degrees_cell(const std::optional<double>& value) {
  return cell(value ? format_significant(*value) + "&#176;" : std::string(kNothing));
}

std::string turn_cell(const std::optional<PartTurn>& turn) {
  return degrees_cell(turn ? std::optional(turn->rms_degrees) : std::nullopt);
}

std::string text_cell(std::string_view text, std::string_view css) {
  return text.empty() ? cell(kNothing, "name") : cell(escaped(text), css);
}

/// A table cell with the visibility of errors, and its reason.
std::string seen_cell(const ReportLanguage& say, const Seen& seen) {
  std::string text = sight_phrase(say, seen.sight(), seen.limits.distance_m);
  if (!seen.reason.empty()) text += ": " + escaped(say(seen.reason));
  return element("td",
                 attribute("class", "wrap") + attribute("data-key", fixed(seen.times_noticed, 3)) +
                     attribute("data-sight", sight_phrase({}, seen.sight())),
                 text);
}

/// Table cells with verdict and note. The page's script filters by the words in data-verdict.
std::string review_cells(const ReportLanguage& say, const BatchRow& row) {
  const std::optional<std::string> stale = stale_reason(row);
  const std::string verdict = verdict_text(row.review, stale, say);
  const std::string words = std::string(name(row.review.verdict)) + (stale ? " stale" : "");
  return element("td",
                 attribute("class", verdict.empty() ? "name" : "wrap") +
                     attribute("data-verdict", words.empty() ? "none" : words),
                 verdict.empty() ? kNothing : escaped(verdict)) +
         text_cell(row.review.note, "wrap");
}

void write_failures(std::ostream& out, const ReportLanguage& say, const BatchRows& rows) {
  out << "<section>" << element("h2", "", say("Failed"))
      << muted(say("No file was written for these clips; older files of theirs are unchanged."))
      << "<div class=\"scroll\"><table><thead>"
      << line(text_head(say("Clip")) + text_head(say("preset")) + text_head(say("reason")) +
              text_head(say("verdict")) + text_head(say("note")))
      << "</thead><tbody>";
  rows([&](const BatchRow& row) {
    if (!row.done())
      out << line(row_head(row.output) + cell(escaped(row.preset.name), "name") +
                  cell(escaped(say(row.error)), "wrap") + review_cells(say, row))
          << '\n';
  });
  out << "</tbody></table></div></section>\n";
}

std::string clip_line(const ReportLanguage& say, const BatchRow& row) {
  const Measurement& m = *row.measured;
  const Spread spread = m.spread(row.preset.weighting);
  std::string method = say(std::string(method_title(row.preset.method)));
  if (row.preset.correction) method += ", " + say("feet held");
  if (m.ik_ratio_used) method += ", r_IK " + format_significant(*m.ik_ratio_used);
  return line(
      row_head(row.output) + seen_cell(say, m.seen) + review_cells(say, row) +
      cell(row.warnings.empty() ? kNothing : std::to_string(row.warnings.size())) +
      cell(ratio_text(m.ratio)) + cell(format_significant(spread.max.cm)) +
      cell(frame_text(m.worst_frame)) + cell(format_significant(spread.rms)) +
      cell(format_significant(spread.p95)) + cell(format_significant(spread.p99)) +
      degrees_cell(m.body.angle_rms_degrees) + turn_cell(m.body.head) + turn_cell(m.body.hand) +
      figure_cell(m.slide ? std::optional(m.slide->drift_mean_cm) : std::nullopt) +
      figure_cell(m.slide ? std::optional(m.slide->drift_worst_cm) : std::nullopt) +
      figure_cell(m.footskate_cm) +
      cell(format_significant(static_cast<double>(m.motion_bytes) / 1024)) +
      cell(std::to_string(m.frames)) + cell(escaped(row.preset.name), "name") +
      cell(escaped(say(target_text(row.preset.target))), "name") + cell(escaped(method), "name"));
}

void write_clips(std::ostream& out, const ReportLanguage& say, const BatchRows& rows) {
  out << "<section>" << element("script", "", kHidingScript) << element("h2", "", say("Every clip"))
      << muted(say(
             "Errors of the file as read back from the disk, against the original: distances in "
             "centimetres, rotation errors of joints, head and hands in degrees."))
      << "<div class=\"scroll\"><table id=\"clips\"><thead>"
      << line(text_head(say("Clip")) + text_head(say("visibility")) + text_head(say("verdict")) +
              text_head(say("note")) + head(say("warnings")) + head(say("ratio")) +
              head(say("max")) + head(say("at frame")) + head(kEpsX) + head("p95") + head("p99") +
              head(say("joints")) + head(say("head")) + head(say("hands")) +
              head(say("foot drift")) + head(say("worst drift")) + head(say("foot path")) +
              head("KB") + head(say("frames")) + text_head(say("preset")) +
              text_head(say("asked")) + text_head(say("method")))
      << "</thead><tbody>\n";
  rows([&](const BatchRow& row) {
    if (row.done() && row.measured) out << clip_line(say, row) << '\n';
  });
  out << "</tbody></table></div></section>\n";
}

/// Writes the reviewers' notes on frames, clip by clip.
void write_notes(std::ostream& out, const ReportLanguage& say, const BatchRows& rows) {
  out << "<section>" << element("h2", "", say("Notes"))
      << "<div class=\"scroll\"><table id=\"notes\"><thead>"
      << line(text_head(say("Clip")) + head(say("frame")) + text_head(say("joint")) +
              text_head(say("note")) + text_head(say("by")) + text_head(say("when")) +
              text_head(say("stale")))
      << "</thead><tbody>\n";
  rows([&](const BatchRow& row) {
    for (const FrameNote& note : row.review.notes)
      out << line(row_head(row.output) +
                      cell(moment(row, note.frame, note.joint, frames_text(note))) +
                      text_cell(note.joint, "name") + text_cell(note.text, "wrap") +
                      text_cell(note.reviewer, "name") + text_cell(note.time, "name") +
                      text_cell(say(stale_reason(row, note).value_or("")), "wrap"),
                  attribute("data-frame", std::to_string(note.frame)) +
                      attribute("data-note", note_text(note, stale_reason(row, note), say)))
          << '\n';
  });
  out << "</tbody></table></div></section>\n";
}

/// Writes charts of the clips with the most visible errors.
void write_sights(std::ostream& out, const ReportLanguage& say, const Totals& totals) {
  const std::size_t seen = totals.visible + totals.borderline;
  std::string legend = say(kSightLegend);
  if (seen > totals.most_seen.size())
    legend += ' ' + say("The charts show the %1 clips with the most visible errors, out of %2.",
                        {std::to_string(totals.most_seen.size()), std::to_string(seen)});
  out << "<section>" << element("h2", "", say("Visible errors over time")) << muted(legend)
      << "<div class=\"multiples\">\n";
  for (const BatchRow& row : totals.most_seen) {
    if (row.sights.empty()) continue;
    const Measurement& m = *row.measured;
    out << element("figure", "",
                   draw(row.sights, m.frames / m.sample_rate_hz,
                        say("%1: visible errors over time", {row.output}), say) +
                       element("figcaption", "",
                               element("b", "", escaped(row.output)) + ": " +
                                   escaped(say(m.seen.reason))))
        << '\n';
  }
  out << "</div></section>\n";
}

/// A warning without its file and line, so that equal warnings about several clips are equal texts.
std::string without_place(const std::string& warning) {
  const std::size_t end = warning.find(": ");
  return end == warning.npos ? warning : warning.substr(end + 2);
}

/// Writes each warning once, with the clips that have it.
void write_warnings(std::ostream& out, const ReportLanguage& say, const BatchRows& rows) {
  constexpr std::size_t kNamed = 8;
  struct Clips {
    std::size_t count = 0;
    std::string named;
  };
  std::map<std::string, Clips> warnings;
  rows([&](const BatchRow& row) {
    for (const std::string& warning : row.warnings) {
      Clips& clips = warnings[without_place(warning)];
      if (++clips.count <= kNamed) clips.named += (clips.count > 1 ? ", " : "") + row.output;
    }
  });
  out << "<section>" << element("h2", "", say("Repaired or guessed on reading"))
      << muted(say("report.csv lists each warning with its file and line."))
      << "<div class=\"scroll\"><table><thead>"
      << line(text_head(say("warning")) + head(say("count")) + text_head(say("clips")))
      << "</thead><tbody>\n";
  for (const auto& [warning, clips] : warnings)
    out << line(cell(escaped(say(warning)), "wrap") + cell(std::to_string(clips.count)) +
                cell(escaped(clips.named + (clips.count > kNamed ? ", ..." : "")), "wrap"))
        << '\n';
  out << "</tbody></table></div></section>\n";
}

std::string notes(const ReportLanguage& say, const Totals& totals) {
  std::string all;
  const auto add = [&](std::string_view term, std::string_view text) {
    all += element("dt", "", term) + element("dd", "", text);
  };
  add(say("Verified"),
      say("Each file was read back and decoded as an engine would, by the runtime decoder within "
          "its default limits; errors are those of the decoded motion. Engines cannot play files "
          "in the paper's codings and of comparison methods: the library decodes these. The column "
          "verified_by of report.csv names the decoder of each clip."));
  add(say("Ratio"),
      say("Bytes of the channels as 32-bit floats, divided by the bytes of the coded motion. The "
          "skeleton counts on neither side. 1 KB = 1024 bytes."));
  add(kEpsX, say("Weighted root mean square distance between points of the body and the same "
                 "points of the original. report.csv has it in two more weightings."));
  add(say("p95, p99, max"),
      say("Percentiles and maximum of these distances over all points and frames, unweighted."));
  if (!totals.limits.empty()) add(say("Visibility"), visibility_note(say, totals.limits));
  add(say("Joints, head, hands"),
      say("Angle between a joint's world-space rotation and the original's, root mean square over "
          "frames and joints. Head and hands are recognised by their names."));
  add(say("Foot drift, foot path"),
      say("Both are measured while a foot stands in the original. Drift is the distance between a "
          "foot and its place in the original, as the mean over contacts and in the worst contact. "
          "Path is the length of the foot's path beyond the original's, summed over all contacts; "
          "a foot that trembles in place has a long path."));
  add(say("Verdict, note"),
      say("The reviewer's verdict and note, with name and date. A verdict is stale, and does not "
          "count, if the clip's file or its settings have changed since."));
  add(say("Warnings"),
      say("Number of places that were repaired or guessed when the clip was read; they are listed "
          "above."));
  return element("section", "",
                 element("h2", "", say("How clips were measured")) + element("dl", "", all));
}

}  // namespace

void write_batch_html(std::ostream& out, const BatchRows& rows, std::size_t waiting,
                      const ReportStamp& stamp, const ReportLanguage& say,
                      std::span<const std::byte> viewer) {
  Totals totals{say};
  rows([&](const BatchRow& row) { totals.add(row); });
  out << page_begin(say.code, say("Batch export"), kReportStyle)
      << element("header", "",
                 element("h1", "", say("Batch export")) +
                     muted(escaped(stamp.program + ", " + stamp.time)))
      << tiles(say, totals, waiting) << '\n';
  if (totals.failed > 0) write_failures(out, say, rows);
  const bool has_viewer = totals.shown > 0 && !viewer.empty();
  if (totals.done > 0)
    out << element("script", "", say_script(say, {kReportTexts, review_texts()})) << '\n';
  if (has_viewer) out << review_section(viewer) << '\n';
  out << pictures(say, totals) << '\n';
  if (totals.done > 0) write_clips(out, say, rows);
  if (totals.noted > 0) write_notes(out, say, rows);
  if (!totals.most_seen.empty()) write_sights(out, say, totals);
  if (totals.warned > 0) write_warnings(out, say, rows);
  out << notes(say, totals) << "</main>";
  if (totals.done > 0)
    out << element("script", "", kReportScript + (has_viewer ? review_buttons() : ""));
  out << "</body></html>\n";
}

}  // namespace mocapress
