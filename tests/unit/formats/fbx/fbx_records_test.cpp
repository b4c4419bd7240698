// SPDX-License-Identifier: MIT
#include "core/formats/fbx/fbx_records.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <string>

#include "core/base/error.h"

namespace mocapress::fbx_records_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Writes a binary file by hand.
class Writer {
 public:
  Writer(std::uint32_t version, bool big_endian) : wide_(version >= 7500), big_(big_endian) {
    bytes = std::string("Kaydara FBX Binary  \0\x1a", 22);
    bytes += static_cast<char>(big_endian);
    add(version);
  }
  template <typename Number>
  std::string raw(Number number) const {
    std::string text(reinterpret_cast<const char*>(&number), sizeof number);
    if (big_) std::reverse(text.begin(), text.end());
    return text;
  }
  template <typename Number>
  void add(Number number) {
    bytes += raw(number);
  }
  void field(std::size_t value) {
    if (wide_)
      add(std::uint64_t{value});
    else
      add(static_cast<std::uint32_t>(value));
  }
  /// A record of values alone.
  void record(const std::string& name, std::size_t count, const std::string& values) {
    field(bytes.size() + (wide_ ? 25 : 13) + name.size() + values.size());
    field(count);
    field(values.size());
    bytes += static_cast<char>(name.size());
    bytes += name + values;
  }
  void end() { bytes.append(wide_ ? 25 : 13, '\0'); }

  std::string array(char type, std::uint32_t count, const std::string& elements, bool packed) {
    std::string coded = elements;
    if (packed) {
      uLongf size = compressBound(static_cast<uLong>(elements.size()));
      coded.resize(size);
      compress(reinterpret_cast<Bytef*>(coded.data()), &size,
               reinterpret_cast<const Bytef*>(elements.data()),
               static_cast<uLong>(elements.size()));
      coded.resize(size);
    }
    return type + raw(count) + raw(std::uint32_t{packed}) +
           raw(static_cast<std::uint32_t>(coded.size())) + coded;
  }

  std::string bytes;

 private:
  bool wide_;
  bool big_;
};

std::string sample(std::uint32_t version, bool big_endian) {
  Writer writer(version, big_endian);
  writer.record("Mixed", 4,
                'L' + writer.raw(std::int64_t{-5}) + 'D' + writer.raw(2.5) + 'Y' +
                    writer.raw(std::int16_t{-7}) + 'S' + writer.raw(std::uint32_t{2}) + "hi");
  std::string elements;
  for (const float value : {1.5F, -2.0F, 3.0F}) elements += writer.raw(value);
  writer.record("Packed", 1, writer.array('f', 3, elements, true));
  writer.record("Plain", 1, writer.array('f', 3, elements, false));
  writer.end();
  return writer.bytes;
}

std::string error_of(const std::string& bytes) {
  try {
    FbxRecords records("f", bytes);
    for (const FbxRecord* record = records.first_child(records.top()); record != nullptr;
         record = records.next(*record))
      records.numbers(*record);
  } catch (const InputError& error) {
    return error.what();
  }
  return "read";
}

TEST(FbxRecords, ReadsBothWidthsAndByteOrders) {
  for (const std::uint32_t version : {7400U, 7500U})
    for (const bool big_endian : {false, true}) {
      const std::string bytes = sample(version, big_endian);
      FbxRecords records("f", bytes);
      EXPECT_EQ(records.version(), static_cast<int>(version));
      const FbxRecord* const mixed = records.find(records.top(), "Mixed");
      ASSERT_NE(mixed, nullptr);
      const std::vector<FbxValue> values = records.values(*mixed);
      ASSERT_EQ(values.size(), 4u);
      EXPECT_EQ(values[0].integer, -5);
      EXPECT_EQ(values[1].real, 2.5);
      EXPECT_EQ(values[2].integer, -7);
      EXPECT_EQ(values[3].text, "hi");
      EXPECT_THAT(records.numbers(records.top(), "Packed"), ElementsAre(1.5, -2, 3));
      EXPECT_THAT(records.numbers(records.top(), "Plain"), ElementsAre(1.5, -2, 3));
    }
}

TEST(FbxRecords, RefusesEveryTruncation) {
  const std::string bytes = sample(7400, false);
  EXPECT_EQ(error_of(bytes), "read");
  for (std::size_t size = 1; size < bytes.size(); ++size) {
    const std::string error = error_of(bytes.substr(0, size));
    EXPECT_NE(error, "read") << size;
    EXPECT_LE(error.size(), 200u);
  }
}

TEST(FbxRecords, RefusesAnArrayThatSaysMoreThanItsBytesCanHold) {
  Writer writer(7400, false);
  writer.record("Bomb", 1, writer.array('d', 100'000'000, "x", true));
  writer.end();
  EXPECT_THAT(error_of(writer.bytes), HasSubstr("an array states more values than its bytes can"));
}

TEST(FbxRecords, NamesTheByteOrTheLine) {
  Writer writer(7400, false);
  writer.record("Odd", 1, "?");
  EXPECT_EQ(error_of(writer.bytes), "f: has a value of an unknown type (byte 43)");
  EXPECT_EQ(error_of("; FBX\nFBXVersion: 1\n}\n"), "f: closes a record that is not open (line 3)");
  EXPECT_EQ(error_of("; FBX\nA: {\nB: \"never"), "f: ends within a text (line 3)");
}

TEST(FbxRecords, ReadsTextWithLettersListsAndComments) {
  const std::string text =
      "; FBX 7.4.0\nFBXHeaderExtension:  {\n\tFBXVersion: 7400\n}\nKey: 1,2.5,U,s,\n"
      "\t\"a:{};\" ; but not this\nList: *3 {\n a: 1,2,\n3\n}\n";
  FbxRecords records("f", text);
  EXPECT_EQ(records.version(), 7400);
  const std::vector<FbxValue> values = records.values(*records.find(records.top(), "Key"));
  ASSERT_EQ(values.size(), 5u);
  EXPECT_EQ(values[2].letter(), 'U');
  EXPECT_EQ(values[4].text, "a:{};");
  EXPECT_THAT(records.integers(records.top(), "List"), ElementsAre(1, 2, 3));
}

}  // namespace
}  // namespace mocapress::fbx_records_test
