// SPDX-License-Identifier: MIT
// Based on:
// B. De Bruyn and G. A. Orban, "Human velocity and direction discrimination measured with random
// dot patterns", 1988: speeds that differ by 7 % are told apart, from 4 degrees a second on;
// P. S. A. Reitsma and N. S. Pollard, "Perceptual metrics for character animation: sensitivity to
// errors in ballistic motion", 2003: errors along the ground are seen sooner than vertical ones,
// added acceleration sooner than removed one (their own figures were not at hand);
// M. Prazak, L. Hoyet and C. O'Sullivan, "Perceptual evaluation of footskate cleanup", 2011: feet
// that slide by less than 2.1 cm are noticed in most conditions;
// J. Harrison, R. A. Rensink and M. van de Panne, "Obscuring length changes during animated
// motion", 2004: limbs that change by 3 % of their length are noticed where viewers look;
// H. R. Wilson, F. Wilkinson, L. M. Lin and M. Castillo, "Perception of head orientation", 2000:
// heads 1.9 degrees apart are told apart.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace mocapress {

/// The cue by which an error is seen.
enum class Cue : std::uint8_t {
  Velocity,  // a joint moves about the body, or the body through the world, at another velocity
  Place,     // a joint is elsewhere relative to the body, as if limbs had other lengths
  Jitter,    // a joint trembles more than in the original
  Slide,     // a standing foot slides
  Lift,      // a standing foot floats
  Floor,     // a joint is below the floor
  Flight,    // an airborne body follows another path
  Head,      // the head is turned
  Hand,      // a hand is turned
};

inline constexpr std::size_t kCues = 9;

/// "velocity", "place", "jitter", "slide", "lift", "floor", "flight", "head", "hand".
std::string_view name(Cue cue);

/// "cm/s", "cm" or "degrees".
std::string_view unit(Cue cue);

/// The distance in metres from which the built-in limits were chosen: 1 cm is 7 minutes of arc.
inline constexpr double kUsualDistance = 5;
inline constexpr double kLeastDistance = 0.5;
inline constexpr double kMostDistance = 100;

/// The stature in cm of the figure whose head and hands the built-in limits are for.
inline constexpr double kUsualStature = 175;  // ours

/// The error from which one cue is noticed: `least`, in the cue's unit at kUsualDistance, or
/// `share` of what the original does itself, whichever is larger.
struct CueLimit {
  double least = 1;
  double share = 0;

  bool operator==(const CueLimit&) const = default;
};

/// Limits above which errors are noticed, and the viewer's distance from the figure. `least` grows
/// with the distance, since things look smaller from afar; `share` does not depend on it. Turned
/// heads and hands are judged by their size on the screen, too: the smaller the figure, the larger
/// their limits (visibility.h). "Ours" marks limits that no study gives: a blind test
/// (blind_test.h) replaces them by a viewer's own.
struct SightLimits {
  double distance_m = kUsualDistance;  // ours
  std::array<CueLimit, kCues> of_cues = {{
      {2.4, 0.07},   // velocity: De Bruyn and Orban, 7 % of the speed; 2.4 cm/s: at 4 degrees/s
      {1, 0.03},     // place: Harrison et al., share of the way from the root; 1 cm is ours
      {0.1, 1},      // jitter, RMS: ours; share of the original's own jitter
      {1.05, 0},     // slide: half the distance at which Prazak et al. saw it
      {1, 0},        // lift: ours
      {1, 0},        // floor: ours
      {1.2, 0.035},  // flight: half of velocity's, ours
      {1.9, 0},      // head: Wilson et al.
      {3.8, 0},      // hand: ours, twice the head's
  }};

  const CueLimit& of(Cue cue) const { return of_cues[static_cast<std::size_t>(cue)]; }
  CueLimit& of(Cue cue) { return of_cues[static_cast<std::size_t>(cue)]; }

  /// The error from which a cue is noticed. `own` is the original's value of which CueLimit::share
  /// is a share.
  double noticed_from(Cue cue, double own) const {
    return std::max(of(cue).least * (distance_m / kUsualDistance), of(cue).share * own);
  }

  /// The viewer's distance in metres from which an error is no longer noticed; 0 if no distance
  /// shows it.
  double unnoticed_from(Cue cue, double own, double value) const {
    return value <= of(cue).share * own ? 0 : value / of(cue).least * kUsualDistance;
  }

  bool operator==(const SightLimits&) const = default;
};

/// The limits in words: "built-in limits" or, listing those that differ, "own limits: slide 2.1 cm,
/// velocity 3 cm/s or 7 %".
std::string limits_text(const SightLimits& limits);

}  // namespace mocapress
