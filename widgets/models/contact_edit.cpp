// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/contact_edit.h"

#include <algorithm>

namespace mocapress {
namespace {

/// The free frames around a frame, up to the landmark's neighbouring contacts.
struct Room {
  int first;
  int last;
};

Room roomAround(const std::vector<ContactSpan>& contacts, int landmark, int frame, int frames,
                int but = -1) {
  Room room{0, frames - 1};
  for (int i = 0; i < static_cast<int>(contacts.size()); ++i) {
    const ContactSpan& span = contacts[static_cast<std::size_t>(i)];
    if (i == but || span.landmark != landmark) continue;
    if (span.last_frame < frame) room.first = std::max(room.first, span.last_frame + 1);
    if (span.first_frame > frame) room.last = std::min(room.last, span.first_frame - 1);
  }
  return room;
}

/// Inserts a contact in the order by landmark, then time.
void insert(const ContactSpan& added, std::vector<ContactSpan>& contacts) {
  // The place before the landmark's next contact, else after its last one, else before those of
  // later landmarks.
  auto place = std::find_if(contacts.begin(), contacts.end(), [&](const ContactSpan& span) {
    return span.landmark == added.landmark && span.first_frame > added.first_frame;
  });
  if (place == contacts.end()) {
    const auto last =
        std::find_if(contacts.rbegin(), contacts.rend(),
                     [&](const ContactSpan& span) { return span.landmark == added.landmark; });
    place = last != contacts.rend()
                ? last.base()
                : std::find_if(contacts.begin(), contacts.end(), [&](const ContactSpan& span) {
                    return span.landmark > added.landmark;
                  });
  }
  contacts.insert(place, added);
}

}  // namespace

std::vector<ContactSpan> withEndAt(std::vector<ContactSpan> contacts, int index, SpanEnd end,
                                   int frame, int frames) {
  ContactSpan& span = contacts[static_cast<std::size_t>(index)];
  const Room room = roomAround(contacts, span.landmark, span.first_frame, frames, index);
  if (end == SpanEnd::First)
    span.first_frame = std::clamp(frame, room.first, span.last_frame);
  else
    span.last_frame = std::clamp(frame, span.first_frame, room.last);
  return contacts;
}

std::vector<ContactSpan> withoutContact(std::vector<ContactSpan> contacts, int index) {
  contacts.erase(contacts.begin() + index);
  return contacts;
}

std::vector<ContactSpan> withContactAt(std::vector<ContactSpan> contacts, int landmark, int frame,
                                       int length, int frames) {
  for (const ContactSpan& span : contacts)
    if (span.landmark == landmark && span.first_frame <= frame && frame <= span.last_frame)
      return contacts;
  const Room room = roomAround(contacts, landmark, frame, frames);
  const int first = std::max(room.first, frame - length / 2);
  insert({landmark, first, std::min(room.last, first + length - 1)}, contacts);
  return contacts;
}

std::vector<ContactSpan> withContactOver(std::vector<ContactSpan> contacts, int landmark,
                                         int first_frame, int last_frame) {
  ContactSpan joined{landmark, first_frame, last_frame};
  for (const ContactSpan& span : contacts) {
    if (span.landmark != landmark || span.last_frame < first_frame - 1 ||
        span.first_frame > last_frame + 1)
      continue;
    joined.first_frame = std::min(joined.first_frame, span.first_frame);
    joined.last_frame = std::max(joined.last_frame, span.last_frame);
  }
  contacts = withoutContactOver(contacts, landmark, joined.first_frame, joined.last_frame);
  insert(joined, contacts);
  return contacts;
}

std::vector<ContactSpan> withoutContactOver(const std::vector<ContactSpan>& contacts, int landmark,
                                            int first_frame, int last_frame) {
  std::vector<ContactSpan> rest;
  for (const ContactSpan& span : contacts) {
    if (span.landmark != landmark || span.last_frame < first_frame ||
        span.first_frame > last_frame) {
      rest.push_back(span);
      continue;
    }
    if (span.first_frame < first_frame)
      rest.push_back({landmark, span.first_frame, first_frame - 1});
    if (span.last_frame > last_frame) rest.push_back({landmark, last_frame + 1, span.last_frame});
  }
  return rest;
}

}  // namespace mocapress
