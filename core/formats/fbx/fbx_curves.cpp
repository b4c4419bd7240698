// SPDX-License-Identifier: MIT
// A curve between two cubic keys is a Bezier curve of time and value, whose inner points follow
// from slopes and weights. Velocities, which files state beside weights, are ignored: the programs
// that write them have included them in slopes and weights.
#include "core/formats/fbx/fbx_curves.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

namespace mocapress {
namespace {

constexpr double kSameKey = 1e-5;  // s
constexpr double kUsualWeight = 1.0 / 3;
constexpr double kClampNear = 1e-3;  // a neighbour that differs by less makes a clamped key flat

// KeyAttrFlags.
constexpr std::uint32_t kConstant = 0x2;
constexpr std::uint32_t kCubic = 0x8;
constexpr std::uint32_t kConstantNext = 0x100;
constexpr std::uint32_t kTcb = 0x200;
constexpr std::uint32_t kUser = 0x400;
constexpr std::uint32_t kClamp = 0x1000;
constexpr std::uint32_t kTimeIndependent = 0x2000;
constexpr std::uint32_t kClampProgressive = 0x4000;
constexpr std::uint32_t kWeightedOut = 0x1000000;
constexpr std::uint32_t kWeightedIn = 0x2000000;

double weight_of(std::uint32_t ten_thousandths) {
  return std::clamp(1e-4 * ten_thousandths, 1e-4, 1.0);
}

/// The parameter at which the cubic Bezier curve from 0 to 1 with inner points x1 and x2 reaches
/// `x`.
double bezier_place(double x1, double x2, double x) {
  const auto at = [&](double s) {
    return 3 * (1 - s) * (1 - s) * s * x1 + 3 * (1 - s) * s * s * x2 + s * s * s;
  };
  double low = 0;
  double high = 1;
  double s = x;
  for (int i = 0; i < 60 && high - low > 1e-15; ++i) {
    const double off = at(s) - x;
    if (std::abs(off) < 1e-15) break;
    (off > 0 ? high : low) = s;
    const double rise =
        3 * (1 - s) * (1 - s) * x1 + 6 * (1 - s) * s * (x2 - x1) + 3 * s * s * (1 - x2);
    const double newton = s - off / rise;
    s = newton > low && newton < high ? newton : (low + high) / 2;
  }
  return s;
}

}  // namespace

/// Tangents of a key. `a` and `b` are the slopes out of the key and into the next one; for
/// automatic tangents, the bias on either side; for TCB, tension and continuity.
struct FbxCurve::Tangents {
  std::uint32_t flags = 0;
  double a = 0;
  double b = 0;
  double tcb_bias = 0;
  double weight_out = kUsualWeight;
  double weight_in = kUsualWeight;

