// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/clips.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include "core/base/file.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

class ClipSaving : public testing::Test {
 protected:
  ClipSaving() {
    original_.encoder = std::make_shared<const Encoder>(test::smooth_motion(300));
    const EncodeSettings options{.method = Method::ClosedLoop, .target = {Target::Kind::Ratio, 20}};
    decoded_ = *decodedClip(original_.encoder->encode(options), *original_.encoder, options);
  }

  std::vector<std::byte> written() const { return read_bytes(path_.toStdString()); }

  QTemporaryDir folder_;
  const QString path_ = folder_.filePath(QStringLiteral("clip.mcpr"));
  OriginalClip original_;
  DecodedClip decoded_;
};

TEST_F(ClipSaving, WritesWhatWasVerified) {
  saveClip(path_, decoded_, &original_, {});
  EXPECT_EQ(written(), decoded_.file);
  const DecodedPtr opened = decodedClip(open_mcpr(path_.toStdString()), nullptr, {});
  QFile::remove(path_);
  saveClip(path_, *opened, nullptr, {});
  EXPECT_EQ(written(), decoded_.file) << "a clip without its original is read instead";
}

TEST_F(ClipSaving, LeavesTheOldFileWhereTheNewOneIsNotTheClip) {
  saveClip(path_, decoded_, &original_, {});
  const std::vector<std::byte> before = written();
  DecodedClip damaged = decoded_;
  damaged.file[damaged.file.size() / 2] ^= std::byte{1};
  EXPECT_THROW(saveClip(path_, damaged, &original_, {}), Error);
  EXPECT_THROW(saveClip(path_, damaged, nullptr, {}), Error);
  OriginalClip another;
  another.encoder = std::make_shared<const Encoder>(test::smooth_motion(299));
  EXPECT_THROW(saveClip(path_, decoded_, &another, {}), Error);
  EXPECT_EQ(written(), before);
}

}  // namespace
}  // namespace mocapress
