// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/settings_json.h"

#include <QJsonArray>
#include <array>
#include <string_view>

#include "core/base/error.h"

namespace mocapress {
namespace {

constexpr std::array kMethods = {Method::Annealed, Method::Standard, Method::PerChannel,
                                 Method::ClosedLoop};
constexpr std::array kCodings = {Coding::Rle16, Coding::Deflate, Coding::Adaptive};
constexpr std::array kEfforts = {Effort::Default, Effort::Best};
constexpr std::array kEnds = {Ends::Free, Ends::Even, Ends::Exact};
constexpr std::array kLoops = {Loop::None, Loop::Repeats, Loop::Follows};
constexpr std::array kBases = {Basis::Haar, Basis::Linear, Basis::Cubic};
constexpr std::array kPlaces = {CorrectAt::EveryFrame, CorrectAt::Contacts};
constexpr std::array kSolvers = {IkSolver::CyclicDescent, IkSolver::NearestPose};
constexpr std::array<std::pair<Target::Kind, const char*>, 6> kTargets = {
    {{Target::Kind::Ratio, "ratio"},
     {Target::Kind::CoefficientRatio, "coefficient-ratio"},
     {Target::Kind::Size, "bytes"},
     {Target::Kind::Error, "error-cm"},
     {Target::Kind::MaxError, "greatest-error-cm"},
     {Target::Kind::Visibility, "times-noticed"}}};

template <typename Value>
QString text(Value value) {
  const std::string_view word = name(value);
  return QString::fromLatin1(word.data(), static_cast<qsizetype>(word.size()));
}

template <typename Values, typename Value>
void read(const QJsonObject& json, const char* key, const Values& values, Value& value) {
  if (!json.contains(QLatin1String(key))) return;
  const QString word = json.value(QLatin1String(key)).toString();
  for (const Value one : values)
    if (text(one) == word) {
      value = one;
      return;
    }
  throw Error(std::string(key) + ": \"" + word.toStdString() + "\" is not known");
}

void read(const QJsonObject& json, const char* key, double& value) {
  value = json.value(QLatin1String(key)).toDouble(value);
}

QJsonObject toJson(const Target& target) {
  QJsonObject json;
  for (const auto& [kind, key] : kTargets)
    if (kind == target.kind) json.insert(QLatin1String(key), target.value);
  return json;
}

QJsonObject toJson(const Importance& importance) {
  QJsonArray joints;
  for (const double factor : importance.joints) joints << factor;
  return {{QStringLiteral("contacts"), importance.contacts}, {QStringLiteral("joints"), joints}};
}

QJsonObject toJson(const CorrectionOptions& correction) {
  QJsonArray joints;
  for (const int joint : correction.joints) joints << joint;
  QJsonObject json{{QStringLiteral("joints"), joints},
                   {QStringLiteral("solver"), text(correction.solver)},
                   {QStringLiteral("at"), text(correction.at)}};
  if (correction.ratio) json.insert(QStringLiteral("ratio"), *correction.ratio);
  return json;
}

QJsonArray toJson(const std::vector<ContactSpan>& contacts) {
  QJsonArray json;
  for (const ContactSpan& span : contacts)
    json << QJsonArray{span.landmark, span.first_frame, span.last_frame};
  return json;
}

QJsonObject toJson(const ContactSettings& settings) {
  return {{QStringLiteral("begin-height-cm"), settings.begin_height},
          {QStringLiteral("end-height-cm"), settings.end_height},
          {QStringLiteral("begin-speed-cm-s"), settings.begin_speed},
          {QStringLiteral("end-speed-cm-s"), settings.end_speed},
          {QStringLiteral("least-seconds"), settings.least_seconds}};
}

Importance importanceFrom(const QJsonObject& json) {
  Importance importance;
  read(json, "contacts", importance.contacts);
  for (const auto& factor : json.value(QStringLiteral("joints")).toArray())
    importance.joints.push_back(factor.toDouble(1));
  return importance;
}

CorrectionOptions correctionFrom(const QJsonObject& json) {
  CorrectionOptions correction;
  for (const auto& joint : json.value(QStringLiteral("joints")).toArray())
    correction.joints.push_back(joint.toInt());
  if (const double ratio = json.value(QStringLiteral("ratio")).toDouble(); ratio > 0)
    correction.ratio = ratio;
  read(json, "solver", kSolvers, correction.solver);
  read(json, "at", kPlaces, correction.at);
  return correction;
}

std::vector<ContactSpan> contactsFrom(const QJsonArray& json) {
  std::vector<ContactSpan> contacts;
  for (const auto& entry : json) {
    const QJsonArray span = entry.toArray();
    contacts.push_back({span.at(0).toInt(), span.at(1).toInt(), span.at(2).toInt()});
  }
  return contacts;
}

}  // namespace

QJsonObject toJson(const ClipSettings& settings) {
  const EncodeOptions& encode = settings.encode;
  QJsonObject json{{QStringLiteral("method"), text(encode.method)},
                   {QStringLiteral("coding"), text(encode.coding)},
                   {QStringLiteral("basis"), text(encode.basis)},
                   {QStringLiteral("weighting"), text(encode.weighting)},
                   {QStringLiteral("target"), toJson(encode.target)},
                   {QStringLiteral("seed"), QString::number(encode.seed)},
                   {QStringLiteral("effort"), text(encode.effort)},
                   {QStringLiteral("ends"), text(encode.ends)},
                   {QStringLiteral("contact-settings"), toJson(settings.contacts)}};
  if (!settings.preset.isEmpty()) json.insert(QStringLiteral("preset"), settings.preset);
  if (!encode.importance.is_even())
    json.insert(QStringLiteral("importance"), toJson(encode.importance));
  if (encode.loop) json.insert(QStringLiteral("loop"), text(*encode.loop));
  if (encode.correction) json.insert(QStringLiteral("ik"), toJson(*encode.correction));
  if (encode.contacts) json.insert(QStringLiteral("contacts"), toJson(*encode.contacts));
  return json;
}

ClipSettings settingsFrom(const QJsonObject& json) {
  ClipSettings settings;
  EncodeOptions& encode = settings.encode;
  read(json, "method", kMethods, encode.method);
  read(json, "coding", kCodings, encode.coding);
  read(json, "basis", kBases, encode.basis);
  read(json, "weighting", kWeightings, encode.weighting);
  read(json, "effort", kEfforts, encode.effort);
  read(json, "ends", kEnds, encode.ends);
  if (json.contains(QStringLiteral("loop"))) read(json, "loop", kLoops, encode.loop.emplace());
  encode.importance = importanceFrom(json.value(QStringLiteral("importance")).toObject());
  settings.preset = json.value(QStringLiteral("preset")).toString();
  const QJsonObject target = json.value(QStringLiteral("target")).toObject();
  for (const auto& [kind, key] : kTargets)
    if (const double value = target.value(QLatin1String(key)).toDouble(); value > 0)
      encode.target = {kind, value};
  if (json.contains(QStringLiteral("seed")))
    encode.seed = json.value(QStringLiteral("seed")).toString().toULongLong();
  if (json.contains(QStringLiteral("ik")))
    encode.correction = correctionFrom(json.value(QStringLiteral("ik")).toObject());
  if (json.contains(QStringLiteral("contacts")))
    encode.contacts = contactsFrom(json.value(QStringLiteral("contacts")).toArray());
  const QJsonObject contacts = json.value(QStringLiteral("contact-settings")).toObject();
  read(contacts, "begin-height-cm", settings.contacts.begin_height);
  read(contacts, "end-height-cm", settings.contacts.end_height);
  read(contacts, "begin-speed-cm-s", settings.contacts.begin_speed);
  read(contacts, "end-speed-cm-s", settings.contacts.end_speed);
  read(contacts, "least-seconds", settings.contacts.least_seconds);
  return settings;
}

}  // namespace mocapress
