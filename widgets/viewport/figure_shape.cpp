// SPDX-License-Identifier: GPL-3.0-or-later
// Based on: D. A. Winter, "Biomechanics and Motor Control of Human Movement" (proportions).
#include "widgets/viewport/figure_shape.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/motion/body.h"
#include "core/motion/body_part.h"
#include "core/motion/landmarks.h"

namespace mocapress {
namespace {

// Thickness of bodies that are not human. It grows with the square root of the length, so that
// fingers stay visible and thighs stay slim.
constexpr float kRadiusPerRoot = 0.034f;  // radius / root of (length x size of the figure)
constexpr float kThinnest = 0.003f;       // radius per size of the figure
constexpr float kTaper = 0.6f;            // a bone's end radius, per start radius
constexpr float kRingPerBall = 1.5f;      // radius of the ring, per radius of the joint's ball
constexpr float kRingPerDepth = 1.3f;   // radius of the ring, per depth of the joint below the skin
constexpr float kMostThickness = 0.4f;  // radius per length of a bone

// Proportions of a human, as shares of the stature.
constexpr float kLegOfStature = 0.491f;  // from hip to ankle
constexpr float kSkull = 0.049f;         // radius
constexpr float kJaw = 0.036f;
constexpr float kJawAbove = 0.03f;  // above the joint that turns the head
constexpr float kSkullAbove = 0.063f;
constexpr float kNeckRadius = 0.031f;
constexpr float kChest = 0.059f;
constexpr float kWaist = 0.05f;
constexpr float kPelvis = 0.056f;
constexpr float kShoulder = 0.033f;
constexpr float kPalm = 0.017f;
constexpr float kHandLength = 0.1f;
constexpr float kFinger = 0.0062f;
constexpr float kHeel = 0.019f;
constexpr float kHeelBelow = 0.02f;  // below the ankle
constexpr float kToes = 0.013f;
constexpr float kFootLength = 0.1f;  // from the ankle

Eigen::MatrixXd restTracks(const Skeleton& skeleton) {
  Clip rest;
  rest.channels = Eigen::MatrixXd::Zero(1, skeleton.channel_count());
  return landmark_tracks(skeleton, rest);
}

/// The box around a frame's landmarks.
struct Box {
  QVector3D low, high;
};

Box boxAround(const Eigen::MatrixXd& tracks, int frame, int first) {
  Box box{landmarkAt(tracks, frame, first), landmarkAt(tracks, frame, first)};
  for (int p = first + 1; p < tracks.cols() / 3; ++p) {
    const QVector3D point = landmarkAt(tracks, frame, p);
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], point[axis]);
      box.high[axis] = std::max(box.high[axis], point[axis]);
    }
  }
  return box;
}

float longestSide(const Box& box) {
  const QVector3D sides = box.high - box.low;
  return std::max({sides.x(), sides.y(), sides.z()});
}

}  // namespace

QVector4D tintOf(const QColor& colour) {
  return {colour.redF(), colour.greenF(), colour.blueF(), 1};
}

QVector3D landmarkAt(const Eigen::MatrixXd& tracks, int frame, int landmark) {
  const auto at = [&](int axis) { return static_cast<float>(tracks(frame, 3 * landmark + axis)); };
  return {at(0), at(1), at(2)};
}

/// Builds a body part by part.
class FigureShape::Builder {
 public:
  Builder(const Skeleton& skeleton, const Eigen::MatrixXd& pose, FigureShape& shape)
      : skeleton_(skeleton),
        shape_(shape),
        pose_(pose),
        regions_(body_regions(skeleton)),
        is_finger_(static_cast<std::size_t>(skeleton.joint_count()), false) {
    for (const int joint : joints_of(skeleton, BodyPart::Fingers))
      is_finger_[static_cast<std::size_t>(joint)] = true;
  }

  void build() {
    findBones();
    if (regions_.empty() || !findHuman()) return addBones();
    addTrunk();
    addHead();
    for (const Bone& bone : bones_) addLimb(bone);
    for (const int joint : tops(BodyRegion::Hand)) addPalm(joint);
    for (const int joint : tops(BodyRegion::Foot)) addFoot(joint);
  }

 private:
  struct Bone {
    int joint;
    int start, end;  // landmarks
    float length;    // cm
    float radius;    // cm, in the middle
  };

