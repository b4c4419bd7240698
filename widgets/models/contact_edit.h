// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/feet/contact_spans.h"

namespace mocapress {

enum class SpanEnd { First, Last };

/// Moves an end of one contact to a frame, or as near to it as the contact's other end, the
/// landmark's next contact and the clip allow.
std::vector<ContactSpan> withEndAt(std::vector<ContactSpan> contacts, int index, SpanEnd end,
                                   int frame, int frames);

std::vector<ContactSpan> withoutContact(std::vector<ContactSpan> contacts, int index);

/// Adds a contact of `landmark` around a frame, up to `length` frames long where there is room. A
/// frame that already has one changes nothing. The order by landmark and time is kept.
std::vector<ContactSpan> withContactAt(std::vector<ContactSpan> contacts, int landmark, int frame,
                                       int length, int frames);

/// Lets a landmark stand over a range of frames; contacts of it that touch the range become one
/// with it.
std::vector<ContactSpan> withContactOver(std::vector<ContactSpan> contacts, int landmark,
                                         int first_frame, int last_frame);

/// Takes the contacts of a landmark out of a range of frames; what lies outside stays.
std::vector<ContactSpan> withoutContactOver(const std::vector<ContactSpan>& contacts, int landmark,
                                            int first_frame, int last_frame);

}  // namespace mocapress
