// SPDX-License-Identifier: GPL-3.0-or-later
// A library of clips on disk, for tests of its parts.
#pragma once

#include <gtest/gtest.h>

#include <QDir>
#include <QSignalSpy>
#include <QString>
#include <QTemporaryDir>

#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "core/formats/motion_file.h"
#include "tests/qt/patience.h"
#include "tests/support/test_motion.h"
#include "widgets/models/library_model.h"

namespace mocapress {

/// Settings of the paper's standard method, which compresses at once.
inline EncodeSettings standardAt(double ratio) {
  return {.method = Method::Standard, .target = {Target::Kind::Ratio, ratio}};
}

class InALibrary : public testing::Test {
 protected:
  /// One run of the studio without its window.
  struct Run {
    Session session;
    LibraryModel model;
    Library library{&session, &model};
    Run() { session.setOptions(standardAt(10)); }
  };

  QString clip(const char* name, unsigned seed) const {
    write_motion(path(name).toStdU16String(), test::smooth_motion(120, seed));
    return path(name);
  }

  template <typename Act>
  static void settleAfter(Run& run, Act act) {
    QSignalSpy settled(&run.session, &Session::settled);
    act();
    ASSERT_TRUE(settled.count() > 0 || settled.wait(kPatience));
  }

  QString path(const char* name) const {
    return QDir(QDir(directory_.path()).canonicalPath()).filePath(QString::fromLatin1(name));
  }

  /// The folder of the studio's data.
  QString data() const { return path("data"); }

  QTemporaryDir directory_;
};

}  // namespace mocapress
