// SPDX-License-Identifier: MIT
#include "core/formats/fbx_structure.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <string>

#include "core/base/error.h"

namespace mocapress::fbx_structure_test {
namespace {

template <typename T>
std::string bytes_of(T value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

/// A binary FBX of records without children.
struct SmallFbx {
  std::string bytes =
      std::string("Kaydara FBX Binary  \0\x1a\0", 23) + bytes_of(std::uint32_t{7400});

  void add(const std::string& name, std::uint32_t properties, const std::string& values) {
    const std::size_t end = bytes.size() + 13 + name.size() + values.size() + 13;
    bytes += bytes_of(static_cast<std::uint32_t>(end)) + bytes_of(properties) +
             bytes_of(static_cast<std::uint32_t>(values.size())) + static_cast<char>(name.size()) +
             name + values + std::string(13, '\0');
  }
  void connect(const std::string& kind, std::int64_t child, std::int64_t parent) {
    add("C", 3,
        "S" + bytes_of(static_cast<std::uint32_t>(kind.size())) + kind + "L" + bytes_of(child) +
            "L" + bytes_of(parent));
  }
  void add_array(std::uint32_t count) {
    add("Vertices", 1,
        "d" + bytes_of(count) + bytes_of(std::uint32_t{1}) + bytes_of(std::uint32_t{4}) + "abcd");
  }
};

std::string refusal(const std::string& bytes) {
  try {
    check_fbx_structure("small.fbx", bytes);
    return "may be read";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(FbxStructure, RefusesTwoObjectsThatAreConnectedTwice) {
  SmallFbx file;
  file.connect("OO", 2, 1);
  file.connect("OO", 3, 1);
  file.connect("OP", 2, 1);  // to a property of the same object
  EXPECT_EQ(refusal(file.bytes), "may be read");
  file.connect("OO", 2, 1);
  EXPECT_EQ(refusal(file.bytes), "small.fbx: connects the same two objects twice");
}

TEST(FbxStructure, RefusesThemInTextToo) {
  const std::string once = "Connections: {\nC: \"OO\",2,1\nC: \"OO\",3,1\n}\n";
  EXPECT_EQ(refusal(once), "may be read");
  EXPECT_EQ(refusal(once + once), "small.fbx: connects the same two objects twice");
}

TEST(FbxStructure, RefusesArraysThatInflateBeyondTheMemoryLimit) {
  SmallFbx file;
  for (int i = 0; i < 4; ++i) file.add_array(10'000'000);
  EXPECT_EQ(refusal(file.bytes), "may be read");
  for (int i = 0; i < 6; ++i) file.add_array(10'000'000);
  EXPECT_EQ(refusal(file.bytes),
            "small.fbx: takes some 2289 MiB of memory, but the limit (--memory) is 2048 MiB");
}

}  // namespace
}  // namespace mocapress::fbx_structure_test
