// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/compressor.h"

#include <chrono>

#include "app/jobs/result_cache.h"

namespace mocapress {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kStateInterval = std::chrono::milliseconds(40);
constexpr auto kRefineDelay = std::chrono::milliseconds(80);
constexpr double kSizeTolerance = 1.02;
constexpr double kDraftIkRatio = 16;  // from the paper's video

/// Options of the quick answer.
EncodeSettings quickOptions(EncodeSettings wanted) {
  if (wanted.method == Method::Annealed) wanted.method = Method::Standard;
  if (wanted.method == Method::ClosedLoop) {
    wanted.effort = Effort::Draft;
    wanted.size_will_do = true;
  }
  // A search for the best ratio takes many encodings, so the draft uses a fixed ratio.
  if (wanted.correction && !wanted.correction->ratio) wanted.correction->ratio = kDraftIkRatio;
  return wanted;
}

/// Calls encode(). If the target is missed, calls `missed` and rethrows.
template <typename Missed>
Encoding encodeOrTell(const Encoder& encoder, const EncodeSettings& options,
                      const Observer<EncodeProgress>& observer, const Missed& missed) {
  try {
    return encoder.encode(options, observer);
  } catch (const TargetMissed&) {
    missed();
    throw;
  }
}

/// True if a refinement that was stopped early, and may miss its target, has a smaller error at
/// about the same size or less.
bool worthKeeping(const DecodedClip& refined, const DecodedClip& quick) {
  const Weighting weighting = refined.compressed.provenance.weighting;
  return refined.distortion->eps(weighting) < quick.distortion->eps(weighting) &&
         static_cast<double>(refined.compressed.motion_bytes()) <=
             kSizeTolerance * static_cast<double>(quick.compressed.motion_bytes());
}

}  // namespace

Compressor::Compressor(QObject* parent) : QObject(parent) {
  refine_later_.setSingleShot(true);
  refine_later_.setInterval(kRefineDelay);
  connect(&refine_later_, &QTimer::timeout, this, &Compressor::startRefining);
  connect(&refine_, &JobRunner::busyChanged, this, &Compressor::refiningChanged);
}

void Compressor::setEncoder(std::shared_ptr<const Encoder> encoder, const std::string& content) {
  abandon();
  encoder_ = std::move(encoder);
  if (!encoder_) results_.clear();
  content_ = content.empty() ? std::to_string(++unlike_others_) : content;
}

std::string Compressor::resultKey() const {
  return content_ + '\n' + bytesKey(wanted_);
}

void Compressor::request(const EncodeSettings& options) {
  if (!encoder_) return;
  refine_later_.stop();
  refine_.abandon();
  code_.abandon();
  wanted_ = options;
  if (const DecodedPtr known = results_.find(resultKey())) {
    quick_.abandon();
    newer_wanted_ = false;
    if (known->visibility && known->visibility->limits != wanted_.limits)
      return startJudging(known);
    emit answered(known, true);
    return;
  }
  newer_wanted_ = true;
  if (!quick_.busy()) startQuick();
}

void Compressor::stopEarly() {
  if (refine_later_.isActive()) {
    refine_later_.stop();
    if (quick_answer_) emit answered(quick_answer_, true);
  }
  coded_will_do_ = code_.busy();
  refine_.stopEarly();
}

void Compressor::abandon() {
  refine_later_.stop();
  refine_.abandon();
  code_.abandon();
  quick_.abandon();
  newer_wanted_ = false;
}

bool Compressor::busy() const {
  return quick_.busy() || code_.busy() || refine_.busy() || refine_later_.isActive();
}

void Compressor::startQuick() {
  newer_wanted_ = false;
  const EncodeSettings options = quickOptions(wanted_);
  out_of_reach_ = false;
  const auto work = [this, encoder = encoder_, options](const Job& job) {
    return decodedClip(
        encodeOrTell(
            *encoder, options, [&job](const EncodeProgress&) { return !job.stopRequested(); },
            [&] { job.post([this] { out_of_reach_ = true; }); }),
        *encoder, options);
  };
  quick_.start(
      work, [this](const DecodedPtr& decoded) { quickDone(decoded); },
      [this](const QString& message) {
        quick_answer_ = nullptr;
        if (newer_wanted_)
          startQuick();
        else if (refines())
          refine_later_.start();  // refinement may reach the missed target
        else
          fail(message);
      });
}

void Compressor::fail(const QString& message) {
  emit failed(message, out_of_reach_);
}

void Compressor::quickDone(const DecodedPtr& decoded) {
  quick_answer_ = decoded;
  if (newer_wanted_)
    startQuick();
  else if (decoded->compressed.likely_bytes)
    startCoding();
  else if (refines())
    refine_later_.start();
  else
    return answerFinally(decoded);
  emit answered(decoded, false);
}

void Compressor::startCoding() {
  coded_will_do_ = false;
  code_.start([decoded = quick_answer_](const Job&) { return coded(*decoded); },
              [this](const DecodedPtr& decoded) {
                quick_answer_ = decoded;
                if (!coded_will_do_) refine_later_.start();
                emit answered(decoded, coded_will_do_);
              },
              [this](const QString& message) { fail(message); });
}

void Compressor::startJudging(const DecodedPtr& known) {
  code_.start([known, encoder = encoder_,
               options = wanted_](const Job&) { return judged(*known, *encoder, options); },
              [this](const DecodedPtr& decoded) { answerFinally(decoded); },
              [this](const QString& message) { fail(message); });
}

void Compressor::answerFinally(const DecodedPtr& decoded) {
  if (decoded->complete) results_.add(resultKey(), decoded);
  emit answered(decoded, true);
}

void Compressor::startRefining() {
  out_of_reach_ = false;
  const auto work = [this, encoder = encoder_, options = wanted_](const Job& job) {
    std::vector<EncodeProgress> states;
    auto reported = Clock::now();
    const auto observer = [&](const EncodeProgress& state) {
      states.push_back(state);
      if (Clock::now() - reported >= kStateInterval) {
        job.post([this, states] { emit progressed(states); });
        states.clear();
        reported = Clock::now();
      }
      return !job.stopRequested();
    };
    Encoding encoding = encodeOrTell(*encoder, options, observer,
                                     [&] { job.post([this] { out_of_reach_ = true; }); });
    job.post([this, states] { emit progressed(states); });
    return decodedClip(std::move(encoding), *encoder, options);
  };
  refine_.start(
      work, [this](const DecodedPtr& decoded) { refined(decoded); },
      [this](const QString& message) { fail(message); });
}

void Compressor::refined(const DecodedPtr& decoded) {
  const bool keep = decoded->complete || !quick_answer_ || worthKeeping(*decoded, *quick_answer_);
  keep ? answerFinally(decoded) : emit answered(quick_answer_, true);
}

}  // namespace mocapress
