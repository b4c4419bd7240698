// SPDX-License-Identifier: MIT
// The kernels of pose_kernels.h with SSE2, NEON or WebAssembly. Two vectors of four make one of
// eight.
#include "core/runtime/pose/pose_kernels.h"
#include "core/runtime/processor/four.h"

#ifdef MOCAPRESS_FOUR
#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

#include "core/runtime/format/interpolation.h"
#include "core/runtime/pose/entry_sums.h"

namespace mocapress::runtime::four_poses_of {
namespace {

/// Masks with all bits set in the lanes whose bit in `bits` is set, for the lower and for the upper
/// half of a group.
inline Ints4 lower_lanes(unsigned bits) {
  alignas(16) static constexpr std::int32_t kLanes[4] = {1, 2, 4, 8};
  return has_all(Ints4::all(static_cast<int>(bits)), Ints4::load(kLanes));
}
inline Ints4 upper_lanes(unsigned bits) {
  return lower_lanes(bits >> 4);
}

inline Ints4 sign_of(Ints4 lanes) {
  return lanes & Ints4::all(std::numeric_limits<std::int32_t>::min());
}

struct Floats {
  Floats4 lower;
  Floats4 upper;

  static Floats all(float value) { return {Floats4::all(value), Floats4::all(value)}; }
  static Floats load(const float* from) { return {Floats4::load(from), Floats4::load(from + 4)}; }
  static Floats of_floats(const std::byte* from) {
    return load(reinterpret_cast<const float*>(from));
  }
  static Floats of_upper_halves(const std::byte* from) {
    const Words8 halves = Words8::load(from);
    return {floats_of(halves.unsigned_low() << 16), floats_of(halves.unsigned_high() << 16)};
  }
  void store(float* to) const {
    lower.store(to);
    upper.store(to + 4);
  }
  Floats only(unsigned bits) const {
    return {floats_of(bits_of(lower) & lower_lanes(bits)),
            floats_of(bits_of(upper) & upper_lanes(bits))};
  }
  Floats negated_where(unsigned bits) const {
    return {floats_of(bits_of(lower) ^ sign_of(lower_lanes(bits))),
            floats_of(bits_of(upper) ^ sign_of(upper_lanes(bits)))};
  }
  Floats but_where(unsigned bits, const Floats& other) const {
    return {floats_of(either(lower_lanes(bits), bits_of(lower), bits_of(other.lower))),
            floats_of(either(upper_lanes(bits), bits_of(upper), bits_of(other.upper)))};
  }
};

inline Floats operator+(const Floats& a, const Floats& b) {
  return {a.lower + b.lower, a.upper + b.upper};
}
inline Floats operator-(const Floats& a, const Floats& b) {
  return {a.lower - b.lower, a.upper - b.upper};
}
inline Floats operator*(const Floats& a, const Floats& b) {
  return {a.lower * b.lower, a.upper * b.upper};
}

struct Wholes {
  Ints4 lower;
  Ints4 upper;

  static Wholes all(std::int32_t value) { return {Ints4::all(value), Ints4::all(value)}; }
  static Wholes load(const std::int32_t* from) {
    return {Ints4::load(from), Ints4::load(from + 4)};
  }
  static Wholes of_words(const void* from) {
    const Words8 words = Words8::load(from);
    return {words.low(), words.high()};
  }
  static Wholes of_bytes(const void* from) {
    const Words8 words = Words8::of_bytes(from);
    return {words.unsigned_low(), words.unsigned_high()};
  }
  static Wholes of_twelve_bits(const std::byte* from) {
    const Words8 words = Words8::of_halves(from, from + 4);
    return {words.unsigned_low() << 20 >> 20, words.high() >> 4};
  }
  void store(std::int32_t* to) const {
    lower.store(to);
    upper.store(to + 4);
  }
  void store_words(std::int16_t* to) const { Words8::packed(lower, upper).store(to); }
  Wholes halved(int times) const { return {lower >> times, upper >> times}; }
  std::int32_t sum() const { return (lower + upper).sum(); }
  Floats to_floats() const { return {lower.to_floats(), upper.to_floats()}; }
};

inline Wholes operator+(const Wholes& a, const Wholes& b) {
  return {a.lower + b.lower, a.upper + b.upper};
}
inline Wholes operator<<(const Wholes& a, int bits) {
  return {a.lower << bits, a.upper << bits};
}

inline void place_entry_weights(const Wholes& whole, int first_row, int shift,
                                std::int32_t* of_entry) {
  std::int32_t weights[kGroup];
  whole.store(weights);
  place_weights(weights, first_row, shift, of_entry);
}

/// The weights of two rows as a pair of 16-bit numbers, repeated four times.
struct PairWeights {
  Words8 words;

  static PairWeights load(const std::int16_t* from) {
    std::int32_t both;
    std::memcpy(&both, from, sizeof both);
    return {Words8::of_pairs(Ints4::all(both))};
  }

