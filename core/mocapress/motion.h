// SPDX-License-Identifier: MIT
// Motions: what is compressed and what decompression gives.
//
// - MotionFile: what read_motion() and parse_motion() give: a Motion, warnings, its source format.
// - Motion: a Skeleton and a Clip.
// - Clip: frames x channels, in centimetres and radians.
// - ScalarTrack: a morph weight, a property or a scale over time, of a MotionFile.
// - ContactSpan: what find_foot_contacts(motion) gives: a foot on the ground for some frames.
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
