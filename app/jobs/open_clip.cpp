// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/open_clip.h"

#include <QCoreApplication>
#include <filesystem>
#include <optional>

#include "core/formats/motion_file.h"

namespace mocapress {
namespace {

std::filesystem::path toPath(const QString& path) {
  return path.toStdU16String();
}

OpenedClip openCompressed(const OpenRequest& request) {
  OpenedMcpr opened = open_mcpr(toPath(request.path));
  const bool together =
      request.original && comparable(request.original->motion(), opened.compressed);
  const OriginalPtr original = together ? request.original : nullptr;
  return {original, decodedClip(std::move(opened), original.get())};
}

OpenedClip openOriginal(const OpenRequest& request) {
  std::optional<std::filesystem::path> skeleton;
  if (!request.skeleton.isEmpty()) skeleton = toPath(request.skeleton);
  MotionFile file = read_motion(toPath(request.path), skeleton);

  OriginalClip original;
  original.path = request.path;
  original.warnings = std::move(file.warnings);
  original.encoder = std::make_shared<const Encoder>(std::move(file.motion));
  const bool together =
      request.decoded && comparable(original.motion(), request.decoded->compressed);
  if (request.compare && !together)
    throw Error(QCoreApplication::translate("mocapress::OpenClip",
                                            "%1 is not the original of the compressed clip: "
                                            "joints, frames or sample rate differ.")
                    .arg(request.path)
                    .toStdString());
  OpenedClip opened;
  if (together) opened.decoded = measured(*request.decoded, original);
  opened.original = std::make_shared<const OriginalClip>(std::move(original));
  return opened;
}

}  // namespace

bool isCompressedFile(const QString& path) {
  return path.endsWith(QStringLiteral(".mcpr"), Qt::CaseInsensitive);
}

OpenedClip openClip(const OpenRequest& request) {
  return isCompressedFile(request.path) ? openCompressed(request) : openOriginal(request);
}

}  // namespace mocapress