  template <RowKind kKind>
  Wholes times(const std::byte* pair) const {
    if constexpr (kKind == RowKind::Nibbles) {
      const Words8 both = Words8::of_bytes(pair);
      return times(both.masked(15), both.shifted_down(4));
    } else if constexpr (kKind == RowKind::Bytes) {
      return {pair_products(Words8::of_signed_bytes(pair), words),
              pair_products(Words8::of_signed_bytes(pair + 8), words)};
    } else {
      return {pair_products(Words8::load(pair), words),
              pair_products(Words8::load(pair + 16), words)};
    }
  }
  Wholes times(Words8 first, Words8 second) const {
    return {low_products(first, second, words), high_products(first, second, words)};
  }
};

struct RowPair {
  Wholes first;
  Wholes second;
};

/// Unpacks two rows of a bundle, which keep the bias of bias_of(). A bundle of crumbs has four
/// rows: `bit` is the position of the first of the two.
template <RowKind kKind>
inline RowPair pair_of(const std::byte* bundle, int bit) {
  if constexpr (kKind == RowKind::Crumbs || kKind == RowKind::Nibbles) {
    constexpr int kBits = kKind == RowKind::Crumbs ? 2 : 4;
    constexpr std::int16_t kMask = (1 << kBits) - 1;
    const Words8 bits = Words8::of_bytes(bundle).shifted_down(bit);
    const Words8 first = bits.masked(kMask);
    const Words8 second = bits.shifted_down(kBits).masked(kMask);
    return {{first.unsigned_low(), first.unsigned_high()},
            {second.unsigned_low(), second.unsigned_high()}};
  } else {
    constexpr bool kBytes = kKind == RowKind::Bytes;
    const Ints4 lower = (kBytes ? Words8::of_signed_bytes(bundle) : Words8::load(bundle)).pairs();
    const Ints4 upper =
        (kBytes ? Words8::of_signed_bytes(bundle + 8) : Words8::load(bundle + 16)).pairs();
    return {{lower << 16 >> 16, upper << 16 >> 16}, {lower >> 16, upper >> 16}};
  }
}

inline Wholes bits_less(const Floats& floats, std::uint32_t less) {
  const Ints4 by = Ints4::all(static_cast<std::int32_t>(less));
  return {bits_of(floats.lower) - by, bits_of(floats.upper) - by};
}

inline Wholes times_crumbs(const std::byte* rows, const std::int16_t* weights) {
  const Words8 four = Words8::of_bytes(rows);
  return PairWeights::load(weights).times(four.masked(3), four.shifted_down(2).masked(3)) +
         PairWeights::load(weights + 2).times(four.shifted_down(4).masked(3), four.shifted_down(6));
}

struct Quadrants {
  Ints4 lower;
  Ints4 upper;

  explicit Quadrants(const Floats& quarters)
      : lower(bits_of(quarters.lower)), upper(bits_of(quarters.upper)) {}
  Floats sine(const Floats& s, const Floats& c) const {
    return {sine_of(lower, s.lower, c.lower), sine_of(upper, s.upper, c.upper)};
  }
  Floats cosine(const Floats& s, const Floats& c) const {
    const Ints4 one = Ints4::all(1);
    return {sine_of(lower + one, s.lower, c.lower), sine_of(upper + one, s.upper, c.upper)};
  }

 private:
  static Floats4 sine_of(Ints4 quarters, Floats4 s, Floats4 c) {
    const Ints4 odd = quarters << 31 >> 31;
    return floats_of(either(odd, bits_of(s), bits_of(c)) ^ sign_of(quarters << 30));
  }
};

inline void add_run(const EntryRun& run, const std::int32_t* weights, std::int32_t* sums) {
  add_one_by_one(run, weights, sums);
}

inline void put_quaternions(const std::uint16_t* places, int joints, const Floats& w,
                            const Floats& x, const Floats& y, const Floats& z, float* out) {
  Floats4 quaternions[kGroup] = {w.lower, x.lower, y.lower, z.lower,
                                 w.upper, x.upper, y.upper, z.upper};
  transpose(quaternions[0], quaternions[1], quaternions[2], quaternions[3]);
  transpose(quaternions[4], quaternions[5], quaternions[6], quaternions[7]);
  for (int i = 0; i < joints; ++i) quaternions[i].store(out + 8 * places[i]);
}

}  // namespace
}  // namespace mocapress::runtime::four_poses_of

#define MOCAPRESS_POSES four_poses_of
#define MOCAPRESS_POSES_TARGET
#define MOCAPRESS_POSES_INLINE MOCAPRESS_ALWAYS_INLINE
#include "core/runtime/pose/pose_kernels_of.inc"

namespace mocapress::runtime {

const PoseKernels kFourPoses = {.set_band = four_poses_of::set_band,
                                .sum_entries = four_poses_of::sum_entries,
                                .make_columns = four_poses_of::make_columns,
                                .blend = four_poses_of::blend,
                                .lift = four_poses_of::lift,
                                .turn = four_poses_of::turn,
                                .turn_into = four_poses_of::turn_into};

}  // namespace mocapress::runtime

#endif
