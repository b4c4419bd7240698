// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/clip_sources.h"

#include <QDirIterator>
#include <QFileInfo>
#include <QHash>
#include <QStringList>
#include <filesystem>

#include "core/base/error.h"

namespace mocapress {
namespace {

InputStamp stampOf(const ClipSource& source, const InputStamp& earlier) {
  BatchItem item;
  item.input = source.path.toStdString();
  item.skeleton = source.skeleton.toStdString();
  return stamp_again(item, {}, earlier);
}

bool isGone(const QString& path) {
  std::error_code error;
  const bool there = std::filesystem::exists(std::filesystem::path(path.toStdU16String()), error);
  return !there && !error;
}

/// Paths of the files below a folder, by file name. The keys are the names to look for.
using Places = QHash<QString, QStringList>;

Places placesOf(Places wanted, const QString& folder, const Job& job) {
  QDirIterator files(folder, QDir::Files, QDirIterator::Subdirectories);
  while (files.hasNext() && !job.stopRequested()) {
    const QString path = files.next();
    if (const auto found = wanted.find(files.fileName()); found != wanted.end()) *found << path;
  }
  return wanted;
}

QString nameOf(const QString& path) {
  return QFileInfo(path).fileName();
}

/// All pairs of a found motion and a found skeleton that may be the missing clip.
std::vector<ClipSource> candidates(const ClipSource& clip, const Places& places) {
  QStringList skeletons{clip.skeleton};
  if (!clip.skeleton.isEmpty() && isGone(clip.skeleton)) skeletons = places[nameOf(clip.skeleton)];
  std::vector<ClipSource> all;
  for (const QString& path : places[nameOf(clip.path)])
    for (const QString& skeleton : skeletons) all.push_back({path, skeleton, {}});
  return all;
}

}  // namespace

SourceNow lookAt(const ClipSource& source) {
  try {
    return {SourceNow::State::Found, stampOf(source, source.stamp), {}};
  } catch (const std::exception& error) {
    if (isGone(source.path)) return {SourceNow::State::Missing, {}, {}};
    return {SourceNow::State::Unreadable, {}, QString::fromStdString(error.what())};
  }
}

std::vector<SourceNow> lookAt(const std::vector<ClipSource>& sources, const Job& job) {
  std::vector<SourceNow> all;
  for (const ClipSource& source : sources) {
    if (job.stopRequested()) break;
    all.push_back(lookAt(source));
  }
  return all;
}

std::map<QString, ClipSource> findMoved(const QString& folder,
                                        const std::vector<ClipSource>& missing, const Job& job) {
  Places places;
  for (const ClipSource& clip : missing)
    for (const QString& path : {clip.path, clip.skeleton}) places.insert(nameOf(path), {});
  places = placesOf(std::move(places), folder, job);
  std::map<QString, ClipSource> moved;
  for (const ClipSource& clip : missing) {
    if (job.stopRequested()) break;
    std::vector<ClipSource> readable;
    for (ClipSource& one : candidates(clip, places)) {
      const SourceNow now = lookAt(one);
      if (now.state != SourceNow::State::Found) continue;
      one.stamp = now.stamp;
      readable.push_back(one);
    }
    for (const ClipSource& one : readable)
      if (readable.size() == 1 || one.stamp.hash == clip.stamp.hash) moved.emplace(clip.path, one);
  }
  return moved;
}

}  // namespace mocapress
