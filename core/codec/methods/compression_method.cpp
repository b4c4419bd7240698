// SPDX-License-Identifier: MIT
#include "core/codec/methods/compression_method.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <mutex>

#include "core/base/error.h"
#include "core/codec/encode/search/count_search.h"
#include "core/codec/encode/search/goal.h"
#include "core/codec/format/container.h"
#include "core/codec/format/room.h"
#include "core/codec/methods/compared_file.h"

namespace mocapress {
namespace {

/// A method that selects wavelet coefficients.
struct WaveletMethod {
  CompressionMethod compression_method;
  Method method;
  Basis basis;
};

constexpr std::array kWavelets = {
    WaveletMethod{{"annealed", "Annealed wavelets",
                   "Cubic wavelets, coefficients moved between channels by annealing: the "
                   "paper's Algorithm 1, candidates compared by a quadratic error model."},
                  Method::Annealed,
                  Basis::Cubic},
    WaveletMethod{{"standard", "Standard wavelets",
                   "Cubic wavelets, the largest coefficients of all channels, angles scaled by "
                   "the length of the bone: the paper's section 4."},
                  Method::Standard,
                  Basis::Cubic},
    WaveletMethod{{"per-channel", "Per-channel wavelets",
                   "Cubic wavelets, the largest coefficients of each channel, equally many: the "
                   "paper's first approach in section 4."},
                  Method::PerChannel,
                  Basis::Cubic},
    WaveletMethod{{"haar", "Haar wavelets",
                   "Standard selection in the Haar basis, with which Arikan (2006) compared."},
                  Method::Standard,
                  Basis::Haar},
    WaveletMethod{
        {"linear", "Linear wavelets", "Standard selection in the interpolating linear basis."},
        Method::Standard,
        Basis::Linear},
    WaveletMethod{{"closed-loop", "Closed-loop wavelets",
                   "Cubic wavelets, each coefficient quantised by what its step does to the "
                   "error in the world, channels making good what others lost; adaptive coding."},
                  Method::ClosedLoop,
                  Basis::Cubic},
};

const WaveletMethod* find_wavelets(std::string_view name) {
  const auto found = std::ranges::find_if(
      kWavelets, [&](const auto& wavelets) { return wavelets.compression_method.name == name; });
  return found == kWavelets.end() ? nullptr : &*found;
}

std::vector<CompressionMethod> all_methods() {
  std::vector<CompressionMethod> all;
  for (const WaveletMethod& wavelets : kWavelets) all.push_back(wavelets.compression_method);
  for (const ComparisonMethod* method : comparison_methods())
    all.push_back({method->name, method->title, method->note});
  return all;
}

Encoding compress_wavelets(const Encoder& encoder, const EncodeSettings& settings,
                           const Observer<EncodeProgress>& observer) {
  Encoding encoding = encoder.encode(settings, observer);
  encoding.file = write_container(encoding.compressed);
  return encoding;
}

/// Searches the detail of a comparison method that meets the target of one compress() call.
class DetailSearch {
 public:
  DetailSearch(Original original, const ComparisonMethod& method, const DetailCoder& coder,
               const EncodeSettings& settings, std::vector<ContactSpan> contacts)
      : motion_(original.motion()),
        method_(method),
        coder_(coder),
        target_(settings.target),
        goal_(std::move(original), settings.target, settings.weighting, std::move(contacts), {},
              settings.limits) {}

  struct Trial {
    std::vector<std::byte> motion;
    double achieved = 0;
    double excess = 0;
  };

  /// The best trial, and whether the observer let the search finish.
  std::pair<Trial, bool> run(const Observer<EncodeProgress>& observer) const {
    constexpr int kMostTrials = 24;
    CountSearch search(coder_.most_detail(), coder_.most_detail() / 16, goal_.window(),
                       kMostTrials);
    std::optional<Trial> best;
    bool complete = true;
    for (int pass = 0; complete && !search.done(); ++pass) {
      Trial trial = attempt(search.count());
      search.tried(trial.excess);
      if (!best || !goal_.better(best->excess, trial.excess)) best = std::move(trial);
      complete = should_continue(observer, EncodeProgress{.pass = pass});
    }
    return {std::move(*best), complete};
  }

  /// Throws TargetMissed unless the trial meets the target; for a ratio, the nearest detail is
  /// enough.
  void check(const Trial& trial) const {
    if (goal_.met(trial.excess)) return;
    if (target_.kind == Target::Kind::Ratio && within_reach(trial)) return;
    throw TargetMissed(out_of_reach(target_, trial.achieved));
  }

  Clip decode(const std::vector<std::byte>& motion) const {
    return method_.decode(motion_.skeleton, motion_.clip.sample_rate_hz, motion_.clip.frames(),
                          motion);
  }

