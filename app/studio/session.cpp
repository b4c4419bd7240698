// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/session.h"

#include <QFileInfo>
#include <algorithm>
#include <numeric>

#include "app/studio/settings_change.h"
#include "app/studio/study_row_request.h"
#include "core/base/file.h"
#include "core/motion/landmarks.h"

namespace mocapress {
namespace {

constexpr std::size_t kFirstCurves = 3;

/// Indices of columns by falling mean.
std::vector<int> worstFirst(const Eigen::MatrixXf& distances) {
  const Eigen::RowVectorXf mean = distances.colwise().mean();
  std::vector<int> order(static_cast<std::size_t>(mean.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return mean[a] > mean[b]; });
  return order;
}

QString absolute(const QString& path) {
  return QFileInfo(path).absoluteFilePath();
}

}  // namespace

Session::Session(QObject* parent) : QObject(parent) {
  connect(&compressor_, &Compressor::answered, this, &Session::answer);
  connect(&compressor_, &Compressor::progressed, this, &Session::annealed);
  connect(&compressor_, &Compressor::refiningChanged, this, &Session::refiningChanged);
  connect(&compressor_, &Compressor::failed, this, [this](const QString& message) {
    document_.setDecoded(document_.decoded(), true);
    emit compressFailed(message);
  });
}

void Session::open(const QString& path, const QString& skeleton) {
  // Only a .mcpr still waiting for its original takes one in.
  const bool waits = document_.decoded() && !document_.original();
  start({absolute(path), skeleton, document_.original(), waits ? document_.decoded() : nullptr,
         false});
}

bool Session::isOpen(const QString& path) const {
  return document_.original() && document_.original()->path == absolute(path);
}

void Session::compareWith(const QString& path, const QString& skeleton) {
  start({absolute(path), skeleton, nullptr, document_.decoded(), true});
}

void Session::openRow(const StudyRow& row, const QString& skeleton) {
  OpenRequest request = requestOf(row);
  request.skeleton = skeleton;
  request.original = document_.original();
  if (!isOpen(request.path) || !request.comparison.empty()) return start(request);
  opening_.abandon();
  document_.loadOptions(*request.options);
  emit recompressing();
  compressor_.request(document_.options());
}

void Session::start(const OpenRequest& request) {
  opening_.start([request](const Job& job) { return openClip(request, job); },
                 [this, request](const OpenedClip& opened) { show(opened, request); },
                 [this, request](const QString& message) { emit openFailed(request, message); });
}

void Session::show(const OpenedClip& opened, const OpenRequest& request) {
  const bool together = opened.original && opened.decoded;
  const QString saved_path = isCompressedFile(request.path) ? request.path
                             : together                     ? document_.savedPath()
                                                            : QString();
  compressor_.setEncoder(opened.original ? opened.original->encoder : nullptr);
  if (request.options) document_.loadOptions(*request.options);
  document_.setClip(opened.original, opened.decoded, saved_path);
  history_.clear();
  chooseCurves();
  emit this->opened(request);
  if (opened.decoded)
    emit settled();
  else
    compressor_.request(document_.options());
}

void Session::setOptions(const EncodeOptions& options) {
  change({options, document_.contactSettings()});
}

void Session::setContactSettings(const ContactSettings& settings) {
  EncodeOptions options = document_.options();
  options.contacts = document_.contactsBy(settings);
  change({options, settings});
}

void Session::setContacts(const std::vector<ContactSpan>& contacts) {
  EncodeOptions options = document_.options();
  options.contacts = contacts;
  change({options, document_.contactSettings()});
}

void Session::change(const ClipSettings& settings) {
  history_.push(new SettingsChange(document_.settings(), settings,
                                   [this](const ClipSettings& those) { apply(those); }));
}

void Session::apply(const ClipSettings& settings) {
  document_.setSettings(settings);
  if (!document_.original()) return;
  emit recompressing();
  compressor_.request(settings.encode);
}

void Session::answer(const DecodedPtr& decoded, bool final) {
  document_.setDecoded(decoded, final);
  chooseCurves();
  if (final) emit settled();
}

/// A graph without a curve explains nothing: the worst joints, unless chosen ones are there.
void Session::chooseCurves() {
  const DecodedPtr& decoded = document_.decoded();
  if (!decoded || !decoded->distortion) return;
  const std::vector<Landmark> points = landmarks(*document_.skeleton());
  CurveSelection curves = document_.curves();
  const auto chosen = [&](const Landmark& point) {
    return curves.contains(QString::fromStdString(point.name));
  };
  if (std::any_of(points.begin(), points.end(), chosen)) return;
  const std::vector<int> worst = worstFirst(decoded->distortion->distances);
  for (std::size_t i = 0; i < std::min(kFirstCurves, worst.size()); ++i)
    curves.add(QString::fromStdString(points[static_cast<std::size_t>(worst[i])].name));
  document_.setCurves(curves);
}

void Session::save(const QString& path) {
  const DecodedPtr decoded = document_.decoded();
  if (!decoded) return;
  saving_.start(
      [decoded, path](const Job&) {
        write_bytes(path.toStdU16String(), decoded->file);
        return path;
      },
      [this, decoded](const QString& saved_path) {
        document_.setSaved(decoded, saved_path);
        emit saved(saved_path);
      },
      [this](const QString& message) { emit saveFailed(message); });
}

}  // namespace mocapress
