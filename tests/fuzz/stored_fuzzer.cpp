// SPDX-License-Identifier: MIT
// Reads any bytes as a file on disk, or sees them refused. The first byte chooses the kind of file.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/bank/bank_file.h"
#include "core/base/error.h"
#include "core/batch/journal.h"
#include "core/formats/gltf_reader.h"
#include "core/formats/gltf_writer.h"
#include "tests/fuzz/mended_bank.h"

namespace {

using namespace mocapress;
namespace fs = std::filesystem;

/// The file of a run, removed at its end.
class StoredFile {
 public:
  StoredFile(const std::byte* bytes, std::size_t size, const char* extension)
      : path_(fs::temp_directory_path() /
              ("mocapress-fuzz-" + std::to_string(getpid()) + extension)) {
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  }
  StoredFile(const StoredFile&) = delete;
  StoredFile& operator=(const StoredFile&) = delete;
  ~StoredFile() { fs::remove(path_); }

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void read_bank(const std::byte* bytes, std::size_t size) {
  const test::MendedBank mended(reinterpret_cast<const std::uint8_t*>(bytes), size);
  const StoredFile file(mended.data(), size, ".mcpk");
  const BankFile bank(file.path());
  bank.texts();
  for (std::uint32_t clip = 0; clip < std::min(bank.clips(), 20U); ++clip) {
    const BankClip described = bank.describe(clip);
    if (bank.find(described.name) >= bank.clips()) std::abort();
    bank.tags(bank.entry(clip));
    if (bank.is_cooked())
      bank.cooked(bank.entry(clip));
    else
      bank.extract(bank.entry(clip));
    bank.play(clip);
  }
}

void read_journal(const std::byte* bytes, std::size_t size) {
  const StoredFile file(bytes, size, ".jsonl");
  const JournalReader journal(file.path());
  std::size_t rows = 0;
  journal.for_each([&](const BatchRow&) { ++rows; });
  if (rows > journal.rows()) std::abort();
}

/// Writes a glTF's motion onto the glTF itself.
void write_onto(const std::byte* bytes, std::size_t size) {
  const StoredFile file(bytes, size, ".gltf");
  const MotionFile clip =
      read_gltf(file.path().string(), std::string_view(reinterpret_cast<const char*>(bytes), size));
  if (clip.motion.clip.frames() > 1000) return;
  const std::string written =
      gltf_bytes_onto(file.path(), clip.motion, GltfContainer::Glb, file.path().parent_path(),
                      clip.source, {}, clip.tracks);
  read_gltf("again.glb", written);
}

constexpr void (*kStoredKinds[])(const std::byte*, std::size_t) = {read_bank, read_journal,
                                                                   write_onto};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  try {
    kStoredKinds[*data % std::size(kStoredKinds)](reinterpret_cast<const std::byte*>(data) + 1,
                                                  size - 1);
  } catch (const Error&) {
    return 0;
  }
  return 0;
}
