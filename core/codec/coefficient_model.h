// SPDX-License-Identifier: MIT
// What the adaptive coding expects of a coefficient, from those coded before it. FORMAT.md, MOTN.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <vector>

#include "core/codec/adaptive.h"
#include "core/codec/mixed_bit.h"

namespace mocapress {

inline int bucket(int v) {
  constexpr std::array<int, 16> k = {0, 1, 2, 3, 4, 5, 5, 6, 6, 6, 7, 7, 7, 7, 7, 8};
  return v < 16 ? k[static_cast<std::size_t>(v)] : v < 32 ? 8 : 9;
}

inline int width(int v) {
  return static_cast<int>(std::bit_width(static_cast<unsigned>(v)));
}

inline constexpr int kLevels = 8;
inline constexpr int kB = 10;

struct ModelTables {
  std::vector<AdaptiveBit> slots;
  std::vector<MixingWeights> weights;
};

/// Walks through all coefficients in the order of the file. `Bits` either codes what `values` hold
/// or fills them: bool code(bool bit, Probability).
template <typename Bits>
class CoefficientCoder {
 public:
  CoefficientCoder(Bits& bits, const std::vector<SignalKin>& kin, const std::vector<Band>& bands,
                   QuantisedSignals& coded)
      : bits_(bits), kin_(kin), bands_(bands), coded_(coded) {
    signals_ = static_cast<int>(kin.size());
    int at = 0;
    const auto room = [&](int n) {
      const int here = at;
      at += n;
      return here;
    };
    z_[0] = room(kLevels * kB * kB);
    z_[1] = room(kLevels * kB * kB * 4);
    z_[2] = room(12 * kB * kB);
    z_[3] = room(kLevels * signals_);
    z_[4] = room(12 * 12 * 4);
    z_[5] = room(kB * kB * kB);
    const int kM = 6;
    m_[0] = room(kM * kLevels * kB);
    m_[1] = room(kM * kB * kB);
    m_[2] = room(kM * 12 * 4);
    m_[3] = room(kM * signals_);
    m_[4] = room(kM * 12 * 12);
    s_[0] = room(27 * kLevels);
    s_[1] = room(27 * 3);
    f_[0] = room(kLevels * 24);
    f_[1] = room(32 * 24);
    f_[2] = room(kLevels * 8 * 12);
    e_ = room(64 * 64);
    model_.slots.resize(static_cast<std::size_t>(at));
    for (std::size_t k = static_cast<std::size_t>(z_[3]); k < static_cast<std::size_t>(z_[4]); ++k)
      model_.slots[k] = {6000, 1};
    model_.weights.resize(64);
    for (MixingWeights& w : model_.weights) w.of.fill(65536 * 3 / 10);
  }

  void run();
  ModelTables& tables() { return model_; }

 private:
  bool mixed(bool bit, std::initializer_list<int> contexts, int weights) {
    std::array<AdaptiveBit*, MixingWeights::kMost> slots;
    std::size_t n = 0;
    for (const int c : contexts) slots[n++] = &model_.slots[static_cast<std::size_t>(c)];
    MixedBit prediction(std::span<AdaptiveBit* const>(slots.data(), n),
                        model_.weights[static_cast<std::size_t>(weights)]);
    bit = bits_.code(bit, prediction.one());
    prediction.follow(bit);
    return bit;
  }
  bool single(bool bit, int context) {
    AdaptiveBit& slot = model_.slots[static_cast<std::size_t>(context)];
    bit = bits_.code(bit, std::clamp<Probability>(slot.one, 64, 65536 - 64));
    slot.follow(bit);
    return bit;
  }
  /// Exp-Golomb with an adaptive prefix.
  int number(int v, int context) {
    const auto u = static_cast<unsigned>(v) + 1;
    int digits = width(v + 1) - 1;
    int n = 0;
    while (single(n < digits, e_ + context * 32 + std::min(n, 31))) {
      if (++n > 30) bits_.fail();
    }
    unsigned r = 1;
    for (int d = n - 1; d >= 0; --d) {
      const bool b = (u >> d & 1) != 0;
      r = r << 1 | unsigned(d == n - 1 && n < 12 ? single(b, e_ + (32 + context) * 32 + n)
                                                 : bits_.code(b, kEvenOdds));
    }
    return static_cast<int>(r - 1);
  }
  int signed_number(int v, int context) {
    const int u = number(v > 0 ? 2 * v - 1 : -2 * v, context);
    return u % 2 != 0 ? (u + 1) / 2 : -u / 2;
  }

