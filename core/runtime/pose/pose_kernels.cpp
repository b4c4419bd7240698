// SPDX-License-Identifier: MIT
#include "core/runtime/pose/pose_kernels.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/runtime/format/bit_pattern.h"
#include "core/runtime/format/interpolation.h"
#include "core/runtime/pose/entry_sums.h"
#include "core/runtime/processor/path.h"

namespace mocapress::runtime::plain_poses {
namespace {

template <typename T>
T read_as(const std::byte* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

struct Floats {
  float lane[kGroup];

  static Floats all(float value) {
    Floats out;
    for (float& lane : out.lane) lane = value;
    return out;
  }
  static Floats load(const float* from) {
    Floats out;
    std::memcpy(out.lane, from, sizeof out.lane);
    return out;
  }
  static Floats of_floats(const std::byte* from) {
    Floats out;
    std::memcpy(out.lane, from, sizeof out.lane);
    return out;
  }
  static Floats of_upper_halves(const std::byte* from) {
    Floats out;
    for (int i = 0; i < kGroup; ++i)
      out.lane[i] = from_upper_half(read_as<std::uint16_t>(from + 2 * i));
    return out;
  }
  void store(float* to) const { std::memcpy(to, lane, sizeof lane); }

  /// Sets the lanes to zero whose bit in `bits` is not set.
  Floats only(unsigned bits) const {
    Floats out;
    for (int i = 0; i < kGroup; ++i) out.lane[i] = (bits >> i & 1) != 0 ? lane[i] : 0.0F;
    return out;
  }
  Floats negated_where(unsigned bits) const {
    Floats out;
    for (int i = 0; i < kGroup; ++i) out.lane[i] = (bits >> i & 1) != 0 ? -lane[i] : lane[i];
    return out;
  }
  Floats but_where(unsigned bits, const Floats& other) const {
    Floats out;
    for (int i = 0; i < kGroup; ++i) out.lane[i] = (bits >> i & 1) != 0 ? other.lane[i] : lane[i];
    return out;
  }
};

#define MOCAPRESS_LANE_BY_LANE(sign)                                         \
  inline Floats operator sign(const Floats& a, const Floats& b) {            \
    Floats out;                                                              \
    for (int i = 0; i < kGroup; ++i) out.lane[i] = a.lane[i] sign b.lane[i]; \
    return out;                                                              \
  }
MOCAPRESS_LANE_BY_LANE(+)
MOCAPRESS_LANE_BY_LANE(-)
MOCAPRESS_LANE_BY_LANE(*)
#undef MOCAPRESS_LANE_BY_LANE

/// Integers with wrap-around arithmetic.
struct Wholes {
  std::uint32_t lane[kGroup];

  static Wholes all(std::int32_t value) {
    Wholes out;
    for (std::uint32_t& lane : out.lane) lane = static_cast<std::uint32_t>(value);
    return out;
  }
  static Wholes load(const std::int32_t* from) {
    Wholes out;
    std::memcpy(out.lane, from, sizeof out.lane);
    return out;
  }
  template <typename T>
  static Wholes of(const void* from) {
    Wholes out;
    for (int i = 0; i < kGroup; ++i)
      out.lane[i] = static_cast<std::uint32_t>(
          std::int32_t{read_as<T>(static_cast<const std::byte*>(from) + sizeof(T) * i)});
    return out;
  }
  static Wholes of_words(const void* from) { return of<std::int16_t>(from); }
  static Wholes of_bytes(const void* from) { return of<std::uint8_t>(from); }
  static Wholes of_twelve_bits(const std::byte* from) {
    Wholes out;
    for (int i = 0; i < kGroup / 2; ++i) {
      const auto bytes = [&](int k) { return std::to_integer<std::uint32_t>(from[i + 4 * k]); };
      out.lane[i] = bytes(1) << 28 | bytes(0) << 20;
      out.lane[i + kGroup / 2] = bytes(2) << 24 | (bytes(1) & 0xF0) << 16;
    }
    return out.halved(20);
  }
  void store(std::int32_t* to) const { std::memcpy(to, lane, sizeof lane); }
  void store_words(std::int16_t* to) const {
    for (int i = 0; i < kGroup; ++i)
      to[i] = static_cast<std::int16_t>(static_cast<std::int32_t>(lane[i]));
  }
  Wholes halved(int times) const {
    Wholes out;
    for (int i = 0; i < kGroup; ++i)
      out.lane[i] = static_cast<std::uint32_t>(static_cast<std::int32_t>(lane[i]) >> times);
    return out;
  }
  std::int32_t sum() const {
    std::uint32_t sum = 0;
    for (const std::uint32_t value : lane) sum += value;
    return static_cast<std::int32_t>(sum);
  }
  Floats to_floats() const {
    Floats out;
    for (int i = 0; i < kGroup; ++i)
      out.lane[i] = static_cast<float>(static_cast<std::int32_t>(lane[i]));
    return out;
  }
};
inline Wholes operator+(const Wholes& a, const Wholes& b) {
  Wholes out;
  for (int i = 0; i < kGroup; ++i) out.lane[i] = a.lane[i] + b.lane[i];
  return out;
}
inline Wholes operator<<(const Wholes& a, int bits) {
  Wholes out;
  for (int i = 0; i < kGroup; ++i) out.lane[i] = a.lane[i] << bits;
  return out;
}

void place_entry_weights(const Wholes& whole, int first_row, int shift, std::int32_t* of_entry) {
  std::int32_t weights[kGroup];
  whole.store(weights);
  place_weights(weights, first_row, shift, of_entry);
}

struct PairWeights {
  std::int32_t first;
  std::int32_t second;

  static PairWeights load(const std::int16_t* from) { return {from[0], from[1]}; }

  template <RowKind kKind>
  Wholes times(const std::byte* pair) const {
    Wholes out;
    for (int i = 0; i < kGroup; ++i) {
      std::int32_t a;
      std::int32_t b;
      if constexpr (kKind == RowKind::Nibbles) {
        const auto both = std::to_integer<std::int32_t>(pair[i]);
        a = both & 15;
        b = both >> 4;
      } else if constexpr (kKind == RowKind::Bytes) {
        a = read_as<std::int8_t>(pair + 2 * i);
        b = read_as<std::int8_t>(pair + 2 * i + 1);
      } else {
        a = read_as<std::int16_t>(pair + 4 * i);
        b = read_as<std::int16_t>(pair + 4 * i + 2);
      }
      out.lane[i] = static_cast<std::uint32_t>(a * first) + static_cast<std::uint32_t>(b * second);
    }
    return out;
  }
};

struct RowPair {
  Wholes first;
  Wholes second;
};

/// Unpacks two rows of a bundle, which keep the bias of bias_of(). A bundle of crumbs has four
/// rows: `bit` is the position of the first of the two.
template <RowKind kKind>
RowPair pair_of(const std::byte* bundle, int bit) {
  RowPair out;
  for (int i = 0; i < kGroup; ++i) {
    std::int32_t first;
    std::int32_t second;
    if constexpr (kKind == RowKind::Crumbs || kKind == RowKind::Nibbles) {
      constexpr int kBits = kKind == RowKind::Crumbs ? 2 : 4;
      constexpr std::int32_t kMask = (1 << kBits) - 1;
      const std::int32_t bits = std::to_integer<std::int32_t>(bundle[i]) >> bit;
      first = bits & kMask;
      second = bits >> kBits & kMask;
    } else if constexpr (kKind == RowKind::Bytes) {
      first = read_as<std::int8_t>(bundle + 2 * i);
      second = read_as<std::int8_t>(bundle + 2 * i + 1);
    } else {
      first = read_as<std::int16_t>(bundle + 4 * i);
      second = read_as<std::int16_t>(bundle + 4 * i + 2);
    }
    out.first.lane[i] = static_cast<std::uint32_t>(first);
    out.second.lane[i] = static_cast<std::uint32_t>(second);
  }
  return out;
}

/// The bit patterns of floats, as integers, minus `less`.
Wholes bits_less(const Floats& floats, std::uint32_t less) {
  Wholes out;
  for (int i = 0; i < kGroup; ++i) out.lane[i] = bit_pattern<std::uint32_t>(floats.lane[i]) - less;
  return out;
}

/// Multiplies a bundle of four rows of crumbs by the rows' weights, and adds the products.
Wholes times_crumbs(const std::byte* rows, const std::int16_t* weights) {
  Wholes out;
  for (int i = 0; i < kGroup; ++i) {
    const auto four = std::to_integer<std::int32_t>(rows[i]);
    std::int32_t sum = 0;
    for (int k = 0; k < 4; ++k) sum += (four >> (2 * k) & 3) * weights[k];
    out.lane[i] = static_cast<std::uint32_t>(sum);
  }
  return out;
}

/// Quadrants of eight angles, from the lowest bits of a float that counts quarter turns.
struct Quadrants {
  std::uint32_t lane[kGroup];

  explicit Quadrants(const Floats& quarters) { std::memcpy(lane, quarters.lane, sizeof lane); }
  Floats sine(const Floats& s, const Floats& c) const {
    Floats out;
    for (int i = 0; i < kGroup; ++i) {
      const float value = (lane[i] & 1) != 0 ? c.lane[i] : s.lane[i];
      out.lane[i] = (lane[i] & 2) != 0 ? -value : value;
    }
    return out;
  }
  Floats cosine(const Floats& s, const Floats& c) const {
    Floats out;
    for (int i = 0; i < kGroup; ++i) {
      const float value = (lane[i] & 1) != 0 ? s.lane[i] : c.lane[i];
      out.lane[i] = ((lane[i] + 1) & 2) != 0 ? -value : value;
    }
    return out;
  }
};

void add_run(const EntryRun& run, const std::int32_t* weights, std::int32_t* sums) {
  add_one_by_one(run, weights, sums);
}

void put_quaternions(const std::uint16_t* places, int joints, const Floats& w, const Floats& x,
                     const Floats& y, const Floats& z, float* out) {
  for (int i = 0; i < joints; ++i) {
    float* const to = out + 8 * places[i];
    to[0] = w.lane[i];
    to[1] = x.lane[i];
    to[2] = y.lane[i];
    to[3] = z.lane[i];
  }
}

}  // namespace
}  // namespace mocapress::runtime::plain_poses

#define MOCAPRESS_POSES plain_poses
#define MOCAPRESS_POSES_TARGET
#define MOCAPRESS_POSES_INLINE inline
#include "core/runtime/pose/pose_kernels_of.inc"

namespace mocapress::runtime {

const PoseKernels kPlainPoses = {.set_band = plain_poses::set_band,
                                 .sum_entries = plain_poses::sum_entries,
                                 .make_columns = plain_poses::make_columns,
                                 .blend = plain_poses::blend,
                                 .lift = plain_poses::lift,
                                 .turn = plain_poses::turn,
                                 .turn_into = plain_poses::turn_into};

const PoseKernels* poses_of(mcpr_path path) {
  switch (kernels_of(path)) {
    case Kernels::None:
      break;
    case Kernels::Plain:
      return &kPlainPoses;
    case Kernels::Four:
#ifdef MOCAPRESS_FOUR
      return &kFourPoses;
#else
      break;
#endif
    case Kernels::Avx2:
#ifdef MOCAPRESS_HAS_AVX2
      return &kAvx2Poses;
#else
      break;
#endif
  }
  return nullptr;
}

}  // namespace mocapress::runtime
