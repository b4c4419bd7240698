// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/clip_links.h"

#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QVector3D>
#include <QtMath>
#include <algorithm>
#include <array>
#include <utility>

#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "core/base/error.h"
#include "widgets/timeline/playback.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {

ClipLinks::ClipLinks(Session* session, Library* library, Playback* playback, Viewport* viewport,
                     QObject* parent)
    : QObject(parent),
      session_(session),
      library_(library),
      playback_(playback),
      viewport_(viewport) {
  connect(session, &Session::opened, this, &ClipLinks::arrive);
  connect(session, &Session::openFailed, this, [this] { under_way_.reset(); });
}

bool ClipLinks::isLink(const QString& text) {
  const auto scheme = QLatin1String(kClipLinkScheme.data(), kClipLinkScheme.size());
  return text.startsWith(scheme, Qt::CaseInsensitive);
}

void ClipLinks::open(const QString& text) {
  ClipLink link;
  try {
    link = parse_clip_link(text.toStdString());
  } catch (const Error& error) {
    return emit failed(QString::fromStdString(error.what()));
  }
  const QString path = QString::fromStdString(link.clip);
  const QString name = QFileInfo(path).fileName();
  const bool is_here = QFileInfo::exists(path);
  const std::vector<ProjectClip>& clips = library_->project().clips;
  const auto known = std::ranges::find_if(clips, [&](const ProjectClip& clip) {
    return is_here ? clip.path == path : !clip.missing && QFileInfo(clip.path).fileName() == name;
  });
  if (!is_here && known == clips.end())
    return emit failed(
        tr("%1 is not on this computer, and the library has no clip of that name.").arg(path));
  ProjectClip clip{.path = path};
  if (known != clips.end()) clip = *known;
  if (link.take) clip.reading.take = link.take;
  link.clip = clip.path.toStdString();
  under_way_ = link;
  session_->open(clip.path, clip.skeleton, clip.reading);
}

void ClipLinks::arrive(const OpenRequest& request) {
  if (!under_way_) return;
  const ClipLink link = *std::exchange(under_way_, std::nullopt);
  // Another clip may have been opened instead.
  if (request.path != QFileInfo(QString::fromStdString(link.clip)).absoluteFilePath()) return;
  playback_->pause();
  if (link.frame) playback_->seek(std::min(*link.frame, playback_->frames() - 1));
  if (const Skeleton* skeleton = session_->document().skeleton())
    if (const int joint = skeleton->find(link.joint); joint >= 0)
      session_->document().setCurrentJoint(joint);
  if (!link.camera) return;
  std::array<float, 6> camera{};
  std::ranges::transform(*link.camera, camera.begin(),
                         [](double value) { return static_cast<float>(value); });
  const auto& [x, y, z, turn, height, distance] = camera;
  viewport_->setCameraPlace(
      {QVector3D(x, y, z), distance, qDegreesToRadians(turn), qDegreesToRadians(height)});
}

QString ClipLinks::toHere() const {
  const Document& document = session_->document();
  const OriginalPtr& original = document.original();
  if (!original) return {};
  ClipLink link{.clip = original->path.toStdString(),
                .take = original->reading.take,
                .frame = playback_->frame()};
  if (const int joint = document.currentJoint(); joint >= 0)
    link.joint = document.skeleton()->joint(joint).name;
  const OrbitCamera::Place place = viewport_->cameraPlace();
  const QVector3D& target = place.target;
  link.camera = {target.x(),
                 target.y(),
                 target.z(),
                 qRadiansToDegrees(place.azimuth),
                 qRadiansToDegrees(place.elevation),
                 place.distance};
  return QString::fromStdString(link_text(link));
}

void ClipLinks::copy() {
  const QString link = toHere();
  if (link.isEmpty()) return;
  QGuiApplication::clipboard()->setText(link);
  emit copied(tr("Copied the link to this frame and view."));
}

}  // namespace mocapress