  BodyRegion region(int joint) const { return regions_[static_cast<std::size_t>(joint)]; }
  QVector3D posed(const Place& place) const { return at(place, pose_, 0); }
  float distance(const Place& a, const Place& b) const {
    return posed(a).distanceToPoint(posed(b));
  }

  /// The point at `share` of the way from `from` to `to`; a share above 1 leads beyond `to`.
  static Place between(const Place& from, const Place& to, float share) {
    Place place;
    for (const auto& [landmark, weight] : from) place.emplace_back(landmark, (1 - share) * weight);
    for (const auto& [landmark, weight] : to) place.emplace_back(landmark, share * weight);
    return place;
  }
  static Place on(int landmark) { return {{landmark, 1.0f}}; }

  /// The point `cm` beyond `to` on the line from `from`; `to` itself if both places coincide.
  Place beyond(const Place& from, const Place& to, float cm) const {
    const float length = distance(from, to);
    return length > 0 ? between(from, to, 1 + cm / length) : to;
  }

  void add(const Place& start, float start_radius, const Place& end, float end_radius) {
    shape_.parts_.push_back({start, start_radius, end, end_radius});
  }

  /// Makes a joint's ball at least this large.
  void fill(int joint, float radius) {
    float& ball = shape_.ball_radii_[static_cast<std::size_t>(joint)];
    ball = std::max(ball, radius);
  }

  /// Collects the body's bones. Bones from a root on the floor to the hips are not among them.
  void findBones() {
    const std::vector<BodyLimb> limbs = body_limbs(skeleton_);
    int end_site = skeleton_.joint_count();
    for (const Segment& segment : skeleton_.segments()) {
      const int end = segment.child >= 0 ? segment.child : end_site++;
      const auto limb = std::find_if(limbs.begin(), limbs.end(), [&](const BodyLimb& each) {
        return each.joint == segment.joint && each.axis_in_joint == segment.end_in_joint;
      });
      if (limb != limbs.end())
        bones_.push_back({segment.joint, segment.joint, end, static_cast<float>(segment.length),
                          static_cast<float>(limb->radius)});
    }
  }

  void addBones() {
    for (const Bone& bone : bones_) {
      const float radius = std::max(std::min(kRadiusPerRoot * std::sqrt(bone.length * shape_.size_),
                                             kMostThickness * bone.length),
                                    kThinnest * shape_.size_);
      add(on(bone.start), radius, on(bone.end), kTaper * radius);
      fill(bone.joint, radius);
    }
  }

  /// The joints of a region whose parents are not in that region.
  std::vector<int> tops(BodyRegion wanted) const {
    std::vector<int> found;
    for (int j = 0; j < skeleton_.joint_count(); ++j) {
      const int parent = skeleton_.joint(j).parent;
      if (region(j) == wanted && (parent < 0 || region(parent) != wanted)) found.push_back(j);
    }
    return found;
  }

  bool findHuman() {
    hips_ = tops(BodyRegion::Thigh);
    shoulders_ = tops(BodyRegion::UpperArm);
    if (hips_.size() != 2 || shoulders_.size() != 2) return false;
    stature_ = 0;
    for (const int hip : hips_) stature_ += legBelow(hip) / 2 / kLegOfStature;
    if (!(stature_ > 0)) return false;
    // Orders the shoulders like the hips, by the smaller sum of their distances.
    if (distance(on(shoulders_[0]), on(hips_[0])) + distance(on(shoulders_[1]), on(hips_[1])) >
        distance(on(shoulders_[0]), on(hips_[1])) + distance(on(shoulders_[1]), on(hips_[0])))
      std::swap(shoulders_[0], shoulders_[1]);
    return true;
  }

  /// The leg's length from hip over knee to ankle, however many joints lie between them.
  float legBelow(int hip) const {
    const auto is_below = [&](int joint) {
      while (joint > hip) joint = skeleton_.joint(joint).parent;
      return joint == hip;
    };
    int knee = hip;
    int ankle = hip;
    for (const int joint : tops(BodyRegion::LowerLeg))
      if (is_below(joint)) knee = joint;
    for (const int joint : tops(BodyRegion::Foot))
      if (is_below(joint)) ankle = joint;
    return distance(on(hip), on(knee)) + distance(on(knee), on(ankle));
  }

