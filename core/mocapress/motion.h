// SPDX-License-Identifier: MIT
// Motions: the input of compression and the result of decompression.
//
// - MotionFile: the result of read_motion() and parse_motion(): a Motion, warnings, and the
//   source's format.
// - Motion: a Skeleton and a Clip.
// - Clip: frames x channels, in centimetres and radians.
// - ScalarTrack: a morph weight, a property or a scale over time. A MotionFile has a list of them.
// - ContactSpan: a foot on the ground for some frames, as find_foot_contacts(motion) finds it.
//
// Everything in memory is in centimetres, radians and seconds, right-handed, y up, whatever the
// file had. Every failure is an Error: InputError for a text that cannot be read (file, line,
// column), FormatError for a .mcpr (byte offset), WriteError, TargetMissed.
#pragma once

#include "core/base/error.h"
#include "core/feet/contact_spans.h"
#include "core/formats/motion_file.h"
#include "core/motion/clip.h"
#include "core/motion/landmarks.h"
#include "core/motion/skeleton.h"
