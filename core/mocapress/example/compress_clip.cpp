// SPDX-License-Identifier: MIT
// compress_clip CLIP.bvh|CLIP.amc [JOINT]: compresses a clip in memory, prints the size and error,
// and asks the compressed clip where a joint is after half a second.
#include <mocapress/mocapress.h>
#include <cstdio>
#include <exception>
#include <string>

using namespace mocapress;

namespace {

// Missing members have their values in Settings{}; settings_to_json() writes all members.
constexpr const char* kSettings = R"({
  "target": {"kind": "error", "value": 0.25},
  "weighting": "surface",
  "ik": {"effectors": []}
})";

Encoded compress(const MotionFile& source) {
  const Settings settings = settings_from_json(kSettings);
  int reports = 0;
  Encoded made = encode(source, settings, [&](const EncodeProgress& progress) {
    if (++reports % 100 == 1) std::fprintf(stderr, "pass %d\n", progress.pass);
    return true;  // false would stop and return the best result so far
  });
  const Measurement& cost = made.measurement;
  std::printf("%s: %zu bytes, 1 : %.1f, eps_x %.3f cm\n", target_text(settings.target).c_str(),
              made.file.size(), cost.ratio, cost.eps_cm(settings.weighting));
  return made;
}

void play(const Encoded& made, const std::string& joint) {
  const Player player(made.file);
  const Skeleton& skeleton = player.skeleton();
  const int index = skeleton.find(joint);
  if (index < 0) throw Error("the skeleton has no joint named " + joint);
  const Eigen::Vector3f place = player.positions(0.5).col(index);
  const LocalPose pose = player.sample(0.5);
  const Eigen::Quaternionf turned = pose.rotation(index);
  const Eigen::Vector3f moved = pose.translation(index);
  std::printf("%s after 0.5 s of %.2f s: at %.1f %.1f %.1f cm in the world,\n", joint.c_str(),
              player.seconds(), place.x(), place.y(), place.z());
  std::printf("  in its parent at %.1f %.1f %.1f cm, turned by w %.3f x %.3f y %.3f z %.3f\n",
              moved.x(), moved.y(), moved.z(), turned.w(), turned.x(), turned.y(), turned.z());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fprintf(stderr, "Usage: compress_clip CLIP.bvh|CLIP.amc [JOINT]\n");
    return 2;
  }
  try {
    const MotionFile source = read_motion(argv[1]);
    for (const Warning& warning : source.warnings)
      std::fprintf(stderr, "%s\n", warning.text().c_str());
    std::printf("%d frames at %.0f Hz, %d joints, %zu contacts of the feet\n",
                source.motion.clip.frames(), source.motion.clip.sample_rate_hz,
                source.motion.skeleton.joint_count(), find_foot_contacts(source.motion).size());
    const Encoded made = compress(source);
    const Measurement again = measure(source.motion, made.file);
    std::printf("measured again: furthest off %.3f cm at frame %s\n", again.max_error_cm,
                std::to_string(again.worst_frame + 1).c_str());  // people count from 1
    play(made, argc == 3 ? argv[2] : source.motion.skeleton.joint(0).name);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "compress_clip: %s\n", error.what());
    return 1;
  }
  return 0;
}