  /// Adds two columns, narrower at the waist, that bend with the shoulders and hips.
  void addTrunk() {
    const Place between_shoulders = between(on(shoulders_[0]), on(shoulders_[1]), 0.5f);
    const Place between_hips = between(on(hips_[0]), on(hips_[1]), 0.5f);
    const float trunk = distance(between_shoulders, between_hips);
    const float wide = distance(on(shoulders_[0]), on(shoulders_[1]));
    // Limits the chest so that the ribs fit between the arms.
    const float chest = std::min({kChest * stature_, 0.32f * wide, 0.4f * trunk});
    const float waist = chest * kWaist / kChest;
    const float pelvis = chest * kPelvis / kChest;
    const float shoulder = std::min(kShoulder * stature_, chest);
    const Place middle = between(between_shoulders, between_hips, 0.62f);
    for (std::size_t side = 0; side < 2; ++side) {
      const Place ribs =
          between(between(between_shoulders, on(shoulders_[side]), 0.4f), between_hips, 0.2f);
      const Place flank = between(middle, on(hips_[side]), 0.27f);
      const Place hip = between(between_hips, on(hips_[side]), 0.62f);
      add(ribs, chest, flank, waist);
      add(flank, waist, hip, pelvis);
      shoulder_of_[side] = shoulder;
      add(between(between_shoulders, on(shoulders_[side]), 0.25f), 0.85f * shoulder,
          on(shoulders_[side]), shoulder);
      add(ribs, 0.8f * chest, between(between_shoulders, on(shoulders_[side]), 0.78f), shoulder);
    }
    add(between(between_shoulders, between_hips, 0.18f), chest, middle, waist);
    add(middle, waist, between_hips, pelvis);
    neck_base_ = between(between_shoulders, between_hips, 0.04f);
    // Some rigs have joints on the skin, whose balls must not stick out.
    for (int j = shape_.body_root_; j < skeleton_.joint_count(); ++j)
      if (region(j) == BodyRegion::Trunk)
        fill(j, std::min(0.8f * waist, shape_.depth(posed(on(j)), pose_)));
  }

  void addHead() {
    for (const int head : tops(BodyRegion::Head)) {
      const Place base = on(head);
      // The crown is the bone end furthest from the neck: a face has joints, too.
      Place top = beyond(neck_base_, base, 0.1f * stature_);
      const QVector3D up = (posed(base) - posed(neck_base_)).normalized();
      float highest = 0.05f * stature_;
      for (const Bone& bone : bones_) {
        if (bone.joint != head) continue;
        const float height = QVector3D::dotProduct(posed(on(bone.end)) - posed(base), up);
        if (height <= highest) continue;
        highest = height;
        top = on(bone.end);
      }
      const float length = distance(base, top);
      const auto along = [&](float per_stature) {
        return length > 0 ? between(base, top, per_stature * stature_ / length) : base;
      };
      add(neck_base_, 1.1f * kNeckRadius * stature_, along(0.02f), kNeckRadius * stature_);
      add(along(kJawAbove), kJaw * stature_, along(kSkullAbove), kSkull * stature_);
      fill(head, kNeckRadius * stature_);
      // Adds the slopes from the neck to the shoulders.
      for (std::size_t side = 0; side < 2; ++side)
        add(between(neck_base_, base, 0.4f), 0.95f * kNeckRadius * stature_,
            between(neck_base_, on(shoulders_[side]), 0.8f), 0.85f * shoulder_of_[side]);
    }
    for (const int neck : tops(BodyRegion::Neck)) fill(neck, kNeckRadius * stature_);
  }

  void addLimb(const Bone& bone) {
    // Also bones that lead into a limb are as thick as its flesh.
    const auto add_tapered = [&](float start, float end) {
      const float radius = std::min(bone.radius, kMostThickness * bone.length);
      add(on(bone.start), start * radius, on(bone.end), end * radius);
      fill(bone.joint, start * radius);
    };
    switch (region(bone.joint)) {
      case BodyRegion::UpperArm:
        return add_tapered(1.2f, 0.95f);
      case BodyRegion::Forearm:
        return add_tapered(1.15f, 0.8f);
      case BodyRegion::Thigh:
        return add_tapered(1.25f, 0.85f);
      case BodyRegion::LowerLeg:
        return add_tapered(1.2f, 0.75f);
      case BodyRegion::Hand:
        if (!is_finger_[static_cast<std::size_t>(bone.joint)]) break;
        add(on(bone.start), kFinger * stature_, on(bone.end), 0.85f * kFinger * stature_);
        fill(bone.joint, kFinger * stature_);
        break;
      default:
        break;
    }
  }

