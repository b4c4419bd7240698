// SPDX-License-Identifier: MIT
// Checks the studio's desktop files with the desktops' own tools, if these are installed.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

namespace mocapress {
namespace {

const std::filesystem::path kFolder =
    std::filesystem::path(MOCAPRESS_SOURCE_DIR) / "resources/desktop";

std::string text(const char* name) {
  std::ifstream file(kFolder / name);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool installed(const std::string& tool) {
  return std::system(("command -v " + tool + " > /dev/null").c_str()) == 0;
}

int judge(const std::string& command, const char* name) {
  return std::system((command + " '" + (kFolder / name).string() + "' > /dev/null").c_str());
}

/// Reads the commands that compile and link a release build from Ninja, without building.
TEST(Packaging, ReleaseBuildsAreHardened) {
  if (!installed("ninja") || !installed("cmake")) GTEST_SKIP() << "needs cmake and ninja";
  const std::filesystem::path build =
      std::filesystem::path(testing::TempDir()) / ("release-" + std::to_string(getpid()));
  const std::string quoted = "'" + build.string() + "'";
  ASSERT_EQ(std::system(("cmake -S '" MOCAPRESS_SOURCE_DIR "' -G Ninja -DCMAKE_BUILD_TYPE=Release "
                         "-DMOCAPRESS_GUI=OFF -DMOCAPRESS_TESTS=OFF -B " +
                         quoted + " > /dev/null && ninja -C " + quoted +
                         " -t commands mocapress > " + quoted + "/commands")
                            .c_str()),
            0);
  std::ifstream file(build / "commands");
  int compiled = 0;
  std::string command;
  while (std::getline(file, command)) {
    if (command.find(" -c ") != command.npos && command.find(".cxx") != command.npos) {
      EXPECT_NE(command.find(" -fstack-protector-strong "), command.npos) << command;
      EXPECT_NE(command.find(" -D_FORTIFY_SOURCE=2 "), command.npos) << command;
      ++compiled;
    }
  }
  EXPECT_GT(compiled, 10);
  std::filesystem::remove_all(build);
}

TEST(Packaging, TheBillOfMaterialsNamesEveryLibraryWithItsVersion) {
  std::ifstream file(MOCAPRESS_BINARY_DIR "/sbom.cdx.json");
  const auto bill = nlohmann::json::parse(file);
  EXPECT_EQ(bill.at("bomFormat"), "CycloneDX");
  std::map<std::string, std::string> versions;
  for (const auto& component : bill.at("components"))
    versions[component.at("name")] = component.at("version");
  for (const char* name : {"Eigen3", "ZLIB", "TBB", "nlohmann_json", "CLI11"})
    EXPECT_NE(versions[name], "") << name;
}

TEST(Packaging, ProgramsBindTheirLibrariesAtTheStart) {
  if (!installed("readelf")) GTEST_SKIP() << "needs binutils";
  const std::string program = MOCAPRESS_EXECUTABLE;
  EXPECT_EQ(std::system(("readelf -d '" + program + "' | grep -q 'BIND_NOW\\|NOW PIE'").c_str()),
            0);
  EXPECT_EQ(std::system(("readelf -l '" + program + "' | grep -q GNU_RELRO").c_str()), 0);
  EXPECT_EQ(std::system(("readelf -h '" + program + "' | grep -q 'DYN '").c_str()), 0);
}

TEST(Packaging, TheDesktopEntryIsValid) {
  if (!installed("desktop-file-validate")) GTEST_SKIP() << "needs desktop-file-utils";
  EXPECT_EQ(judge("desktop-file-validate", "org.mocapress.Studio.desktop"), 0);
}

TEST(Packaging, TheAppStreamMetadataIsValid) {
  if (!installed("appstreamcli")) GTEST_SKIP() << "needs appstream";
  EXPECT_EQ(judge("appstreamcli validate --no-net", "org.mocapress.Studio.metainfo.xml"), 0);
}

TEST(Packaging, TheManPageHasNoMistakes) {
  if (!installed("groff")) GTEST_SKIP() << "needs groff";
  const std::string page = (kFolder / "mocapress-studio.1").string();
  EXPECT_EQ(std::system(("test -z \"$(groff -man -Tutf8 -wall -z '" + page + "' 2>&1)\"").c_str()),
            0);
}

TEST(Packaging, TheManPageHasEveryOption) {
  std::ifstream file(std::filesystem::path(MOCAPRESS_SOURCE_DIR) /
                     "app/studio/window/launch_options.cpp");
  const std::string source(std::istreambuf_iterator<char>(file), {});
  const std::string page = text("mocapress-studio.1");
  const std::regex option("QCommandLineOption \\w+\\(\\s*QStringLiteral\\(\"([a-z-]+)\"\\)");
  int options = 0;
  for (std::sregex_iterator it(source.begin(), source.end(), option), end; it != end; ++it) {
    EXPECT_NE(page.find("\\-\\-" + (*it)[1].str()), std::string::npos) << (*it)[1];
    ++options;
  }
  EXPECT_GE(options, 4);
}

TEST(Packaging, NamesAreTheSameEverywhere) {
  const std::string entry = text("org.mocapress.Studio.desktop");
  EXPECT_NE(entry.find("\nIcon=org.mocapress.Studio\n"), std::string::npos);
  EXPECT_NE(entry.find("\nExec=mocapress-studio %U\n"), std::string::npos) << "links are no files";
  EXPECT_NE(entry.find("x-scheme-handler/mocapress;"), std::string::npos);
  const std::string metadata = text("org.mocapress.Studio.metainfo.xml");
  EXPECT_NE(metadata.find("<binary>mocapress-studio</binary>"), std::string::npos);
  EXPECT_NE(metadata.find(">org.mocapress.Studio.desktop<"), std::string::npos);
  EXPECT_NE(text("CMakeLists.txt").find("RENAME org.mocapress.Studio.svg"), std::string::npos);
}

TEST(Packaging, DesktopsKnowEveryKindOfFileThatIsOurs) {
  const std::string types = text("org.mocapress.Studio.mime.xml");
  for (const auto& [type, pattern] : {std::pair("project", "mocapress"), {"clip", "mcpr"}}) {
    const std::string name = std::string("application/x-mocapress-") + type;
    EXPECT_NE(types.find('"' + name + '"'), std::string::npos) << name;
    EXPECT_NE(types.find("\"*." + std::string(pattern) + '"'), std::string::npos) << pattern;
    EXPECT_NE(text("org.mocapress.Studio.desktop").find(name + ';'), std::string::npos) << name;
    EXPECT_NE(text("org.mocapress.Studio.metainfo.xml").find('>' + name + '<'), std::string::npos)
        << name;
  }
}

TEST(Packaging, ClipsAndBanksHaveATypeAndAnIcon) {
  const std::string types = text("org.mocapress.Studio.mime.xml");
  const std::string installed_files = text("CMakeLists.txt");
  for (const auto& [type, pattern] : {std::pair("clip", "mcpr"), {"bank", "mcpk"}}) {
    const std::string name = std::string("x-mocapress-") + type;
    EXPECT_NE(types.find("\"application/" + name + '"'), std::string::npos) << name;
    EXPECT_NE(types.find("\"*." + std::string(pattern) + '"'), std::string::npos) << pattern;
    const std::string icon = "application-" + name + ".svg";
    EXPECT_NE(installed_files.find(icon), std::string::npos) << icon;
    EXPECT_EQ(text(icon.c_str()).rfind("<svg ", 0), 0U) << icon;
  }
}

}  // namespace
}  // namespace mocapress
