// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/link_receiver.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <memory>

#include "tests/qt/patience.h"

namespace mocapress {
namespace {

class Links : public testing::Test {
 protected:
  static QString last(const QSignalSpy& spy) { return spy.last().at(0).toString(); }

  QTemporaryDir folder_;
  const QString address_ = folder_.filePath(QStringLiteral("studio"));
  const QString link_ = QStringLiteral("mocapress://open?clip=/a/l'été.bvh&frame=3");
};

TEST_F(Links, GoToTheStudioThatRuns) {
  EXPECT_FALSE(handOver(link_, address_)) << "none runs";
  const LinkReceiver studio(nullptr, address_);
  QSignalSpy received(&studio, &LinkReceiver::received);
  for (int count = 1; count <= 2; ++count) {
    EXPECT_TRUE(handOver(link_, address_));
    ASSERT_TRUE(received.count() == count || received.wait(kPatience));
    EXPECT_EQ(last(received), link_);
  }
}

TEST_F(Links, GoToTheFirstOfSeveralStudios) {
  auto first = std::make_unique<LinkReceiver>(nullptr, address_);
  const LinkReceiver second(nullptr, address_);
  QSignalSpy received(first.get(), &LinkReceiver::received);
  EXPECT_TRUE(handOver(link_, address_));
  EXPECT_TRUE(received.count() > 0 || received.wait(kPatience));
  first.reset();
  EXPECT_FALSE(handOver(link_, address_));
}

TEST_F(Links, AFileLeftByAKilledStudioIsNoStudio) {
  QFile left(address_);
  ASSERT_TRUE(left.open(QIODevice::WriteOnly));
  left.close();
  EXPECT_FALSE(handOver(link_, address_));
  const LinkReceiver studio(nullptr, address_);
  QSignalSpy received(&studio, &LinkReceiver::received);
  EXPECT_TRUE(handOver(link_, address_));
  EXPECT_TRUE(received.count() > 0 || received.wait(kPatience));
}

}  // namespace
}  // namespace mocapress
