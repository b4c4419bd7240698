// SPDX-License-Identifier: MIT
#include "core/motion/body.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <numbers>

#include "core/motion/body_part.h"

namespace mocapress {
namespace {

constexpr double kLegOfStature = 0.491;  // from hip to ankle
constexpr double kAreaOfSquare = 0.6;    // the body's surface over its stature squared
constexpr double kThinnest = 0.004;      // share of the stature
constexpr double kThickest = 0.055;      // share of the stature: a head
constexpr double kThickestTrunk = 0.1;
constexpr double kShortestBone = 0.001;
constexpr double kLongestExtent = 0.12;  // share of the stature: a head, which has no bone
constexpr double kStatureOfReach = 1.7;  // stature over the way from the root to the furthest joint

/// Per cent of an adult's skin in a region; for limbs, on one side.
double skin_share(BodyRegion region) {
  switch (region) {
    case BodyRegion::Trunk:
      return 32;  // with buttocks and genitals
    case BodyRegion::Neck:
      return 2;
    case BodyRegion::Head:
      return 7;
    case BodyRegion::UpperArm:
      return 4;
    case BodyRegion::Forearm:
      return 3;
    case BodyRegion::Hand:
      return 2.5;
    case BodyRegion::Thigh:
      return 9.5;
    case BodyRegion::LowerLeg:
      return 7;
    case BodyRegion::Foot:
      return 3.5;
  }
  return 0;
}

bool has_translation(const Joint& joint) {
  return std::ranges::any_of(joint.channels, [](ChannelKind kind) { return !is_rotation(kind); });
}

/// Marks joints that slide against their parent, so that no bone leads to them. Where most joints
/// have translation channels, these are no evidence of sliding, except for hips above a root on the
/// floor.
std::vector<bool> sliding_joints(const Skeleton& skeleton) {
  const std::vector<Joint>& joints = skeleton.joints();
  const auto able = std::ranges::count_if(joints, has_translation);
  const bool tells = 2 * able <= std::ssize(joints);
  std::vector<int> children(joints.size(), 0);
  for (const Joint& joint : joints)
    if (joint.parent >= 0) ++children[joint.parent];
  std::vector<bool> slides;
  for (const Joint& joint : joints) {
    const auto parent = static_cast<std::size_t>(std::max(joint.parent, 0));
    const bool is_hips = joint.parent >= 0 && joints[parent].parent < 0 && children[parent] == 1;
    slides.push_back(has_translation(joint) && (tells || is_hips));
  }
  return slides;
}

bool is_neck(const std::string& name) {
  std::string lower = name;
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower.find("neck") != std::string::npos;
}

/// An arm or a leg: the first joint of its hand or foot, and the joints between that and the trunk,
/// the lowest first.
struct Limb {
  int end;
  std::vector<int> above;
};

/// The regions of a skeleton, and the joints that share one piece of skin.
class Anatomy {
 public:
  explicit Anatomy(const Skeleton& skeleton)
      : skeleton_(skeleton),
        named_(static_cast<std::size_t>(skeleton.joint_count()), BodyRegion::Trunk),
        ends_below_(named_.size(), 0) {
    for (const int j : joints_of(skeleton, BodyPart::Head))
      named_at(j) = is_neck(skeleton.joint(j).name) ? BodyRegion::Neck : BodyRegion::Head;
    for (const BodyPart part : {BodyPart::Hands, BodyPart::Fingers})
      for (const int j : joints_of(skeleton, part)) named_at(j) = BodyRegion::Hand;
    for (const int j : joints_of(skeleton, BodyPart::Feet)) named_at(j) = BodyRegion::Foot;
    for (const BodyRegion end : {BodyRegion::Head, BodyRegion::Hand, BodyRegion::Foot})
      for (const int top : tops(end))
        for (int j = top; j >= 0; j = skeleton.joint(j).parent) ++ends_below_[j];
    arms_ = limbs(BodyRegion::Hand);
    legs_ = limbs(BodyRegion::Foot);
  }

  bool is_human() const { return arms_.size() == 2 && legs_.size() == 2; }

