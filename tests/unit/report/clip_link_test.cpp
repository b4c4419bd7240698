// SPDX-License-Identifier: MIT
#include "core/report/clip_link.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace mocapress::test {
namespace {

TEST(ClipLink, ReadsBackFromItsText) {
  const ClipLink full{.clip = "/motion/50 % & more/wálk#1.fbx",
                      .take = "Run=fast",
                      .frame = 12,
                      .joint = "hips:lfoot",
                      .camera = std::array{1.5, -90.0, 0.0, 38.0, 12.5, 340.0}};
  const std::string text = link_text(full);
  EXPECT_EQ(text.find_first_of(" #\"<>"), text.npos) << text;
  EXPECT_EQ(parse_clip_link(text), full);
  const ClipLink plain{.clip = "/walk.bvh"};
  EXPECT_EQ(link_text(plain), "mocapress://open?clip=/walk.bvh");
  EXPECT_EQ(parse_clip_link("mocapress://open/?clip=/walk.bvh"), plain);
  EXPECT_EQ(parse_clip_link(link_text({.clip = "C:/motion/walk.bvh"})).clip, "C:/motion/walk.bvh");
}

TEST(ClipLink, LeavesOutWhatItDoesNotUnderstand) {
  const ClipLink link = parse_clip_link(
      "mocapress://open?clip=/a.bvh&frame=-3&camera=1,2,x&colour=red&&joint=%zz&take");
  EXPECT_EQ(link, (ClipLink{.clip = "/a.bvh", .take = "", .joint = "%zz"}));
  EXPECT_FALSE(parse_clip_link("mocapress://open?clip=/a.bvh&camera=1,2,3,4,5").camera);
  EXPECT_FALSE(parse_clip_link("mocapress://open?clip=/a.bvh&camera=1,2,3,4,5,6,7").camera);
  EXPECT_FALSE(parse_clip_link("mocapress://open?clip=/a.bvh&frame=1e12").frame);
}

TEST(ClipLink, OpensNothingButAClipOnThisComputer) {
  for (const char* path :
       {"", "walk.bvh", "../walk.bvh", "/motion/../../etc/walk.bvh", "//server/share/walk.bvh",
        "\\\\server\\share\\walk.bvh", "/\\server/walk.bvh", "/dev/stdin.bvh",
        "/proc/self/walk.bvh", "/etc/passwd", "/etc/.bashrc", "/project.mocapress", "C:walk.bvh",
        "C:\\..\\walk.bvh", "file:///walk.bvh", "/walk.bvh\n", "/w\x1b[2Jalk.bvh"})
    EXPECT_THROW(parse_clip_link(link_text({.clip = path})), Error) << path;
  for (const char* text : {"", "mocapress:", "mocapress://open", "mocapress://run?clip=/walk.bvh",
                           "http://open?clip=/walk.bvh", "mocapress://open?/walk.bvh"})
    EXPECT_THROW(parse_clip_link(text), Error) << text;
}

}  // namespace
}  // namespace mocapress::test
