// SPDX-License-Identifier: MIT
#include "core/report/verdict.h"

#include <algorithm>
#include <array>

#include "core/base/frame_text.h"
#include "core/report/json_value.h"

namespace mocapress {
namespace {

std::string text_at(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found == json.end() || found->is_null() ? "" : found->get<std::string>();
}

int frame_in(const Json& json) {
  return static_cast<int>(std::clamp(json.get<double>(), -1.0, 1e9));
}

std::optional<std::string> change(bool is_other_file, bool has_other_settings) {
  if (is_other_file && has_other_settings) return "the clip's file and the settings changed";
  if (is_other_file) return "the clip's file changed";
  if (has_other_settings) return "the settings changed";
  return std::nullopt;
}

}  // namespace

Json to_json(const std::vector<FrameNote>& notes) {
  Json json = Json::array();
  for (const FrameNote& note : notes)
    json.push_back({{"frame", note.frame},
                    {"last_frame", or_null(note.last_frame)},
                    {"joint", text_or_null(note.joint)},
                    {"text", note.text},
                    {"reviewer", text_or_null(note.reviewer)},
                    {"time", text_or_null(note.time)},
                    {"place_cm", or_null(note.place_cm)},
                    {"source_hash", text_or_null(note.source_hash)},
                    {"settings_hash", text_or_null(note.settings_hash)}});
  return json;
}

std::vector<FrameNote> frame_notes_from(const Json& json) {
  std::vector<FrameNote> notes;
  for (const Json& one : json) {
    notes.push_back({.frame = frame_in(one.at("frame")),
                     .joint = text_at(one, "joint"),
                     .text = text_at(one, "text"),
                     .reviewer = text_at(one, "reviewer"),
                     .time = text_at(one, "time"),
                     .source_hash = text_at(one, "source_hash"),
                     .settings_hash = text_at(one, "settings_hash")});
    const Json last = one.value("last_frame", Json());
    if (!last.is_null() && frame_in(last) > notes.back().frame)
      notes.back().last_frame = frame_in(last);
    if (one.contains("place_cm"))
      notes.back().place_cm = optional_at<std::array<double, 3>>(one, "place_cm");
  }
  return notes;
}

std::string frames_text(const FrameNote& note) {
  return frame_text(note.frame) + (note.last_frame ? "\u2013" + frame_text(*note.last_frame) : "");
}

std::string note_text(const FrameNote& note, const std::optional<std::string>& stale_reason,
                      const ReportLanguage& say) {
  std::string text = say(note.last_frame ? "frames %1" : "frame %1", {frames_text(note)});
  if (!note.joint.empty()) text += ", " + note.joint;
  text += ": " + note.text;
  std::string said = note.reviewer;
  if (!said.empty() && !note.time.empty()) said += ", " + note.time.substr(0, 10);
  if (stale_reason) said += (said.empty() ? "" : "; ") + say("stale: %1", {say(*stale_reason)});
  return said.empty() ? text : text + " (" + said + ")";
}

void put(Json& json, const ClipReview& review) {
  json["verdict"] = text_or_null(name(review.verdict));
  json["note"] = text_or_null(review.note);
  json["reviewer"] = text_or_null(review.reviewer);
  json["reviewed"] = text_or_null(review.time);
  json["source_hash"] = text_or_null(review.source_hash);
  json["settings_hash"] = text_or_null(review.settings_hash);
  json["notes"] = review.notes.empty() ? Json() : to_json(review.notes);
}

ClipReview review_from(const Json& json) {
  return {.verdict = verdict_named(text_at(json, "verdict")),
          .note = text_at(json, "note"),
          .reviewer = text_at(json, "reviewer"),
          .time = text_at(json, "reviewed"),
          .source_hash = text_at(json, "source_hash"),
          .settings_hash = text_at(json, "settings_hash"),
          .notes = frame_notes_from(json.value("notes", Json()))};
}

std::optional<std::string> stale_reason(const ClipReview& review, std::string_view source_hash,
                                        std::string_view settings_hash) {
  if (review.verdict == Verdict::None) return std::nullopt;
  if (review.source_hash.empty() || review.settings_hash.empty())
    return "it does not say which file and settings were reviewed";
  return change(review.source_hash != source_hash, review.settings_hash != settings_hash);
}

std::optional<std::string> stale_reason(const FrameNote& note, std::string_view source_hash,
                                        std::string_view settings_hash) {
  return change(!note.source_hash.empty() && note.source_hash != source_hash,
                !note.settings_hash.empty() && note.settings_hash != settings_hash);
}

std::string verdict_text(const ClipReview& review, const std::optional<std::string>& stale_reason,
                         const ReportLanguage& say) {
  if (review.verdict == Verdict::None) return "";
  std::string text = say(std::string(name(review.verdict)));
  if (!review.reviewer.empty()) text = say("%1 by %2", {text, review.reviewer});
  if (!review.time.empty()) text += ", " + review.time.substr(0, 10);
  if (stale_reason) text += "; " + say("stale: %1", {say(*stale_reason)});
  return text;
}

}  // namespace mocapress