  /// One region a joint. A joint without a region of its own has its parent's.
  std::vector<BodyRegion> regions() const {
    std::vector<BodyRegion> regions(named_.size(), BodyRegion::Trunk);
    std::vector<bool> known(named_.size(), false);
    const auto set = [&](int joint, BodyRegion region) {
      regions[joint] = region;
      known[joint] = true;
    };
    for (int j = 0; j < skeleton_.joint_count(); ++j)
      if (named_[j] == BodyRegion::Head || named_[j] == BodyRegion::Neck) set(j, named_[j]);
    const auto set_limbs = [&](const std::vector<Limb>& limbs, BodyRegion end, BodyRegion lower,
                               BodyRegion upper) {
      for (const Limb& limb : limbs) {
        set(limb.end, end);
        set(limb.above[0], lower);
        set(limb.above[1], upper);
        for (std::size_t i = 2; i < limb.above.size(); ++i) set(limb.above[i], BodyRegion::Trunk);
      }
    };
    set_limbs(arms_, BodyRegion::Hand, BodyRegion::Forearm, BodyRegion::UpperArm);
    set_limbs(legs_, BodyRegion::Foot, BodyRegion::LowerLeg, BodyRegion::Thigh);
    for (int j = 0; j < skeleton_.joint_count(); ++j)
      if (const int parent = skeleton_.joint(j).parent; !known[j] && parent >= 0)
        regions[j] = regions[parent];
    return regions;
  }

  /// The number of the arm or leg a joint belongs to, from 1 on; 0: none.
  std::vector<int> sides() const {
    std::vector<int> sides(named_.size(), 0);
    int side = 0;
    for (const auto* limbs : {&arms_, &legs_})
      for (const Limb& limb : *limbs) sides[limb.above[1]] = ++side;
    for (int j = 0; j < skeleton_.joint_count(); ++j)
      if (const int parent = skeleton_.joint(j).parent; parent >= 0 && sides[j] == 0)
        sides[j] = sides[parent];
    return sides;
  }

  double stature() const {  // cm
    double legs = 0;
    for (const Limb& leg : legs_)
      legs += skeleton_.joint(leg.end).offset.norm() + skeleton_.joint(leg.above[0]).offset.norm();
    return legs / 2 / kLegOfStature;
  }

 private:
  BodyRegion& named_at(int joint) { return named_[joint]; }

  /// Joints named for a region that are not below another such joint.
  std::vector<int> tops(BodyRegion region) const {
    std::vector<int> found;
    for (int j = 0; j < skeleton_.joint_count(); ++j) {
      if (named_[j] != region) continue;
      int above = skeleton_.joint(j).parent;
      while (above >= 0 && named_[above] != region) above = skeleton_.joint(above).parent;
      if (above < 0) found.push_back(j);
    }
    return found;
  }

  /// Limbs with at least two bones of their own. Rigs driven by inverse kinematics have helpers of
  /// the same names at the root.
  std::vector<Limb> limbs(BodyRegion end) const {
    std::vector<Limb> found;
    for (const int top : tops(end)) {
      Limb limb{top, {}};
      for (int j = skeleton_.joint(top).parent; j >= 0 && ends_below_[j] == 1;
           j = skeleton_.joint(j).parent)
        limb.above.push_back(j);
      if (limb.above.size() >= 2) found.push_back(std::move(limb));
    }
    return found;
  }

  const Skeleton& skeleton_;
  std::vector<BodyRegion> named_;  // Trunk if no name tells
  std::vector<int> ends_below_;    // number of heads, hands and feet at a joint or below
  std::vector<Limb> arms_;
  std::vector<Limb> legs_;
};

/// The length of bones from a root to its furthest joint or end.
double reach(const Skeleton& skeleton, const std::vector<bool>& slides) {
  std::vector<double> way(skeleton.joint_count(), 0);
  double furthest = 0;
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    const Joint& joint = skeleton.joint(j);
    double& own = way[j];
    if (joint.parent >= 0 && !slides[j]) own = way[joint.parent] + joint.offset.norm();
    furthest = std::max(furthest, own + (joint.end_site ? joint.end_site->norm() : 0));
  }
  return furthest;
}

/// The bones as limbs that only have their axes; radius and share are still 0.
std::vector<BodyLimb> bones(const Skeleton& skeleton, const std::vector<bool>& slides,
                            double stature) {
  std::vector<BodyLimb> bones;
  std::vector<bool> drives(skeleton.joint_count(), false);
  for (const Segment& segment : skeleton.segments()) {
    const bool connects = segment.child < 0 || !slides[segment.child];
    if (segment.child >= 0) drives[segment.joint] = true;
    if (!connects || segment.length <= kShortestBone * stature) continue;
    drives[segment.joint] = true;
    bones.push_back({segment.joint, segment.end_in_joint, 0, 0});
  }
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    const Joint& joint = skeleton.joint(j);
    const double before = joint.offset.norm();
    if (drives[j] || joint.parent < 0 || slides[j] || before <= kShortestBone * stature) continue;
    const double length = std::min(before, kLongestExtent * stature);
    bones.push_back({j, joint.offset * (length / before), 0, 0});
  }
  return bones;
}