  void code_coarse(int signal);
  void code_band(int b, int signal);

  Bits& bits_;
  const std::vector<SignalKin>& kin_;
  const std::vector<Band>& bands_;
  QuantisedSignals& coded_;
  int signals_;
  ModelTables model_;
  std::array<int, 6> z_{};
  std::array<int, 5> m_{};
  std::array<int, 2> s_{};
  std::array<int, 3> f_{};
  int e_ = 0;
  std::vector<int> activity_;          // of one band: sum over the signals coded so far
  std::vector<std::vector<int>> sum_;  // [band][signal]: magnitudes
};

template <typename Bits>
void CoefficientCoder<Bits>::run() {
  const auto bands = static_cast<int>(bands_.size());
  sum_.assign(static_cast<std::size_t>(bands),
              std::vector<int>(static_cast<std::size_t>(signals_), 0));
  int last = 0;
  for (int s = 0; s < signals_; ++s) {
    int& fineness = coded_.fineness[static_cast<std::size_t>(s)];
    fineness =
        last + signed_number(fineness - last, s == 0                                           ? 0
                                              : kin_[static_cast<std::size_t>(s)].sibling >= 0 ? 1
                                                                                               : 2);
    if (fineness < kLeastFineness || fineness > kMostFineness) bits_.fail();
    last = fineness;
  }
  for (int s = 0; s < signals_; ++s) code_coarse(s);
  for (int b = 1; b < bands; ++b) {
    activity_.assign(static_cast<std::size_t>(bands_[static_cast<std::size_t>(b)].size) + 2, 0);
    for (int s = 0; s < signals_; ++s) code_band(b, s);
  }
}

template <typename Bits>
void CoefficientCoder<Bits>::code_coarse(int s) {
  int before = 0;
  for (int i = 0; i < bands_[0].size; ++i) {
    int& v = coded_.values(bands_[0].first + i, s);
    v = before + signed_number(v - before, i == 0 ? (s < 3 ? 3 : 4) : (s < 3 ? 5 : 6));
    if (std::abs(v) > kMostSteps) bits_.fail();
    before = v;
  }
}

template <typename Bits>
void CoefficientCoder<Bits>::code_band(int b, int s) {
  const auto finest = static_cast<int>(bands_.size()) - 1;
  const int level = std::min(finest - b, kLevels - 1);  // 0: finest
  const Band& band = bands_[static_cast<std::size_t>(b)];
  const Band& parent = bands_[static_cast<std::size_t>(b - 1)];
  const bool has_parent = b > 1;
  const SignalKin& kin = kin_[static_cast<std::size_t>(s)];
  int* const q = coded_.values.col(s).data() + band.first;
  const int* const par = coded_.values.col(s).data() + parent.first;
  const int* const sib =
      kin.sibling >= 0 ? coded_.values.col(kin.sibling).data() + band.first : nullptr;
  const int* const mir =
      kin.mirror >= 0 ? coded_.values.col(kin.mirror).data() + band.first : nullptr;
  auto& sums = sum_[static_cast<std::size_t>(b)];
  const int parent_sum =
      has_parent ? sum_[static_cast<std::size_t>(b - 1)][static_cast<std::size_t>(s)] : parent.size;
  const auto density = [](int sum, int size) {
    const int x = 16 * sum / std::max(size, 1);
    return x == 0 ? (sum > 0 ? 1 : 0) : std::min(1 + width((x)), 11);
  };
  const int c_bucket = density(parent_sum, parent.size);
  // Anything at all?
  const auto alive_of = [&](int other) {
    return other < 0 ? 2 : sums[static_cast<std::size_t>(other)] > 0 ? 1 : 0;
  };
  bool any = false;
  for (int i = 0; i < band.size; ++i) any = any || q[i] != 0;
  any = mixed(any,
              {f_[0] + level * 24 + c_bucket,
               f_[1] + (alive_of(kin.sibling) * 3 + alive_of(kin.mirror)) * 24 + c_bucket,
               f_[2] + (level * 8 + std::min(width((band.size)), 7)) * 12 + c_bucket},
              0);
  if (!any) {
    std::fill_n(q, band.size, 0);
    return;
  }
  const auto mag = [](const int* p, int i, int n) { return i < 0 || i >= n ? 0 : std::abs(p[i]); };
  int ema = 0;  // 16ths
  for (int i = 0; i < band.size; ++i) {
    const int a1 = i > 0 ? std::abs(q[i - 1]) : 0;
    const int a2 = i > 1 ? std::abs(q[i - 2]) : 0;
    const int p0 = has_parent ? mag(par, i >> 1, parent.size) : 0;
    const int p1 = has_parent ? mag(par, i % 2 ? (i >> 1) + 1 : (i >> 1) - 1, parent.size) : 0;
    const int a = bucket(2 * a1 + a2);
    const int p = bucket(2 * p0 + p1);
    const int sb =
        sib ? bucket(2 * std::abs(sib[i]) + mag(sib, i - 1, band.size) + mag(sib, i + 1, band.size))
            : 0;
    const int mb =
        mir ? bucket(2 * std::abs(mir[i]) + mag(mir, i - 1, band.size) + mag(mir, i + 1, band.size))
            : 0;
    const auto at = static_cast<std::size_t>(i) + 1;
    const int act = 2 * activity_[at] + activity_[at - 1] + activity_[at + 1];
    const int t = std::min(width((s == 0 ? 0 : 64 * act / (4 * s))), 11);
    const int e = std::min(width((ema)), 11);
    const int weights = 1 + level;
    const bool nonzero =
        mixed(q[i] != 0,
              {z_[0] + (level * kB + a) * kB + p,
               z_[1] + ((level * kB + sb) * kB + a) * 4 + std::min(p, 3),
               z_[2] + (t * kB + a) * kB + p, z_[3] + level * signals_ + s,
               z_[4] + (e * 12 + c_bucket) * 4 + level / 2, z_[5] + (mb * kB + sb) * kB + p},
              weights);
    int magnitude = 0;
    if (nonzero) {
      const int x = bucket(2 * a1 + a2 + p0 + (p0 + p1 + 1) / 2);
      magnitude = 1;
      while (magnitude < 14) {
        const int k = std::min(magnitude, 6) - 1;
        if (!mixed(std::abs(q[i]) > magnitude,
                   {m_[0] + (k * kLevels + level) * kB + x, m_[1] + (k * kB + sb) * kB + a,
                    m_[2] + (k * 12 + t) * 4 + std::min(p, 3), m_[3] + k * signals_ + s,
                    m_[4] + (k * 12 + e) * 12 + c_bucket},
                   16 + k))
          break;
        ++magnitude;
      }
      if (magnitude == 14) {
        magnitude += number(std::abs(q[i]) - 14, 7);
        if (magnitude > kMostSteps) bits_.fail();
      }
      const auto sign = [](int v) { return v > 0 ? 2 : v < 0 ? 1 : 0; };
      const int s1 = i > 0 ? sign(q[i - 1]) : 0;
      const int s2 = i > 1 ? sign(q[i - 2]) : 0;
      const int sp = has_parent ? sign(par[std::min(i >> 1, parent.size - 1)]) : 0;
      const bool negative = mixed(q[i] < 0,
                                  {s_[0] + level * 27 + (s1 * 3 + s2) * 3 + sp,
                                   s_[1] + (s1 * 3 + s2) * 3 + (sib ? sign(sib[i]) : 0)},
                                  24);
      q[i] = negative ? -magnitude : magnitude;
    } else {
      q[i] = 0;
    }
    ema += (64 * std::min(magnitude, 64) - ema) / 8;
    activity_[at] += std::min(magnitude, 2);
    sums[static_cast<std::size_t>(s)] += std::min(magnitude, 255);
  }
}

}  // namespace mocapress