 private:
  Trial attempt(int detail) const {
    Trial trial{coder_.encode(detail)};
    trial.achieved = goal_.achieved(trial.motion.size(), [&] { return decode(trial.motion); });
    trial.excess = goal_.excess(trial.achieved);
    return trial;
  }

  /// Returns whether the ratio lies between those of the least and the most detail: then the
  /// nearest is the answer. Coding everything in less space than asked for counts too.
  bool within_reach(const Trial& nearest) const {
    return nearest.excess < 0 || attempt(0).excess <= 0;
  }

  const Motion& motion_;
  const ComparisonMethod& method_;
  const DetailCoder& coder_;
  Target target_;
  Goal goal_;
};

}  // namespace

std::span<const CompressionMethod> compression_methods() {
  static const std::vector<CompressionMethod> kMethods = all_methods();
  return kMethods;
}

const CompressionMethod* find_compression_method(std::string_view name) {
  const auto all = compression_methods();
  const auto found =
      std::ranges::find_if(all, [&](const CompressionMethod& c) { return c.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::string_view method_title(std::string_view name) {
  const CompressionMethod* compression_method = find_compression_method(name);
  return compression_method ? compression_method->title : name;
}

bool choose_wavelets(const CompressionMethod& compression_method, EncodeSettings& settings) {
  const WaveletMethod* wavelets = find_wavelets(compression_method.name);
  if (!wavelets) return false;
  settings.method = wavelets->method;
  settings.basis = wavelets->basis;
  return true;
}

struct MethodEncoder::Parts {
  explicit Parts(Motion motion) : wavelets(std::move(motion)) {}

  const DetailCoder& coder(const ComparisonMethod& method, Weighting weighting) {
    const std::lock_guard lock(mutex);
    auto& coder = coders[{method.name, weighting}];
    // Isolated, because a thread that waits inside analyse() must not take up a task that needs
    // this lock.
    if (!coder)
      tbb::this_task_arena::isolate([&] { coder = method.analyse(wavelets.motion(), weighting); });
    return *coder;
  }

  Encoder wavelets;
  std::mutex mutex;
  std::map<std::pair<std::string_view, Weighting>, std::unique_ptr<const DetailCoder>> coders;
};

MethodEncoder::MethodEncoder(Motion motion) : parts_(std::make_unique<Parts>(std::move(motion))) {}
MethodEncoder::~MethodEncoder() = default;

const Encoder& MethodEncoder::wavelets() const {
  return parts_->wavelets;
}

Encoding MethodEncoder::compress(const CompressionMethod& compression_method,
                                 const EncodeSettings& settings,
                                 const Observer<EncodeProgress>& observer) const {
  if (EncodeSettings chosen = settings; choose_wavelets(compression_method, chosen))
    return compress_wavelets(parts_->wavelets, chosen, observer);
  const ComparisonMethod* method = find_comparison_method(compression_method.name);
  if (method == nullptr) throw Error("unknown method: " + std::string(compression_method.name));
  if (settings.target.kind == Target::Kind::CoefficientRatio)
    throw Error("the coefficient ratio is a target of wavelet methods only");
  if (settings.correction) throw Error("inverse kinematics can correct wavelet methods only");

  const auto start = std::chrono::steady_clock::now();
  const Motion& motion = parts_->wavelets.motion();
  check_room(
      {motion.skeleton, motion.clip.sample_rate_hz, SegmentLayout::whole(motion.clip.frames())});
  const Eigen::MatrixXd& body = parts_->wavelets.original_body();
  const std::vector<ContactSpan>& contacts =
      settings.contacts ? *settings.contacts : parts_->wavelets.contacts();
  const DetailSearch search(Original(motion, [&]() -> const Eigen::MatrixXd& { return body; }),
                            *method, parts_->coder(*method, settings.weighting), settings,
                            contacts);
  auto [best, complete] = search.run(observer);
  if (complete) search.check(best);

  Encoding encoding;
  encoding.decoded = search.decode(best.motion);
  static_cast<Comparison&>(encoding) =
      compare(motion, body, encoding.decoded, contacts, settings.limits);
  encoding.complete = complete;
  CompressedClip& clip = encoding.compressed;
  clip.skeleton = motion.skeleton;
  clip.sample_rate_hz = motion.clip.sample_rate_hz;
  clip.frames = motion.clip.frames();
  clip.motion = std::move(best.motion);
  clip.provenance.weighting = settings.weighting;
  clip.provenance.eps_cm = static_cast<float>(encoding.distortion.eps(settings.weighting));
  clip.provenance.max_error_cm =
      static_cast<float>(encoding.distortion.worst(settings.weighting).cm);
  encoding.file = write_compared(*method, clip);
  encoding.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return encoding;
}

}  // namespace mocapress
