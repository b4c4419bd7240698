// SPDX-License-Identifier: MIT
// Makes the Debian package from this build and checks it as Debian does.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/system/command.h"

namespace mocapress::test {
namespace {

namespace fs = std::filesystem;

class Package : public CommandLine {
 protected:
  static bool installed(const std::string& tool) {
    return std::system(("command -v " + tool + " > /dev/null").c_str()) == 0;
  }

  /// The test builds nothing: it is skipped if a program is missing.
  static bool everything_is_built() {
    const fs::path studio = fs::path(MOCAPRESS_BINARY_DIR) / "app/studio";
    return !fs::exists(studio) || fs::exists(studio / "mocapress-studio");
  }

  void SetUp() override {
    for (const char* tool : {"cpack", "dpkg-deb", "dpkg-shlibdeps", "file", "gzip", "lintian"})
      if (!installed(tool)) GTEST_SKIP() << "needs " << tool;
    if (!everything_is_built()) GTEST_SKIP() << "needs the studio";
    const Outcome made = run_program(
        {"cpack", "-G", "DEB", "--config", std::string(MOCAPRESS_BINARY_DIR) + "/CPackConfig.cmake",
         "-B", file("package").string(), "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=gzip"});
    ASSERT_EQ(made.exit_code, 0) << made.out << made.err;
    for (const auto& entry : fs::directory_iterator(file("package")))
      if (entry.path().extension() == ".deb") package_ = entry.path().string();
    ASSERT_FALSE(package_.empty()) << made.out;
  }

  std::string package_;
};

TEST_F(Package, PassesLintianWithoutErrors) {
  const Outcome judged = run_program({"lintian", "--fail-on", "error", package_});
  EXPECT_EQ(judged.exit_code, 0) << judged.out << judged.err;
  const std::string about = run_program({"dpkg-deb", "--field", package_}).out;
  EXPECT_NE(about.find("Maintainer: The Mocapress developers <"), std::string::npos) << about;
  const std::string files = run_program({"dpkg-deb", "--contents", package_}).out;
  for (const char* name :
       {"/usr/share/doc/mocapress/copyright", "/usr/share/doc/mocapress/changelog.Debian.gz",
        "/usr/share/man/man1/mocapress.1.gz", "/usr/share/mocapress/blender/mocapress-blender-",
        "/usr/share/doc/mocapress/runtime/README.md",
        "/usr/share/doc/mocapress/runtime/SAMPLING.md",
        "/usr/share/doc/mocapress/runtime/format/FORMAT.md"})
    EXPECT_NE(files.find(name), std::string::npos) << name;
  EXPECT_NE(files.find("/mocapress_runtime.h"), std::string::npos) << "what an engine takes";
  for (const char* name : {"/libmocapress.a", "/mocapress/mocapress.h", "/mocapress-config.cmake"})
    EXPECT_NE(files.find(name), std::string::npos) << name << " of the C++ library";
  if (fs::exists(fs::path(MOCAPRESS_BINARY_DIR) / "app/studio")) {
    for (const char* name : {"/usr/share/mime/packages/org.mocapress.Studio.mime.xml",
                             "/mimetypes/application-x-mocapress-clip.svg",
                             "/mimetypes/application-x-mocapress-bank.svg"})
      EXPECT_NE(files.find(name), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace mocapress::test
