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

/// Adds a contact of `landmark` around a frame, up to `length` frames long where there is room.
/// Nothing changes if the frame already has one. The contacts stay in order by landmark, then time.
std::vector<ContactSpan> withContactAt(std::vector<ContactSpan> contacts, int landmark, int frame,
                                       int length, int frames);

/// Adds a contact of a landmark over a range of frames, merged with its contacts that touch the
/// range.
std::vector<ContactSpan> withContactOver(std::vector<ContactSpan> contacts, int landmark,
                                         int first_frame, int last_frame);

/// Removes a landmark's contacts from a range of frames; their parts outside the range stay.
std::vector<ContactSpan> withoutContactOver(const std::vector<ContactSpan>& contacts, int landmark,
                                            int first_frame, int last_frame);

}  // namespace mocapress
