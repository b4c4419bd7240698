// SPDX-License-Identifier: MIT
// Files on Windows: what tests/unit/base asks of POSIX, asked of the other bodies.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <io.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/appended_file.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/file_identity.h"
#include "core/base/file_lock.h"
#include "core/base/folder_listing.h"
#include "core/base/line_reader.h"
#include "core/base/machine.h"
#include "core/base/make_folders.h"
#include "core/base/mapped_file.h"
#include "core/base/memory_limit.h"
#include "core/base/open_file.h"
#include "core/base/path_kind.h"
#include "core/base/printable.h"
#include "core/base/utf8_path.h"
#include "core/base/windows/system.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::EndsWith;

class OnWindows : public testing::Test {
 protected:
  OnWindows() { make_folders(folder_); }
  ~OnWindows() override { fs::remove_all(folder_); }

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder_))
      all.push_back(utf8(entry.path().filename()));
    std::sort(all.begin(), all.end());
    return all;
  }

  template <typename Failure>
  static std::string failure(const std::function<void()>& work) {
    try {
      work();
      return "";
    } catch (const Failure& error) {
      return error.what();
    }
  }

  /// A file as editors and players hold it, who let nobody rename or remove it.
  static FileDescriptor held(const fs::path& path) {
    const HANDLE handle = ::CreateFileW(path.c_str(), GENERIC_READ, FILE_SHARE_READ, nullptr,
                                        OPEN_EXISTING, 0, nullptr);
    return FileDescriptor(::_open_osfhandle(reinterpret_cast<std::intptr_t>(handle), 0));
  }

  const fs::path folder_ =
      fs::path(testing::TempDir()) / ("windows-" + std::to_string(process_number()));
  const fs::path path_ = folder_ / "a.txt";
};

using StagedFileOnWindows = OnWindows;
using AppendedFileOnWindows = OnWindows;
using FileLockOnWindows = OnWindows;
using FileOnWindows = OnWindows;
using MachineOnWindows = OnWindows;

TEST_F(StagedFileOnWindows, TakesItsPlaceWholeOrNotAtAll) {
  write_text(path_, "old and long");
  {
    StagedFile file(path_);
    file.write("half");
    EXPECT_EQ(read_text(path_), "old and long");
  }
  EXPECT_EQ(read_text(path_), "old and long");
  write_text(path_, "new");
  EXPECT_EQ(read_text(path_), "new");
  EXPECT_THAT(names(), ElementsAre("a.txt"));
}

TEST_F(StagedFileOnWindows, IsReadBackAndOverwrittenBeforeItIsCommitted) {
  for (const auto temporary : {StagedFile::Temporary::Unnamed, StagedFile::Temporary::Named}) {
    StagedFile file(path_, temporary);
    file.write("0123");
    file.write_at(1, std::as_bytes(std::span("ab", 2)));
    file.write("45");
    EXPECT_EQ(file.read_back().size(), 6u);
    file.write("6");
    EXPECT_EQ(file.map_back().bytes().size(), 7u);
    file.commit();
    EXPECT_EQ(read_text(path_), "0ab3456");
    EXPECT_THAT(names(), ElementsAre("a.txt"));
  }
}

TEST_F(StagedFileOnWindows, ReplacesAFileThatIsBeingRead) {
  write_text(path_, "old");
  const MappedFile mapped(path_);
  const FileDescriptor open = open_to_read(path_);
  write_text(path_, "newer");
  EXPECT_EQ(read_text(path_), "newer");
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(mapped.bytes().data()), 3), "old");
  std::string text(10, ' ');
  EXPECT_TRUE(read_all(open.number(), 0, text));
  EXPECT_EQ(text, "old");
  EXPECT_FALSE(is_at(open.number(), path_));
}

TEST_F(StagedFileOnWindows, AFileHeldByAnotherProgramStaysAndIsNamed) {
  write_text(path_, "old");
  {
    const FileDescriptor program = held(path_);
    ASSERT_TRUE(program);
    EXPECT_EQ(failure<WriteError>([&] { write_text(path_, "new"); }),
              utf8(path_) + ": cannot be written: is open in another program");
  }
  EXPECT_EQ(read_text(path_), "old");
  EXPECT_THAT(names(), ElementsAre("a.txt"));
}

TEST_F(StagedFileOnWindows, RefusesWhatIsWriteProtectedAFolderOrADevice) {
  write_text(path_, "old");
  ::SetFileAttributesW(path_.c_str(), FILE_ATTRIBUTE_READONLY);
  EXPECT_THAT(failure<WriteError>([&] { write_text(path_, "new"); }),
              EndsWith("a.txt: cannot be written: is write-protected"));
  ::SetFileAttributesW(path_.c_str(), FILE_ATTRIBUTE_NORMAL);
  EXPECT_EQ(read_text(path_), "old");
  EXPECT_THAT(failure<WriteError>([&] { write_text(folder_, "new"); }),
              EndsWith("is a folder, not a file"));
  EXPECT_THROW(write_text("NUL", "new"), WriteError);
  EXPECT_THROW(write_text("C:\\", "new"), WriteError);
  EXPECT_THROW(write_text("", "new"), WriteError);
  EXPECT_THROW(write_text(folder_ / "none/a.txt", "new"), WriteError);
}

