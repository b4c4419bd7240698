// SPDX-License-Identifier: MIT
#include "core/study/row.h"

#include "core/base/number_text.h"

namespace mocapress {

bool StudyRow::reached() const {
  return measured && mocapress::reached(target, measured->quantity(target.kind, weighting));
}

std::string StudyRow::key() const {
  std::string key = fingerprint + '|' + method + '|';
  for (const std::string_view word :
       {name(target.kind), name(weighting), coding ? name(*coding) : std::string_view()})
    key.append(word).append("|");
  return key + '|' + shortest_text(target.value) + '|' + std::to_string(seed) + '|' +
         shortest_text(ik_ratio.value_or(0));
}

}  // namespace mocapress
