// SPDX-License-Identifier: MIT
#include "core/motion/body_part.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>

#include "core/base/names_all.h"

namespace mocapress {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool contains_any(const std::string& text, std::initializer_list<const char*> words) {
  return std::ranges::any_of(
      words, [&](const char* word) { return text.find(word) != std::string::npos; });
}

std::optional<BodyPart> part_of(const std::string& joint) {
  const std::string name = lower(joint);
  if (contains_any(name, {"spine", "back"})) return std::nullopt;  // also "middle spine"
  if (contains_any(name, {"foot", "ankle", "toe", "ball"})) return BodyPart::Feet;
  if (contains_any(name, {"finger", "thumb", "index", "middle", "ring", "pinky", "little"}))
    return BodyPart::Fingers;
  if (contains_any(name, {"hand", "wrist", "palm"})) return BodyPart::Hands;
  if (contains_any(name, {"head", "neck", "jaw", "eye"})) return BodyPart::Head;
  return std::nullopt;
}

}  // namespace

std::string_view name(BodyPart part) {
  constexpr std::string_view kNames[] = {"feet", "hands", "fingers", "head"};
  static_assert(names_all<BodyPart>(kNames));
  return kNames[static_cast<std::size_t>(part)];
}

std::vector<int> joints_of(const Skeleton& skeleton, BodyPart part) {
  std::vector<int> joints;
  for (int j = 0; j < skeleton.joint_count(); ++j)
    if (part_of(skeleton.joint(j).name) == part) joints.push_back(j);
  return joints;
}

std::vector<int> namesakes_of(const Skeleton& skeleton, BodyPart part) {
  const std::string_view word = part == BodyPart::Feet    ? "foot"
                                : part == BodyPart::Hands ? "hand"
                                : part == BodyPart::Head  ? "head"
                                                         : "";  // every finger counts as a namesake
  const std::vector<int> all = joints_of(skeleton, part);
  std::vector<int> namesakes;
  for (const int j : all)
    if (lower(skeleton.joint(j).name).find(word) != std::string::npos) namesakes.push_back(j);
  return namesakes.empty() ? all : namesakes;
}

}  // namespace mocapress
