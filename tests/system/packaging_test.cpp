// SPDX-License-Identifier: MIT
// What desktops read about the studio, by the tools that judge it where they are installed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
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
  EXPECT_NE(entry.find("\nExec=mocapress-studio "), std::string::npos);
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

}  // namespace
}  // namespace mocapress