  /// True if the slopes depend on the neighbouring keys.
  bool is_automatic() const {
    return (flags & kConstant) == 0 && (flags & kCubic) != 0 && (flags & kUser) == 0;
  }
};

FbxCurve::FbxCurve(FbxRecords& records, const FbxRecord& curve, double ticks_per_second)
    : ticks_per_second_(ticks_per_second),
      before_(extrapolation(records, curve, "Pre-Extrapolation")),
      after_(extrapolation(records, curve, "Post-Extrapolation")) {
  const std::vector<std::int64_t> times = records.integers(curve, "KeyTime");
  const std::vector<double> values = records.numbers(curve, "KeyValueFloat");
  const std::vector<std::int64_t> flags = records.integers(curve, "KeyAttrFlags");
  const std::vector<std::int64_t> counts = records.integers(curve, "KeyAttrRefCount");
  const FbxRecord* const data = records.find(curve, "KeyAttrDataFloat");
  const std::vector<std::uint32_t> bits =
      data != nullptr ? records.float_bits(*data) : std::vector<std::uint32_t>();
  if (times.size() != values.size())
    records.fail(curve, "a curve has " + std::to_string(times.size()) + " key times, but " +
                            std::to_string(values.size()) + " values");
  const auto tangents_of = [&](std::size_t attribute) {
    Tangents of;
    if (attribute < flags.size()) of.flags = static_cast<std::uint32_t>(flags[attribute]);
    if (4 * attribute + 3 < bits.size()) {
      const auto number = [&](std::size_t i) {
        const auto value = static_cast<double>(std::bit_cast<float>(bits[4 * attribute + i]));
        return std::isfinite(value) ? value : 0;
      };
      of.a = number(0);
      of.b = number(1);
      of.tcb_bias = number(2);
      const std::uint32_t weights = bits[4 * attribute + 2];
      if ((of.flags & kWeightedOut) != 0) of.weight_out = weight_of(weights & 0xFFFF);
      if ((of.flags & kWeightedIn) != 0) of.weight_in = weight_of(weights >> 16);
    }
    return of;
  };
  std::vector<Tangents> tangents;  // one for each key, or one for all
  const bool is_shared = counts.size() <= 1;
  if (is_shared) tangents.push_back(tangents_of(0));
  keys_.reserve(times.size());
  std::size_t attribute = 0;
  std::int64_t left = counts.empty() ? 0 : counts[0];
  for (std::size_t k = 0; k < times.size(); ++k) {
    while (left <= 0 && attribute + 1 < counts.size()) left = counts[++attribute];
    --left;
    if (!std::isfinite(values[k])) {
      ++dropped_;
      continue;
    }
    keys_.push_back({.ticks = times[k], .value = values[k]});
    if (!is_shared) tangents.push_back(tangents_of(attribute));
  }
  settle(std::move(tangents));
}

/// A channel repeats time, value, a letter for the interpolation, and its parameters:
///   L: linear.
///   C: constant; s or n: the value of this key or of the next one.
///   U: cubic; s or b with the slopes out and in; a, d, p, q: automatic; t: TCB; then the weights:
///   n none, r out, l in, a both.
FbxCurve FbxCurve::of_channel(FbxRecords& records, const FbxRecord& channel,
                              double ticks_per_second) {
  FbxCurve curve(ticks_per_second);
  curve.before_ = extrapolation(records, channel, "Pre-Extrapolation");
  curve.after_ = extrapolation(records, channel, "Post-Extrapolation");
  const FbxRecord* const list = records.find(channel, "Key");
  if (list == nullptr) return curve;
  const FbxRecord* const stated = records.find(channel, "KeyVer");
  const auto version_value = stated != nullptr ? records.value(*stated, 0) : std::nullopt;
  const std::int64_t version = version_value ? version_value->whole() : 4005;
  const std::vector<FbxValue> values = records.values(*list);
  std::size_t at = 0;
  const auto take = [&]() -> const FbxValue& {
    if (at == values.size()) records.fail(*list, "a curve ends within a key");
    return values[at++];
  };
  std::vector<Tangents> tangents;
  while (at < values.size()) {
    Key key{.ticks = take().whole()};
    key.value = take().number();
    Tangents of;
    const char way = take().letter();
    if (way == 'C') {
      of.flags = kConstant;
      if (version >= 4004 && take().letter() == 'n') of.flags |= kConstantNext;
    } else if (way == 'U') {
      of.flags = kCubic | kTimeIndependent | kClampProgressive;  // as usually baked
      int weights = 1;
      const char kind = take().letter();
      if (kind == 's' || kind == 'b') {
        of.flags |= kUser;
        of.a = take().number();
        of.b = take().number();
        weights = version == 4003 ? 0 : 1;
      } else if (kind == 't') {
        of.flags |= kTcb;
        of.a = take().number();
        of.b = take().number();
        of.tcb_bias = take().number();
        weights = 0;
      } else if (kind == 'a') {
        weights = version <= 4004 ? 0 : 1;
      } else if (kind == 'p' || kind == 'q') {
        take();
        take();
        weights = version <= 4004 ? 1 : 2;
      } else if (kind == 'd') {
        take();
      } else {
        records.fail(*list, "has a key with unknown tangents");
      }
      for (; weights > 0; --weights) {
        const char weighted = take().letter();
        const auto weight = [&] { return std::clamp(take().number(), 1e-4, 1.0); };
        if (weighted == 'a' || weighted == 'r') of.weight_out = weight();
        if (weighted == 'a' || weighted == 'l') of.weight_in = weight();
      }
    } else if (way != 'L') {
      records.fail(*list, "has a key of an unknown kind");
    }
    for (double* const slope : {&of.a, &of.b, &of.tcb_bias})
      if (!std::isfinite(*slope)) *slope = 0;
    if (!std::isfinite(of.weight_out)) of.weight_out = kUsualWeight;
    if (!std::isfinite(of.weight_in)) of.weight_in = kUsualWeight;
    if (!std::isfinite(key.value)) {
      ++curve.dropped_;
      continue;
    }
    curve.keys_.push_back(key);
    tangents.push_back(of);
  }
  curve.settle(std::move(tangents));
  return curve;
}

FbxCurve::Extrapolation FbxCurve::extrapolation(const FbxRecords& records, const FbxRecord& curve,
                                                const char* name) {
  const FbxRecord* const stated = records.find(curve, name);
  if (stated == nullptr) return {};
  Extrapolation result;
  const FbxRecord* const type = records.find(*stated, "Type");
  const auto letter = type != nullptr ? records.value(*type, 0) : std::nullopt;
  switch (letter ? letter->letter() : '\0') {
    case 'R':
      result.way = Beyond::Repeat;
      break;
    case 'A':
      result.way = Beyond::RepeatFurther;
      break;
    case 'M':
      result.way = Beyond::Mirror;
      break;
    case 'K':
      result.way = Beyond::Slope;
      break;
    default:
      break;
  }
  if (const FbxRecord* const times = records.find(*stated, "Repetition"))
    if (const auto count = records.value(*times, 0)) result.repetitions = count->whole();
  return result;
}

/// Sorts the keys by time; among keys at one time the last wins.
void FbxCurve::sort(std::vector<Tangents>& tangents) {
  if (std::ranges::adjacent_find(
          keys_, [](const Key& a, const Key& b) { return a.ticks >= b.ticks; }) == keys_.end())
    return;
  std::vector<std::size_t> order(keys_.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::ranges::stable_sort(
      order, [&](std::size_t a, std::size_t b) { return keys_[a].ticks < keys_[b].ticks; });
  const std::vector<Key> unsorted = std::move(keys_);
  const std::vector<Tangents> of_unsorted = std::move(tangents);
  const bool is_shared = of_unsorted.size() == 1;
  keys_.clear();
  tangents.clear();
  if (is_shared) tangents = of_unsorted;
  for (const std::size_t k : order) {
    if (!keys_.empty() && keys_.back().ticks == unsorted[k].ticks) {
      keys_.pop_back();
      if (!is_shared) tangents.pop_back();
    }
    keys_.push_back(unsorted[k]);
    if (!is_shared) tangents.push_back(of_unsorted[k]);
  }
}

/// Sorts the keys by time and computes the slopes of the spans. `tangents`: one for each key, or
/// one for all.
void FbxCurve::settle(std::vector<Tangents> tangents) {
  sort(tangents);
  const auto of = [&](std::size_t key) -> const Tangents& {
    return tangents[tangents.size() == 1 ? 0 : key];
  };
  const bool is_one_for_all = tangents.size() == 1 && !tangents.front().is_automatic();
  spans_.resize(is_one_for_all ? 1 : keys_.size());
  for (std::size_t k = 0; k < spans_.size(); ++k) {
    Span& span = spans_[k];
    const Tangents& stated = of(k);
    const std::uint32_t flags = stated.flags;
    span = {.slope_out = stated.a,
            .slope_in = stated.b,
            .weight_out = stated.weight_out,
            .weight_in = stated.weight_in};
    if ((flags & kConstant) != 0) {
      span.way = (flags & kConstantNext) != 0 ? Way::ConstantNext : Way::Constant;
      continue;
    }
    if ((flags & kCubic) == 0) continue;
    span.way = Way::Cubic;
    if (!stated.is_automatic()) continue;
    double* const slope_before = k > 0 ? &spans_[k - 1].slope_in : nullptr;
    const double weight_before = k > 0 ? spans_[k - 1].weight_in : kUsualWeight;
    if ((flags & kTcb) != 0) {
      const bool is_inner = k > 0 && k + 1 < keys_.size();
      const double before = k > 0 ? slope(k - 1, k) : 0;
      const double after = k + 1 < keys_.size() ? slope(k, k + 1) : 0;
      const double share = (is_inner ? 0.5 : 1.0) * (1 - stated.a);
      const double continuity = stated.b;
      const double from_before = share * (1 + stated.tcb_bias) * before;
      const double from_after = share * (1 - stated.tcb_bias) * after;
      if (slope_before != nullptr)
        *slope_before = (1 - continuity) * from_before + (1 + continuity) * from_after;
      span.slope_out = (1 + continuity) * from_before + (1 - continuity) * from_after;
      span.slope_in = 0;
      continue;
    }
    const double bias_before = k > 0 ? -of(k - 1).b : 0;
    span.slope_out = auto_slope(k, stated.a, stated, weight_before, span.weight_out);
    if (slope_before != nullptr)
      *slope_before = auto_slope(k, bias_before, stated, weight_before, span.weight_out);
  }
}

double FbxCurve::seconds(std::size_t from, std::size_t to) const {
  return (static_cast<double>(keys_[to].ticks) - static_cast<double>(keys_[from].ticks)) /
         ticks_per_second_;
}

double FbxCurve::slope(std::size_t from, std::size_t to) const {
  return (keys_[to].value - keys_[from].value) / seconds(from, to);
}

/// An automatic slope, between the slopes to both neighbours. `bias` (percent) pulls it towards one
/// of these: above 100 beyond it, above 500 further still.
double FbxCurve::auto_slope(std::size_t k, double bias, const Tangents& tangents,
                            double weight_before, double weight_after) const {
  const bool has_before = k > 0;
  const bool has_after = k + 1 < keys_.size();
  if (!has_before && !has_after) return 0;
  const bool is_inner = has_before && has_after;
  const auto is_near = [&](std::size_t other) {
    return std::abs(keys_[other].value - keys_[k].value) <= kClampNear;
  };
  if ((tangents.flags & kClamp) != 0 &&
      ((has_before && is_near(k - 1)) || (has_after && is_near(k + 1))))
    return 0;
  if ((tangents.flags & kClampProgressive) != 0 && !is_inner) return 0;
  const bool is_blended = (tangents.flags & kTimeIndependent) == 0;
  const double steep = std::max(std::abs(bias) / 100 - 5, 0.0);
  if (!is_inner) {
    const double straight = has_before ? slope(k - 1, k) : slope(k, k + 1);
    return is_blended ? straight + steep * steep * std::copysign(40.0, bias) : straight;
  }
  const double before = slope(k - 1, k);
  const double after = slope(k, k + 1);
  double result = slope(k - 1, k + 1);
  if (is_blended) {
    const double share = seconds(k - 1, k) / seconds(k - 1, k + 1);
    result = (result + (1 - share) * before + share * after) / 2;
    const double pull = std::abs(bias) / 100;
    if (pull > 1e-4) {
      const double target = bias > 0 ? after : before;
      const double way = target - result;
      result += pull * way;
      if (steep > 0)
        result += steep * steep * std::copysign(40.0, std::abs(way) > 1e-5 ? way : bias);
    }
  }
  if ((tangents.flags & kClampProgressive) == 0) return result;
  // Limits the slope, so that the inner points stay between the neighbours' values.
  const double sign = result >= 0 ? 1 : -1;
  const double most_before = std::max(sign * before / weight_before, 0.0);
  const double most_after = std::max(sign * after / weight_after, 0.0);
  return sign * std::min({std::abs(result), most_before, most_after});
}

bool FbxCurve::moves() const {
  return goes_beyond() ||
         std::ranges::any_of(keys_,
                             [&](const Key& key) {
                               return std::abs(key.value - keys_.front().value) >
                                      1e-6 * (1 + std::abs(keys_.front().value));
                             }) ||
         (keys_.size() > 1 && std::ranges::any_of(spans_, [](const Span& span) {
            return span.way == Way::Cubic &&
                   std::max(std::abs(span.slope_out), std::abs(span.slope_in)) > 1e-4;
          }));
}

bool FbxCurve::steps() const {
  return !keys_.empty() && std::ranges::all_of(spans_, [](const Span& span) {
    return span.way == Way::Constant || span.way == Way::ConstantNext;
  });
}

bool FbxCurve::goes_beyond() const {
  return keys_.size() > 1 && (before_.way != Beyond::Constant || after_.way != Beyond::Constant);
}

double FbxCurve::at(double ticks) const {
  const double snap = kSameKey * ticks_per_second_;
  if (keys_.size() > 1 && (ticks < static_cast<double>(keys_.front().ticks) - snap ||
                           ticks > static_cast<double>(keys_.back().ticks) + snap))
    return beyond(ticks);
  return within(ticks);
}

/// The index of the first key after a time; the number of keys if there is none.
std::size_t FbxCurve::key_after(double ticks) const {
  const auto is_after = [&](std::size_t key) {
    return ticks < static_cast<double>(keys_[key].ticks);
  };
  constexpr std::size_t kNear = 4;
  std::size_t key = last_found_;
  if (key == 0 || !is_after(key - 1))
    for (; key < std::min(last_found_ + kNear, keys_.size()); ++key)
      if (is_after(key)) return last_found_ = key;
  const auto found = std::ranges::upper_bound(
      keys_, ticks, {}, [](const Key& of) { return static_cast<double>(of.ticks); });
  return last_found_ = static_cast<std::size_t>(found - keys_.begin());
}

double FbxCurve::within(double ticks) const {
  const double snap = kSameKey * ticks_per_second_;
  const std::size_t after = key_after(ticks + snap);
  if (after == 0) return keys_.front().value;
  const Key& key = keys_[after - 1];
  const double since = ticks - static_cast<double>(key.ticks);
  if (after == keys_.size() || since <= snap) return key.value;
  const Key& next = keys_[after];
  const Span& of = span(after - 1);
  if (of.way == Way::Constant) return key.value;
  if (of.way == Way::ConstantNext) return next.value;
  const double between = static_cast<double>(next.ticks) - static_cast<double>(key.ticks);
  const double share = since / between;
  if (of.way == Way::Linear) return (1 - share) * key.value + share * next.value;
  const double s = bezier_place(of.weight_out, 1 - of.weight_in, share);
  const double time = between / ticks_per_second_;
  const double first = key.value + of.slope_out * of.weight_out * time;
  const double second = next.value - of.slope_in * of.weight_in * time;
  const double r = 1 - s;
  return r * r * r * key.value + 3 * r * s * (r * first + s * second) + s * s * s * next.value;
}

double FbxCurve::beyond(double ticks) const {
  const bool is_before = ticks < static_cast<double>(keys_.front().ticks);
  const Extrapolation& extrapolation = is_before ? before_ : after_;
  const Key& end = is_before ? keys_.front() : keys_.back();
  const auto first = static_cast<double>(keys_.front().ticks);
  const auto last = static_cast<double>(keys_.back().ticks);
  if (extrapolation.way == Beyond::Constant || extrapolation.repetitions == 0) return end.value;
  if (extrapolation.way == Beyond::Slope) {
    const std::size_t key = is_before ? 0 : keys_.size() - 2;
    double rise = slope(key, key + 1);
    if (span(key).way == Way::Cubic)
      rise = is_before ? span(key).slope_out : span(key).slope_in;
    else if (span(key).way != Way::Linear)
      rise = 0;
    return end.value + rise * (ticks - static_cast<double>(end.ticks)) / ticks_per_second_;
  }
  const double duration = last - first;
  const double gone = is_before ? first - ticks : ticks - last;
  double rounds = std::floor(gone / duration);  // complete repetitions so far
  double in_round = gone - rounds * duration;
  if (extrapolation.repetitions > 0 && rounds >= static_cast<double>(extrapolation.repetitions)) {
    rounds = static_cast<double>(extrapolation.repetitions - 1);
    in_round = duration;
  }
  const bool runs_back =
      extrapolation.way == Beyond::Mirror && rounds - 2 * std::floor(rounds / 2) < 0.5;
  if (runs_back != is_before) in_round = duration - in_round;
  const double value = within(first + in_round);
  if (extrapolation.way != Beyond::RepeatFurther) return value;
  const double rise = keys_.back().value - keys_.front().value;
  return value + (is_before ? -rise : rise) * (rounds + 1);
}

}  // namespace mocapress