TEST_F(StagedFileOnWindows, TakesOnlyAFreePlaceIfAskedTo) {
  StagedFile first(path_);
  StagedFile second(path_);
  first.write("first");
  second.write("second");
  first.commit(StagedFile::Existing::Refuse);
  EXPECT_THROW(second.commit(StagedFile::Existing::Refuse), WriteError);
  EXPECT_EQ(read_text(path_), "first");
}

TEST_F(StagedFileOnWindows, ManyAreCommittedTogether) {
  std::vector<StagedFile> files;
  for (const char* name : {"x", "y", "z"}) files.emplace_back(folder_ / name).write(name);
  StagedFile::commit_all(files);
  files.clear();
  EXPECT_THAT(names(), ElementsAre("x", "y", "z"));
}

TEST_F(FileOnWindows, PathsMayBeLongerThan260Characters) {
  fs::path deep = folder_;
  for (int i = 0; i < 12; ++i) deep /= std::string(40, static_cast<char>('a' + i));
  make_folders(deep);
  write_text(deep / "clip.txt", "far down");
  EXPECT_GT(utf8(deep / "clip.txt").size(), 500u);
  EXPECT_EQ(read_text(deep / "clip.txt"), "far down");
  EXPECT_EQ(path_kind(deep), PathKind::Folder);
  const FolderListing listing = list_folder(deep);
  ASSERT_EQ(listing.entries.size(), 1u);
  EXPECT_EQ(listing.entries[0].path, deep / "clip.txt");
  EXPECT_EQ(listing.entries[0].kind, PathKind::File);
  EXPECT_TRUE(remove_file(deep / "clip.txt"));
  EXPECT_FALSE(is_there(deep / "clip.txt"));
  // The standard library's remove_all() does not reach this deep.
  for (; deep != folder_; deep = deep.parent_path())
    ::RemoveDirectoryW(windows::system_path(deep).c_str());
}

TEST_F(FileOnWindows, NamesMayHaveAnyLetters) {
  const std::string name = "Łódź 動き 🕺 шаг é.txt";  // UTF-8
  write_text(folder_ / utf8_path(name), "letters");
  EXPECT_THAT(names(), ElementsAre(name));
  EXPECT_EQ(read_text(folder_ / utf8_path(name)), "letters");
  const fs::path none = folder_ / utf8_path("no " + name);
  EXPECT_EQ(failure<InputError>([&] { read_text(none); }),
            utf8(none) + ": " + std::strerror(ENOENT));
}

TEST_F(FileOnWindows, NamesThatAreNotUnicodeAreRefused) {
  EXPECT_EQ(failure<InputError>([] { utf8_path("a\xff.bvh"); }),
            printable("a\xff.bvh") + ": is a name that is not UTF-8");
  EXPECT_THROW(utf8(fs::path(L"half \xd800 a pair")), InputError);
  EXPECT_EQ(generic_utf8(utf8_path("動\\き/a")), "動/き/a");
}

TEST_F(FileOnWindows, NamesThatDifferOnlyInCaseHaveOneKey) {
  EXPECT_EQ(name_key("Łódź/Walk.mcpr"), name_key("łÓDŹ/wALK.mcpr"));
  EXPECT_NE(name_key("straße"), name_key("strasse"))
      << "by the rules of file systems, not of texts";
  EXPECT_NE(name_key("walk"), name_key("walk2"));
  EXPECT_EQ(name_key(""), "");
}

TEST_F(FileOnWindows, ARealPathIsOneForAllNamesOfAFile) {
  make_folders(folder_ / "below");
  write_text(folder_ / "below/clip.bin", "bytes");
  const auto real = real_path(folder_ / "below/clip.bin");
  ASSERT_TRUE(real);
  EXPECT_EQ(real, real_path(folder_ / "BELOW/../below/CLIP.BIN"));
  EXPECT_EQ(real->parent_path(), real_path(folder_ / "below"));
  EXPECT_EQ(utf8(real->lexically_relative(*real_path(folder_))), "below\\clip.bin");
  EXPECT_EQ(read_text(*real), "bytes");
  EXPECT_EQ(real_path(folder_ / "none"), std::nullopt);
}

TEST_F(FileOnWindows, AServerThatDoesNotAnswerIsNotAbsence) {
  for (const DWORD unreachable : {ERROR_BAD_NETPATH, ERROR_BAD_NET_NAME}) {
    ::SetLastError(unreachable);
    windows::failed();
    EXPECT_FALSE(is_absence(errno)) << unreachable;
  }
}

