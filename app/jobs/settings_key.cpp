// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/settings_key.h"

#include <limits>
#include <locale>
#include <sstream>

#include "core/codec/encode/encoder.h"

namespace mocapress {

std::string settingsKey(const EncodeOptions& options) {
  std::ostringstream key;
  key.imbue(std::locale::classic());
  key.precision(std::numeric_limits<double>::max_digits10);
  key << static_cast<int>(options.method) << ' ' << static_cast<int>(effective_coding(options))
      << ' ' << static_cast<int>(options.basis) << ' ' << static_cast<int>(options.weighting) << ' '
      << static_cast<int>(options.target.kind) << ' ' << options.target.value << ' ' << options.seed
      << ' ' << static_cast<int>(options.effort) << ' ' << static_cast<int>(options.ends);
  if (options.loop) key << " loop " << static_cast<int>(*options.loop);
  if (!options.importance.is_even()) {
    key << " importance " << options.importance.contacts;
    for (const double factor : options.importance.joints) key << ' ' << factor;
  }
  if (const auto& correction = options.correction) {
    key << " ik " << static_cast<int>(correction->solver) << ' ' << static_cast<int>(correction->at)
        << ' ' << correction->ratio.value_or(0);
    for (const int joint : correction->joints) key << ' ' << joint;
  }
  if (options.contacts) {
    key << " contacts";
    for (const ContactSpan& span : *options.contacts)
      key << ' ' << span.landmark << ' ' << span.first_frame << ' ' << span.last_frame;
  }
  return key.str();
}

}  // namespace mocapress
