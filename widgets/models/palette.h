// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRgb>
#include <array>

namespace mocapress {

/// Okabe and Ito's colours, told apart by all kinds of colour vision; those that hold on white and
/// on black.
inline constexpr std::array<QRgb, 7> kCurveColours = {
    0xff0072b2, 0xffd55e00, 0xff009e73, 0xffcc79a7, 0xffe69f00, 0xff56b4e9, 0xff999999};

}  // namespace mocapress