  /// The ends of all bones at and below a joint; finger bones count only with `also_fingers`.
  std::vector<int> endsBelow(int joint, bool also_fingers) const {
    std::vector<int> ends;
    for (const Bone& bone : bones_) {
      int above = bone.joint;
      while (above > joint) above = skeleton_.joint(above).parent;
      const bool is_of_finger = is_finger_[static_cast<std::size_t>(bone.joint)];
      if (above == joint && (also_fingers || !is_of_finger)) ends.push_back(bone.end);
    }
    return ends;
  }

  /// Adds a palm: a part to each knuckle, or one as long as a hand if there are no fingers.
  void addPalm(int wrist) {
    const Place base = on(wrist);
    const float palm = kPalm * stature_;
    bool has_fingers = false;
    for (const int end : endsBelow(wrist, false)) {
      const bool is_knuckle =
          end < skeleton_.joint_count() && is_finger_[static_cast<std::size_t>(end)];
      has_fingers = has_fingers || is_knuckle;
      const bool is_short = distance(base, on(end)) < 0.02f * stature_;
      if (!is_short) add(base, 0.8f * palm, on(end), is_knuckle ? 0.55f * palm : 0.7f * palm);
    }
    fill(wrist, 0.85f * palm);
    float reach = 0;
    for (const int end : endsBelow(wrist, true)) reach = std::max(reach, distance(base, on(end)));
    if (has_fingers || reach > 0.06f * stature_) return;
    const int elbow = skeleton_.joint(wrist).parent;
    const Place tip = beyond(on(elbow), base, kHandLength * stature_);
    add(between(base, tip, 0.25f), palm, between(base, tip, 0.85f), 0.75f * palm);
  }

  /// Adds a foot: the heel below the ankle, the instep and the toes.
  void addFoot(int ankle) {
    const Place base = on(ankle);
    const int knee = skeleton_.joint(ankle).parent;
    const Place heel = beyond(on(knee), base, kHeelBelow * stature_);
    float reach = 0;
    int ball = -1;  // first joint or end beyond the ankle
    int tip = -1;   // furthest joint or end
    for (const int end : endsBelow(ankle, true)) {
      const float away = distance(base, on(end));
      if (ball < 0 && away > 0.03f * stature_) ball = end;
      if (away > reach) tip = end;
      reach = std::max(reach, away);
    }
    fill(ankle, kHeel * stature_);
    add(base, kHeel * stature_, heel, kHeel * stature_);
    if (ball < 0) return;
    const float instep = 1.05f * kHeel * stature_;
    add(base, instep, on(ball), 1.15f * kToes * stature_);
    add(heel, 0.9f * kHeel * stature_, on(ball), 1.15f * kToes * stature_);
    fill(ball < skeleton_.joint_count() ? ball : ankle, kToes * stature_);
    const Place end = tip != ball || reach > 0.9f * kFootLength * stature_
                          ? on(tip)
                          : beyond(base, on(ball), 0.35f * reach);
    add(on(ball), 1.15f * kToes * stature_, end, 0.8f * kToes * stature_);
  }

  const Skeleton& skeleton_;
  FigureShape& shape_;
  const Eigen::MatrixXd& pose_;      // pose in which the body is measured
  std::vector<BodyRegion> regions_;  // by joint; empty: not a human
  std::vector<bool> is_finger_;
  std::vector<Bone> bones_;
  std::vector<int> hips_;               // joints where legs begin, left and right or right and left
  std::vector<int> shoulders_;          // joints where arms begin, in the order of hips_
  float stature_ = 0;                   // cm
  std::array<float, 2> shoulder_of_{};  // radii of the shoulders, cm
  Place neck_base_;
};

