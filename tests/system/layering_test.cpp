// SPDX-License-Identifier: MIT
// Checks the includes between rooms, and rules for every source file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/file.h"

namespace mocapress::test {
namespace {

namespace fs = std::filesystem;

struct RoomRules {
  std::set<std::string> may_include;  // beside its own: folders and all below, or files
  bool may_use_qt = false;
  bool stands_alone = false;  // an engine takes it: it depends on the standard library only
};

/// The engine's C header, which defines result codes for every part of the runtime.
const std::string kCInterface = "core/runtime/mocapress_runtime.h";

/// The rooms from the ground up: a room includes only earlier ones.
const std::map<std::string, RoomRules> kRooms = {
    {"core/base", {}},
    {"core/runtime/processor", {{kCInterface}, false, true}},
    {"core/runtime/format", {{kCInterface, "core/runtime/processor"}, false, true}},
    {"core/runtime/ik", {{kCInterface, "core/runtime/format"}, false, true}},
    {"core/runtime/decode",
     {{kCInterface, "core/runtime/processor", "core/runtime/format", "core/runtime/ik"},
      false,
      true}},
    {"core/runtime/pose",
     {{kCInterface, "core/runtime/processor", "core/runtime/format", "core/runtime/decode"},
      false,
      true}},
    {"core/runtime/bank", {{kCInterface, "core/runtime/format", "core/runtime/pose"}, false, true}},
    // The header for C++ lies beside the C header wherever it is installed.
    {"core/runtime", {{"core/runtime", "mocapress_runtime.h"}, false, true}},
    // A program that uses the interface, as an engine does.
    {"core/runtime/web", {{kCInterface, "core/runtime/mocapress_runtime.hpp"}, false, true}},
    {"core/motion", {{"core/base", "core/runtime"}}},
    {"core/formats", {{"core/base", "core/motion", "core/runtime"}}},
    {"core/wavelet", {{"core/base", "core/runtime"}}},
    {"core/ik", {{"core/base", "core/motion", "core/runtime"}}},
    {"core/feet", {{"core/base", "core/motion", "core/ik"}}},
    {"core/metrics", {{"core/base", "core/motion", "core/feet"}}},
    {"core/select", {{"core/base", "core/motion", "core/wavelet", "core/metrics"}}},
    {"core/codec/format",
     {{"core/base", "core/motion", "core/wavelet", "core/select", "core/ik", "core/runtime"}}},
    {"core/codec/decode",
     {{"core/base", "core/motion", "core/wavelet", "core/ik", "core/codec/format",
       "core/runtime"}}},
    {"core/codec/encode/options",
     {{"core/base", "core/motion", "core/metrics", "core/select", "core/feet", "core/ik",
       "core/codec/format"}}},
    {"core/codec/encode/closed_loop",
     {{"core/base", "core/motion", "core/wavelet", "core/select", "core/codec/format",
       "core/runtime", "core/codec/encode/options"}}},
    {"core/codec/encode/analysis",
     {{"core/base", "core/motion", "core/wavelet", "core/select", "core/metrics", "core/feet",
       "core/codec/format", "core/codec/encode/options", "core/codec/encode/closed_loop"}}},
    {"core/codec/encode/search",
     {{"core/base", "core/motion", "core/metrics", "core/codec/format", "core/codec/decode",
       "core/codec/encode/options", "core/codec/encode/closed_loop"}}},
    {"core/codec/encode/mend",
     {{"core/base", "core/motion", "core/wavelet", "core/select", "core/metrics", "core/feet",
       "core/ik", "core/codec/format", "core/codec/decode", "core/runtime",
       "core/codec/encode/options", "core/codec/encode/search"}}},
    {"core/codec/encode",
     {{"core/base", "core/motion", "core/wavelet", "core/select", "core/metrics", "core/feet",
       "core/ik", "core/codec/format", "core/codec/decode", "core/runtime", "core/codec/encode"}}},
    {"core/codec/methods",
     {{"core/base", "core/motion", "core/metrics", "core/feet", "core/ik", "core/codec/format",
       "core/codec/decode", "core/codec/encode"}}},
    {"core/report",
     {{"core/base", "core/motion", "core/formats", "core/codec", "core/metrics", "core/feet",
       "core/ik"}}},
    {"core/mocapress",
     {{"core/base", "core/motion", "core/formats", "core/codec", "core/metrics", "core/feet",
       "core/ik", "core/report", "core/runtime"}}},
    {"core/mocapress/python",
     {{"core/base", "core/motion", "core/formats", "core/codec", "core/metrics", "core/report",
       "core/runtime", "core/bank", "core/mocapress"}}},
    {"core/study",
     {{"core/base", "core/motion", "core/formats", "core/codec", "core/metrics", "core/feet",
       "core/report", "core/mocapress"}}},
    {"core/baselines",
     {{"core/base", "core/motion", "core/wavelet", "core/select", "core/codec", "core/runtime"}}},
    {"core/bank", {{"core/base", "core/codec/format", "core/runtime"}}},
    {"core/batch",
     {{"core/base", "core/bank", "core/motion", "core/formats", "core/codec", "core/metrics",
       "core/feet", "core/report", "core/mocapress", "core/runtime"}}},
    {"resources", {{"core"}}},
    {"widgets", {{"core"}, true}},
    {"app/cli", {{"core"}}},
    {"app/jobs", {{"core"}, true}},
    {"app/studio", {{"core", "widgets", "app/jobs"}, true}},
    {"app", {{"core", "widgets", "app/jobs", "app/studio", "translations"}, true}},
    {"translations", {{}, true}},
};

/// The deepest room of the table that holds a file, else its own folder.
std::string room_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  for (fs::path room = folder; !room.empty(); room = room.parent_path())
    if (kRooms.contains(room.generic_string())) return room.generic_string();
  return folder.generic_string();
}

/// A grant names a file, or a folder with everything below it.
bool covers(const std::string& grant, const std::string& path) {
  return path == grant || path.starts_with(grant + "/");
}

/// The rooms that a room may include, without itself.
std::vector<std::string> rooms_below(const std::string& room) {
  std::vector<std::string> below;
  for (const auto& [other, rules] : kRooms)
    for (const std::string& grant : kRooms.at(room).may_include)
      if (other != room && covers(grant, other)) below.push_back(other);
  return below;
}

/// Rooms that include one another in a circle, and rooms that depend on those.
std::set<std::string> rooms_in_circles() {
  std::set<std::string> left;
  for (const auto& [room, rules] : kRooms) left.insert(room);
  const auto stands_on_nothing_left = [&](const std::string& room) {
    return std::ranges::none_of(rooms_below(room), [&](const auto& r) { return left.contains(r); });
  };
  while (std::erase_if(left, stands_on_nothing_left) > 0) continue;
  return left;
}

bool is_qt(const std::string& header) {
  static const std::regex kQt("Q.*|qt.*|q[a-z]+\\.h");
  return std::regex_match(header, kQt);
}

/// The fault of including `header` in `room`; empty: none.
std::string complaint(const std::string& room, const std::string& header, bool quoted) {
  const RoomRules& rules = kRooms.at(room);
  if (is_qt(header)) return rules.may_use_qt ? "" : room + " uses Qt: " + header;
  if (!quoted)
    return rules.stands_alone && header.find('/') != std::string::npos
               ? room + " uses more than the standard library: " + header
               : "";
  const auto is_granted = [&](const std::string& grant) { return covers(grant, header); };
  if (room_of(header) == room || std::ranges::any_of(rules.may_include, is_granted)) return "";
  return room + " may not include " + header;
}

std::string licence_of(const std::string& path) {
  for (const char* folder : {"widgets/", "app/", "translations/", "tests/qt/"})
    if (path.starts_with(folder)) return "GPL-3.0-or-later";
  return "MIT";
}

/// All faults of one source file, a sentence each. `path` is relative to the root.
std::vector<std::string> findings(const std::string& path, const std::string& text) {
  static const std::regex kInclude(R"(\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  static const std::regex kNarrowName(R"((\.|->)(generic_)?string\(\))");
  static const std::regex kMachinePath(R"((^|[^\w./])/(home|work|root|Users)/\w.*)");
  std::vector<std::string> found;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  if (!line.ends_with(" SPDX-License-Identifier: " + licence_of(path)))
    found.push_back(path + ":1: does not begin with the SPDX line of " + licence_of(path));
  // Tests may include anything, and so may the runtime's examples, which no library holds.
  const bool in_room = !path.starts_with("tests/") && !path.starts_with("core/runtime/example/") &&
                       !path.ends_with("CMakeLists.txt");
  const bool known = kRooms.contains(room_of(path));
  const bool runs_on_windows = path.starts_with("core/") || path.starts_with("app/cli/");
  if (in_room && !known)
    found.push_back(path + ": the room " + room_of(path) + " is not in the table of this test");
  for (int number = 2; std::getline(lines, line); ++number) {
    const auto report = [&](const std::string& sentence) {
      if (!sentence.empty()) found.push_back(path + ":" + std::to_string(number) + ": " + sentence);
    };
    std::smatch match;
    if (in_room && known && std::regex_match(line, match, kInclude))
      report(complaint(room_of(path), match[2], match[1] == "\""));
    if (runs_on_windows && std::regex_search(line, kNarrowName))
      report("takes a name in the letters of Windows' code page: see core/base/utf8_path.h");
    if (std::regex_search(line, kMachinePath)) report("names a path of one machine");
  }
  return found;
}

std::vector<fs::path> sources_below(const fs::path& folder) {
  std::vector<fs::path> sources;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path& path = entry.path();
    if (path.extension() == ".h" || path.extension() == ".hpp" || path.extension() == ".cpp" ||
        path.extension() == ".inc" || path.filename() == "CMakeLists.txt")
      sources.push_back(path);
  }
  return sources;
}

TEST(Layering, EverySourceKeepsToItsRoom) {
  const fs::path root = MOCAPRESS_SOURCE_DIR;
  int files = 0;
  for (const char* top : {"core", "widgets", "app", "resources/samples", "translations", "tests"})
    for (const fs::path& source : sources_below(root / top)) {
      const std::string path = fs::relative(source, root).generic_string();
      EXPECT_THAT(findings(path, read_text(source)), testing::IsEmpty());
      ++files;
    }
  EXPECT_GT(files, 100) << "the walk over the sources missed some";
}

TEST(Layering, NoRoomIncludesItselfByWayOfOthers) {
  EXPECT_THAT(rooms_in_circles(), testing::IsEmpty());
}

std::vector<std::string> findings_in_body(const std::string& path, const std::string& body) {
  return findings(path, "// SPDX-License-Identifier: " + licence_of(path) + "\n" + body + "\n");
}

TEST(LayeringChecker, FindsQtInCore) {
  for (const char* header : {"<QString>", "<QtGlobal>", "<Qt3DCore/QEntity>", "\"QString\"",
                             "<qcustomplot.h>", "<qtgui/qtguiglobal.h>"})
    EXPECT_EQ(findings_in_body("core/motion/clip.h", std::string("#include ") + header).size(), 1u)
        << header;
  EXPECT_THAT(findings_in_body("core/motion/clip.h", "int a;\n  #  include <QString>"),
              testing::ElementsAre("core/motion/clip.h:3: core/motion uses Qt: QString"));
}

TEST(LayeringChecker, FindsQtInTheCommandLine) {
  EXPECT_EQ(findings_in_body("app/cli/main.cpp", "#include <QString>").size(), 1u);
}

TEST(LayeringChecker, FindsWhatPointsUpwards) {
  const std::pair<const char*, const char*> upward[] = {
      {"core/motion/clip.cpp", "widgets/plots/error_graph.h"},
      {"core/motion/clip.cpp", "app/jobs/clips.h"},
      {"core/base/error.cpp", "core/motion/clip.h"},
      {"core/wavelet/lifting.cpp", "core/select/ranking.h"},
      {"widgets/plots/error_graph.cpp", "app/studio/document/document.h"},
      {"app/jobs/compressor.cpp", "widgets/plots/error_graph.h"},
      {"app/cli/main.cpp", "app/jobs/compressor.h"},
  };
  for (const auto& [path, header] : upward)
    EXPECT_EQ(findings_in_body(path, "#include \"" + std::string(header) + "\"").size(), 1u)
        << path << " including " << header;
}

TEST(LayeringChecker, FindsAnIncludeThatIsNotByItsPathFromTheRoot) {
  EXPECT_EQ(findings_in_body("core/motion/clip.cpp", "#include \"skeleton.h\"").size(), 1u);
}

TEST(LayeringChecker, FindsARoomThatTheTableDoesNotKnow) {
  EXPECT_EQ(findings_in_body("core/new/thing.h", "#include <vector>").size(), 1u);
}

TEST(LayeringChecker, KeepsTheRuntimeSelfContained) {
  for (const char* header : {"<Eigen/Core>", "\"core/motion/clip.h\"", "\"core/ik/chain.h\""})
    EXPECT_EQ(
        findings_in_body("core/runtime/ik/limb.cpp", std::string("#include ") + header).size(), 1u)
        << header;
  for (const char* header :
       {"<algorithm>", "\"core/runtime/ik/limb.h\"", "\"core/runtime/format/cursor.h\""})
    EXPECT_THAT(findings_in_body("core/runtime/ik/limb.cpp", std::string("#include ") + header),
                testing::IsEmpty());
}

TEST(LayeringChecker, FindsTheWrongLicenceOrNone) {
  EXPECT_EQ(findings("core/base/error.h", "#pragma once\n").size(), 1u);
  EXPECT_EQ(findings("core/base/error.h", "").size(), 1u);
  EXPECT_EQ(findings("core/base/error.h", "// SPDX-License-Identifier: GPL-3.0-or-later\n").size(),
            1u);
  EXPECT_EQ(findings("widgets/CMakeLists.txt", "# SPDX-License-Identifier: MIT\n").size(), 1u);
}

TEST(LayeringChecker, FindsAPathOfOneMachine) {
  // The text is split, since this file is checked too.
  EXPECT_EQ(findings_in_body("core/base/file.cpp",
                             "open(\"/home"
                             "/ann/walk.bvh\");")
                .size(),
            1u);
  EXPECT_EQ(findings_in_body("tests/unit/a_test.cpp",
                             "// see /work"
                             "/notes")
                .size(),
            1u);
}

TEST(LayeringChecker, FindsNamesThatAreNotUtf8) {
  for (const char* line : {"a = path.string();", "a = path->generic_string();"}) {
    EXPECT_EQ(findings_in_body("core/batch/row.cpp", line).size(), 1u) << line;
    EXPECT_EQ(findings_in_body("app/cli/info.cpp", line).size(), 1u) << line;
    EXPECT_THAT(findings_in_body("tests/unit/a_test.cpp", line), testing::IsEmpty()) << line;
  }
}

TEST(LayeringChecker, PassesWhatTheRoomsMayDo) {
  EXPECT_THAT(
      findings_in_body("core/codec/encode/encoder.cpp",
                       "#include <Eigen/Core>\n#include \"core/codec/encode/search/goal.h\"\n"
                       "#include \"core/select/ranking.h\"\n#include <tbb/parallel_for.h>\n"
                       "// at home/work/root"),
      testing::IsEmpty());
  EXPECT_THAT(findings_in_body("widgets/plots/error_graph.cpp",
                               "#include <qcustomplot.h>\n#include \"core/motion/clip.h\"\n"
                               "#include \"widgets/plots/plot_style.h\""),
              testing::IsEmpty());
  EXPECT_THAT(findings_in_body("app/main.cpp", "#include \"app/studio/document/document.h\""),
              testing::IsEmpty());
}

}  // namespace
}  // namespace mocapress::test
