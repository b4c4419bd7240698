// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/feet/contact_spans.h"

namespace mocapress {

enum class SpanEnd { First, Last };

/// The contacts with an end of one of them moved to a frame, or as near as its own other end, the
/// next contact of the same landmark and the clip allow.
std::vector<ContactSpan> withEndAt(std::vector<ContactSpan> contacts, int index, SpanEnd end,
                                   int frame, int frames);

std::vector<ContactSpan> withoutContact(std::vector<ContactSpan> contacts, int index);

/// With a contact of `landmark` around a frame, as long as there is room up to `length`; the same
/// where there is one already. Sorted by landmark and time as they were.
std::vector<ContactSpan> withContactAt(std::vector<ContactSpan> contacts, int landmark, int frame,
                                       int length, int frames);

}  // namespace mocapress
