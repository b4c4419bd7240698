// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace mocapress::test {

/// Two joints, 6 + 3 channels, two frames.
inline const std::string kSmallBvh =
    "HIERARCHY\n"
    "ROOT Hips\n"
    "{\n"
    "  OFFSET 0 90 0\n"
    "  CHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation\n"
    "  JOINT Spine\n"
    "  {\n"
    "    OFFSET 0 40 0\n"
    "    CHANNELS 3 Xrotation Yrotation Zrotation\n"
    "    End Site\n"
    "    {\n"
    "      OFFSET 0 60 0\n"
    "    }\n"
    "  }\n"
    "}\n"
    "MOTION\n"
    "Frames: 2\n"
    "Frame Time: 0.0083333\n"
    "1 2 3 10 20 30 1 2 3\n"
    "4 5 6 11 21 31 4 5 6\n";

/// A root, a turned leg with two bones and an arm without dof.
inline const std::string kSmallAsf =
    "# a comment\n"
    ":version 1.10\n"
    ":name small\n"
    ":units\n"
    "  mass 1.0\n"
    "  length 0.45\n"
    "  angle deg\n"
    ":documentation\n"
    "  begin with nothing, end with nothing\n"
    ":root\n"
    "  order TX TY TZ RX RY RZ\n"
    "  axis XYZ\n"
    "  position 0 0 0\n"
    "  orientation 0 0 0\n"
    ":bonedata\n"
    "  begin\n"
    "    id 1\n"
    "    name shin\n"
    "    direction 0 -1 0\n"
    "    length 8\n"
    "    axis 0 0 20 XYZ\n"
    "    dof rx\n"
    "    limits (-10.0 170.0)\n"
    "  end\n"
    "  begin\n"
    "    id 2\n"
    "    name thigh\n"
    "    direction 0 -1 0\n"
    "    length 7\n"
    "    axis 0 0 20 XYZ\n"
    "    dof rx ry rz\n"
    "    limits (-160.0 20.0)\n"
    "           (-70.0 70.0)\n"
    "           (-60.0 70.0)\n"
    "  end\n"
    "  begin\n"
    "    id 3\n"
    "    name arm\n"
    "    direction 1 0 0\n"
    "    length 5\n"
    "    axis 0 0 0 XYZ\n"
    "    dof\n"
    "  end\n"
    ":hierarchy\n"
    "  begin\n"
    "    thigh shin\n"
    "    root thigh arm\n"
    "  end\n";

/// Three frames of the skeleton above.
inline const std::string kSmallAmc =
    "#!OML:ASF small.ASF\n"
    ":FULLY-SPECIFIED\n"
    ":DEGREES\n"
    "1\n"
    "root 1 2 3 10 20 30\n"
    "thigh 40 50 60\n"
    "shin 70\n"
    "2\n"
    "root 2 2 3 10 20 30\n"
    "thigh 41 51 61\n"
    "shin 71\n"
    "3\n"
    "shin 72\n"
    "root 3 2 3 10 20 30\n"
    "thigh 42 52 62\n";

/// The text with every `from` replaced by `to`.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace mocapress::test