/// Adds a bone to each joint whose turning would otherwise move no bone: all joints below it slide,
/// as where a scale changes.
void add_unseen(const Skeleton& skeleton, double stature, std::vector<BodyLimb>& limbs) {
  std::vector<bool> seen(skeleton.joint_count(), false);
  const auto mark_from = [&](int joint) {
    for (int j = joint; j >= 0; j = skeleton.joint(j).parent) seen[j] = true;
  };
  for (const BodyLimb& limb : limbs) mark_from(limb.joint);
  for (int j = skeleton.joint_count() - 1; j >= 0; --j) {
    const Joint& joint = skeleton.joint(j);
    const bool turns = std::ranges::any_of(joint.channels, is_rotation);
    if (seen[j] || !turns) continue;
    const double before = joint.offset.norm();
    const Eigen::Vector3d along =
        before > 0 ? Eigen::Vector3d(joint.offset / before) : Eigen::Vector3d::UnitY();
    limbs.push_back({j, kLongestExtent * stature * along, 0, 0});
    mark_from(j);
  }
}

}  // namespace

std::vector<BodyRegion> body_regions(const Skeleton& skeleton) {
  const Anatomy anatomy(skeleton);
  return anatomy.is_human() ? anatomy.regions() : std::vector<BodyRegion>();
}

std::optional<double> stature(const Skeleton& skeleton) {
  const Anatomy anatomy(skeleton);
  if (!anatomy.is_human() || anatomy.stature() <= 0) return std::nullopt;
  return anatomy.stature();
}

int body_root(const Skeleton& skeleton) {
  std::vector<int> children(skeleton.joint_count(), 0);
  for (const Joint& joint : skeleton.joints())
    if (joint.parent >= 0) ++children[joint.parent];
  // Joints come parents first, so that those above the body are the first ones.
  int root = 0;
  while (root + 1 < skeleton.joint_count() && children[root] == 1 &&
         skeleton.joint(root + 1).parent == root && has_translation(skeleton.joint(root + 1)))
    ++root;
  return root;
}

std::vector<BodyLimb> body_limbs(const Skeleton& skeleton) {
  const Anatomy anatomy(skeleton);
  const bool is_human = anatomy.is_human() && anatomy.stature() > 0;
  const std::vector<bool> slides = sliding_joints(skeleton);
  const double stature = is_human ? anatomy.stature() : kStatureOfReach * reach(skeleton, slides);
  std::vector<BodyLimb> limbs = bones(skeleton, slides, stature);
  if (!is_human && !limbs.empty()) add_unseen(skeleton, stature, limbs);
  const auto regions = is_human ? anatomy.regions() : std::vector<BodyRegion>();
  const auto sides = is_human ? anatomy.sides() : std::vector<int>();
  // A key for the piece of skin that a stretch belongs to.
  const auto piece = [&](const BodyLimb& limb) {
    const auto j = static_cast<std::size_t>(limb.joint);
    return is_human ? std::pair(static_cast<int>(regions[j]), sides[j]) : std::pair(-1, 0);
  };
  std::map<std::pair<int, int>, double> lengths;
  for (const BodyLimb& limb : limbs) lengths[piece(limb)] += limb.axis_in_joint.norm();
  double skin = 0;
  const auto skin_of = [](int region) {
    return region < 0 ? 1 : skin_share(static_cast<BodyRegion>(region));
  };
  for (const auto& [key, length] : lengths) skin += skin_of(key.first);
  for (BodyLimb& limb : limbs) {
    const auto key = piece(limb);
    const double share_of_piece = skin_of(key.first) / skin;
    const double area = share_of_piece * kAreaOfSquare * stature * stature;
    limb.share = share_of_piece * limb.axis_in_joint.norm() / lengths.at(key);
    const bool is_trunk = key.first == static_cast<int>(BodyRegion::Trunk);
    limb.radius = std::clamp(area / (2 * std::numbers::pi * lengths.at(key)), kThinnest * stature,
                             (is_trunk ? kThickestTrunk : kThickest) * stature);
  }
  return limbs;
}

}  // namespace mocapress
