// SPDX-License-Identifier: MIT
#include "core/contact/slide_per_contact.h"

#include <gtest/gtest.h>

namespace mocapress {
namespace {

TEST(SlidePerContact, IsNothingWithoutContacts) {
  EXPECT_FALSE(slide_per_contact({}, 0).has_value());
}

TEST(SlidePerContact, CountsContactsThatDidNotSlide) {
  const Footskate footskate{.total_cm = 6,
                            .findings = {{.span = {}, .slid_cm = 4}, {.span = {}, .slid_cm = 2}}};
  const auto slide = slide_per_contact(footskate, 3);
  ASSERT_TRUE(slide.has_value());
  EXPECT_DOUBLE_EQ(slide->mean_cm, 2);
  EXPECT_DOUBLE_EQ(slide->worst_cm, 4);
}

TEST(SlidePerContact, IsZeroWhereNothingSlid) {
  const auto slide = slide_per_contact({}, 5);
  ASSERT_TRUE(slide.has_value());
  EXPECT_EQ(slide->mean_cm, 0);
  EXPECT_EQ(slide->worst_cm, 0);
}

}  // namespace
}  // namespace mocapress