FigureShape::FigureShape(const Skeleton& skeleton, const Eigen::MatrixXd& tracks)
    : ball_radii_(static_cast<std::size_t>(skeleton.joint_count())),
      body_root_(body_root(skeleton)) {
  const Eigen::MatrixXd rest = restTracks(skeleton);
  const Eigen::MatrixXd pose = tracks.rows() > 0 ? tracks.topRows(1).eval() : rest;
  size_ = skeleton.joint_count() > 0 ? longestSide(boxAround(rest, 0, body_root_)) : 0;
  if (size_ <= 0) size_ = 100;  // a lone point is drawn as a ball, too, so that it can be clicked
  std::fill(ball_radii_.begin(), ball_radii_.end(), kThinnest * size_);
  Builder(skeleton, pose, *this).build();
  for (int j = 0; j < jointCount(); ++j)
    ring_radii_.push_back(std::max(kRingPerBall * ball_radii_[static_cast<std::size_t>(j)],
                                   kRingPerDepth * depth(landmarkAt(pose, 0, j), pose)));
}

float FigureShape::depth(const QVector3D& point, const Eigen::MatrixXd& tracks) const {
  float deepest = 0;
  for (const Part& part : parts_) {
    const QVector3D start = at(part.start, tracks, 0);
    const QVector3D axis = at(part.end, tracks, 0) - start;
    const float length_squared = axis.lengthSquared();
    const float share =
        length_squared > 0
            ? std::clamp(QVector3D::dotProduct(point - start, axis) / length_squared, 0.0f, 1.0f)
            : 0.0f;
    const float radius = (1 - share) * part.start_radius + share * part.end_radius;
    deepest = std::max(deepest, radius - point.distanceToPoint(start + share * axis));
  }
  return deepest;
}

QVector3D FigureShape::at(const Place& place, const Eigen::MatrixXd& tracks, int frame) {
  QVector3D mean;
  for (const auto& [landmark, weight] : place) mean += weight * landmarkAt(tracks, frame, landmark);
  return mean;
}

int FigureShape::nearestLandmark(const Place& place) {
  return std::max_element(place.begin(), place.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

std::vector<Capsule> FigureShape::posed(const Eigen::MatrixXd& tracks, int frame,
                                        const FigureMarks& marks) const {
  std::vector<Capsule> capsules(static_cast<std::size_t>(capsuleCount()));
  pose(tracks, frame, marks, capsules);
  return capsules;
}

void FigureShape::pose(const Eigen::MatrixXd& tracks, int frame, const FigureMarks& marks,
                       std::span<Capsule> capsules) const {
  assert(static_cast<int>(capsules.size()) == capsuleCount());
  const auto alertOf = [&](int landmark) {  // landmark j is joint j
    const auto j = static_cast<std::size_t>(landmark);
    return j < marks.alerts.size() ? marks.alerts[j] : 0.0f;
  };
  const auto tintAt = [&](int landmark) {
    const auto p = static_cast<std::size_t>(landmark);
    return p < marks.tints.size() ? marks.tints[p] : QVector4D();
  };
  auto capsule = capsules.begin();
  for (int j = 0; j < jointCount(); ++j) {
    const QVector3D centre = landmarkAt(tracks, frame, j);
    const float radius = ball_radii_[static_cast<std::size_t>(j)];
    *capsule++ = {centre, radius, centre, radius, alertOf(j), tintAt(j), tintAt(j)};
  }
  for (const Part& part : parts_) {
    const int start = nearestLandmark(part.start);
    const int end = nearestLandmark(part.end);
    *capsule++ = {at(part.start, tracks, frame),
                  part.start_radius,
                  at(part.end, tracks, frame),
                  part.end_radius,
                  std::max(alertOf(start), alertOf(end)),
                  tintAt(start),
                  tintAt(end)};
  }
}

std::vector<QVector3D> FigureShape::body(const Eigen::MatrixXd& tracks, int frame) const {
  std::vector<QVector3D> points;
  for (int p = body_root_; p < tracks.cols() / 3; ++p)
    points.push_back(landmarkAt(tracks, frame, p));
  for (const Part& part : parts_)
    points.push_back(at(part.end, tracks, frame) + QVector3D(0, part.end_radius, 0));
  return points;
}

QVector3D FigureShape::centre(const Eigen::MatrixXd& tracks, int frame) const {
  const Box box = boxAround(tracks, frame, body_root_);
  return (box.low + box.high) / 2;
}

}  // namespace mocapress
