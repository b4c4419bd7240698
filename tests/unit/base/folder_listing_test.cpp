// SPDX-License-Identifier: MIT
#include "core/base/folder_listing.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace mocapress::folder_listing_test {
namespace {

namespace fs = std::filesystem;

class FolderListingTest : public testing::Test {
 protected:
  FolderListingTest() { fs::create_directories(folder_ / "below"); }
  ~FolderListingTest() override { fs::remove_all(folder_); }

  const fs::path folder_ =
      fs::path(testing::TempDir()) / ("folder-listing-" + std::to_string(getpid()));
};

TEST_F(FolderListingTest, HasFilesAndFoldersByKindAndNothingBelowThem) {
  std::ofstream(folder_ / "a.bvh") << "a";
  std::ofstream(folder_ / "below" / "b.bvh") << "b";
  FolderListing listing = list_folder(folder_);
  std::ranges::sort(listing.entries, {}, &FolderEntry::path);
  ASSERT_EQ(listing.entries.size(), 2u);
  EXPECT_EQ(listing.entries[0].path, folder_ / "a.bvh");
  EXPECT_EQ(listing.entries[0].kind, PathKind::File);
  EXPECT_EQ(listing.entries[1].path, folder_ / "below");
  EXPECT_EQ(listing.entries[1].kind, PathKind::Folder);
  for (const FolderEntry& entry : listing.entries) {
    EXPECT_FALSE(entry.is_link);
    EXPECT_EQ(entry.problem, "");
  }
  EXPECT_EQ(listing.problem, "");
}

TEST_F(FolderListingTest, IsEmptyForAnEmptyFolderAndSaysWhatIsWrongWithAnother) {
  EXPECT_TRUE(list_folder(folder_ / "below").entries.empty());
  EXPECT_EQ(list_folder(folder_ / "below").problem, "");
  EXPECT_NE(list_folder(folder_ / "none").problem, "");
}

}  // namespace
}  // namespace mocapress::folder_listing_test