TEST_F(FileOnWindows, RefusesFoldersDevicesAndWhatIsAbsent) {
  EXPECT_THAT(failure<InputError>([&] { read_text(folder_); }),
              EndsWith("is a folder, not a file"));
  EXPECT_THAT(failure<InputError>([&] { read_text("NUL"); }),
              EndsWith("is a pipe or a device, not a file"));
  for (const char* absent : {"none", "none/none", "what?", "Q:/none"})
    EXPECT_EQ(path_kind(folder_ / absent), PathKind::Absent) << absent;
}

TEST_F(FileOnWindows, LinesHaveTheirPlacesAndMayEndInCrLf) {
  write_text(path_, "one\r\ntwo\nlast");
  EXPECT_EQ(read_text(path_), "one\r\ntwo\nlast") << "bytes are not translated";
  LineReader reader(path_);
  std::string line;
  ASSERT_TRUE(reader.next(line));
  ASSERT_TRUE(reader.next(line));
  EXPECT_EQ(reader.offset(), 5u);
  EXPECT_EQ(line, "two");
}

TEST_F(FileOnWindows, OneFileHasManyNames) {
  write_text(path_, "same");
  write_text(folder_ / "b.txt", "same");
  ASSERT_TRUE(::CreateHardLinkW((folder_ / "hard").c_str(), path_.c_str(), nullptr));
  for (const char* name : {"A.TXT", "hard", "./a.txt"})
    EXPECT_EQ(identity_of(folder_ / name), identity_of(path_)) << name;
  EXPECT_NE(identity_of(folder_ / "b.txt"), identity_of(path_));
  EXPECT_EQ(identity_of(folder_ / "none"), std::nullopt);
  EXPECT_THROW(refuse_source(folder_ / "A.txt", {path_}), WriteError);
}

TEST_F(FileOnWindows, FoldersAreMadeDownFromTheRootOfADrive) {
  make_folders("C:\\");
  make_folders(folder_ / "a\\b/c");
  make_folders(folder_ / "a/b/c/");
  EXPECT_EQ(path_kind(folder_ / "a/b/c"), PathKind::Folder);
  EXPECT_THROW(make_folders("Q:\\none\\none"), WriteError);
  write_text(path_, "a");
  EXPECT_THROW(make_folders(path_), WriteError);
  EXPECT_THROW(make_folders(path_ / "below"), WriteError);
}

TEST_F(AppendedFileOnWindows, GrowsByLinesAndKeepsOthersAway) {
  {
    AppendedFile file(path_);
    file.append("one");
    EXPECT_EQ(file.read(0, 3), "one");
    file.append("two");
    EXPECT_EQ(file.size(), 8u);
    EXPECT_THROW(AppendedFile other(path_), InUse);
    EXPECT_EQ(read_text(path_), "one\ntwo\n") << "who only reads is let in";
  }
  AppendedFile file(path_);
  file.append("three");
  EXPECT_EQ(read_text(path_), "one\ntwo\nthree\n");
}

TEST_F(AppendedFileOnWindows, IsReplacedAsAWholeAndGoesOnInTheNewFile) {
  AppendedFile file(path_);
  file.append("old");
  file.replace([](StagedFile& now) { now.write("new\n"); });
  EXPECT_EQ(file.size(), 4u);
  file.append("more");
  EXPECT_EQ(read_text(path_), "new\nmore\n");
  EXPECT_THROW(AppendedFile other(path_), InUse);
  EXPECT_THAT(names(), ElementsAre("a.txt"));
}

TEST_F(AppendedFileOnWindows, IsNotLeftBehindEmpty) {
  { AppendedFile file(path_); }
  EXPECT_FALSE(is_there(path_));
}

TEST_F(FileLockOnWindows, OneAtATimeHasItAlsoAfterTheFileWasReplaced) {
  const auto no = [] { return false; };
  write_text(path_, "old");
  std::optional<FileLock> first = FileLock::wait_for(path_, no);
  ASSERT_TRUE(first);
  EXPECT_FALSE(FileLock::wait_for(path_, no));
  const std::optional<FileLock> second = FileLock::wait_for(path_, [&] {
    write_text(path_, "new");
    first.reset();
    return true;
  });
  ASSERT_TRUE(second);
  EXPECT_FALSE(FileLock::wait_for(path_, no)) << "the lock is on the file that is there now";
  EXPECT_EQ(read_text(path_), "new");
}

TEST_F(MachineOnWindows, TellsItsMemoryNameAndUser) {
  EXPECT_GT(half_of_the_memory(), std::uint64_t{1} << 28);
  EXPECT_NE(host_name(), "");
  EXPECT_NE(user_name(), "");
}

}  // namespace
}  // namespace mocapress
