// SPDX-License-Identifier: MIT
#include "core/study/row.h"

#include <cmath>
#include <cstdio>

#include "core/study/plan.h"

namespace mocapress {
namespace {

constexpr double kRatioTolerance = 0.02;
constexpr double kRounding = 1e-9;

}  // namespace

bool StudyRow::reached() const {
  if (!measured) return false;
  const double bound = target.value * (1 + kRounding);
  switch (target.kind) {
    case Target::Kind::Ratio:
      return std::abs(measured->ratio / target.value - 1) <= kRatioTolerance + kRounding;
    case Target::Kind::CoefficientRatio:
      return measured->coefficient_ratio.has_value();
    case Target::Kind::Size:
      return static_cast<double>(measured->motion_bytes) <= bound;
    case Target::Kind::Error:
      return measured->eps_cm(weighting) <= bound;
    case Target::Kind::MaxError:
      return measured->max_error_cm <= bound;
  }
  return false;
}

std::string StudyRow::key() const {
  char numbers[128];
  std::snprintf(numbers, sizeof numbers, "|%.17g|%llu|%.17g", target.value,
                static_cast<unsigned long long>(seed), ik_ratio.value_or(0));
  std::string key = fingerprint + '|' + method + '|';
  for (const std::string_view word :
       {name(target.kind), name(weighting), coding ? name(*coding) : std::string_view()})
    key.append(word).append("|");
  return key + numbers;
}

}  // namespace mocapress
