// SPDX-License-Identifier: MIT
#include "core/formats/fbx/fbx_onto.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/formats/fbx/fbx_curve_output.h"
#include "core/formats/fbx/fbx_objects.h"
#include "core/formats/fbx/fbx_reader.h"
#include "core/formats/fbx/fbx_scene.h"
#include "core/formats/fbx/fbx_writer.h"
#include "core/motion/landmarks.h"
#include "tests/support/corpus.h"
#include "tests/support/same_motion.h"
#include "tests/support/test_motion.h"

namespace mocapress::fbx_onto_test {
namespace {

using test::largest_joint_move;

namespace fs = std::filesystem;

/// All records but those in curves, as they are written; what a record holds is in brackets.
void append_but_curves(const FbxRecords& records, const FbxRecord& in, std::string& text) {
  for (const FbxRecord* record = records.first_child(in); record != nullptr;
       record = records.next(*record)) {
    text += std::string(record->name) + '=' + std::string(record->values) + '{';
    if (record->name != "AnimationCurve") append_but_curves(records, *record, text);
    text += '}';
  }
}

std::string all_but_curves(const std::string& bytes) {
  const FbxRecords records("f.fbx", bytes);
  std::string text;
  append_but_curves(records, records.top(), text);
  return text;
}

/// The same clip, every joint turned a little more from frame to frame.
Motion turned(Motion motion) {
  for (int c = 0; c < motion.skeleton.channel_count(); ++c)
    if (is_rotation(motion.skeleton.channel_kind(c)))
      for (int t = 0; t < motion.clip.frames(); ++t)
        motion.clip.channels(t, c) += 0.01 * t / motion.clip.frames();
  return motion;
}

class FbxOnto : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("fbx-onto-" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path written(const std::string& bytes) const {
    fs::path file = folder_ / "character.fbx";
    write_text(file, bytes);
    return file;
  }

  static std::string put_onto(const fs::path& onto, const Motion& motion,
                              const WriteOptions& options = {}, const ScalarTracks& tracks = {}) {
    return fbx_bytes_onto(onto.string(), read_text(onto), motion, options, tracks);
  }

  /// Reads again `motion` written onto the file.
  MotionFile again(const fs::path& onto, const Motion& motion, const WriteOptions& options = {},
                   const ScalarTracks& tracks = {}) const {
    return read_fbx("again.fbx", put_onto(onto, motion, options, tracks), {.take = options.take});
  }

  fs::path folder_;
};

TEST_F(FbxOnto, ItselfChangesNoByteOutsideTheCurves) {
  const fs::path character = fs::path(MOCAPRESS_SOURCE_DIR) / "resources/samples/character.fbx";
  const MotionFile file = read_motion(character);
  const std::string bytes = put_onto(character, file.motion, {}, file.tracks);
  EXPECT_EQ(all_but_curves(bytes), all_but_curves(read_text(character)));
  EXPECT_LT(largest_joint_move(file.motion, read_fbx("again.fbx", bytes).motion), 1e-4);
}

TEST_F(FbxOnto, ReplacesTheMotionAndKeepsTheMesh) {
  const fs::path character = fs::path(MOCAPRESS_SOURCE_DIR) / "resources/samples/character.fbx";
  const Motion motion = turned(read_motion(character).motion);
  const MotionFile found = again(character, motion);
  EXPECT_LT(largest_joint_move(motion, found.motion), 1e-4);
  EXPECT_NE(found.skin, nullptr);
}

TEST_F(FbxOnto, AWholeTransformPutsJointsInTheirPlaces) {
  const Motion motion = test::smooth_motion(20);
  const std::string plain = fbx_bytes(motion);
  const FbxRecords records("f", plain);
  const FbxRecord* const list = records.find(records.top(), "Objects");
  FbxEdits edits;
  for (const FbxRecord* record = records.first_child(*list); record != nullptr;
       record = records.next(*record)) {
    if (record->name != "Model") continue;
    FbxOutRecord more;
    for (const char* part : {"PreRotation", "PostRotation", "RotationPivot", "RotationOffset",
                             "ScalingPivot", "ScalingOffset"})
      more.property(part, "Vector3D", "Vector", "").value(4.0).value(-3.0).value(2.0);
    edits.added[records.find(*record, "Properties70")] = std::move(more.records);
  }
  const fs::path file = written(fbx_edited_bytes(records, edits));
  EXPECT_GT(largest_joint_move(motion, read_motion(file).motion), 1);
  EXPECT_LT(largest_joint_move(motion, again(file, motion).motion), 1e-4);
}

TEST_F(FbxOnto, AMotionOfAnotherRateKeepsItsTime) {
  Motion motion = test::smooth_motion(50);
  motion.clip.sample_rate_hz = 30;
  const fs::path file = written(fbx_bytes(motion));
  for (const double rate : {24.0, 50.0, 60.0, 120.0}) {
    motion.clip.sample_rate_hz = rate;
    EXPECT_LT(largest_joint_move(motion, again(file, motion).motion), 1e-4) << rate;
  }
}

TEST_F(FbxOnto, TheFilesOwnUnitAndAxesStand) {
  const Motion motion = test::smooth_motion(20);
  const fs::path file = written(fbx_bytes(motion, {}, {.cm_per_unit = 100.0, .up = UpAxis::Z}));
  const MotionFile found = again(file, turned(motion));
  EXPECT_EQ(found.source.cm_per_unit, 100);
  EXPECT_EQ(found.source.up, UpAxis::Z);
  EXPECT_LT(largest_joint_move(turned(motion), found.motion), 1e-4);
}

/// The file without its curves and the layers and takes of these types.
std::string without(const std::string& bytes, const std::vector<std::string>& types) {
  const FbxRecords records("f", bytes);
  const FbxRecord* const list = records.find(records.top(), "Objects");
  FbxEdits edits;
  for (const FbxRecord* record = records.first_child(*list); record != nullptr;
       record = records.next(*record))
    if (std::find(types.begin(), types.end(), record->name) != types.end())
      edits.dropped.insert(record);
  return fbx_edited_bytes(records, edits);
}

TEST_F(FbxOnto, ACharacterWithoutAKeyTakesTheMotionOn) {
  const fs::path character = fs::path(MOCAPRESS_SOURCE_DIR) / "resources/samples/character.fbx";
  const Motion motion = read_motion(character).motion;
  for (const std::vector<std::string>& types :
       {std::vector<std::string>{"AnimationCurve"},
        std::vector<std::string>{"AnimationCurve", "AnimationCurveNode", "AnimationLayer",
                                 "AnimationStack"}}) {
    const fs::path file = written(without(read_text(character), types));
    EXPECT_THROW(read_motion(file), InputError);
    const MotionFile found = again(file, motion);
    EXPECT_LT(largest_joint_move(motion, found.motion), 1e-4);
    EXPECT_NE(found.skin, nullptr);
  }
}

TEST_F(FbxOnto, ALongerMotionLengthensTheTake) {
  const fs::path file = written(fbx_bytes(test::smooth_motion(20)));
  const Motion longer = test::smooth_motion(50);
  EXPECT_LT(largest_joint_move(longer, again(file, longer).motion), 1e-4);
}

TEST_F(FbxOnto, OtherLayersOfTheTakeMoveItsJointsNoMoreAndOtherTakesStay) {
  const Motion motion = test::smooth_motion(20);
  const std::string plain = fbx_bytes(motion);
  FbxRecords records("f", plain);
  const FbxObjects objects(records);
  FbxEdits edits;
  FbxCurveOutput out({0, 46186158000}, edits.added[records.find(records.top(), "Objects")],
                     edits.added[records.find(records.top(), "Connections")], 1'000'000);
  std::int64_t stack = 0;
  std::int64_t root = 0;
  for (const FbxObject& object : objects.all()) {
    if (object.record == nullptr) continue;
    const std::int64_t id = records.value(*object.record, 0)->whole();
    if (object.type == "AnimationStack") stack = id;
    if (object.name == motion.skeleton.joint(0).name && object.type == "Model") root = id;
  }
  const auto add_layer = [&](std::int64_t of, const char* name) {
    const std::int64_t layer = out.new_id();
    out.object("AnimationLayer", layer, fbx_full_name(name, "AnimLayer"), "").is_list = true;
    out.connect(layer, of);
    out.add(layer, root, "Lcl Rotation", {{{0, 90}, {0, 45}, {0, 10}}});
  };
  add_layer(stack, "more");
  const std::int64_t other = out.new_id();
  out.object("AnimationStack", other, fbx_full_name("other", "AnimStack"), "").is_list = true;
  add_layer(other, "base");
  const fs::path file = written(fbx_edited_bytes(records, edits));
  const Motion wanted = turned(motion);
  EXPECT_GT(largest_joint_move(motion, read_motion(file).motion), 1);
  EXPECT_LT(largest_joint_move(wanted, again(file, wanted, {.take = "Take 001"}).motion), 1e-4);
  const Motion kept = read_motion(file, {}, {.take = "other"}).motion;
  const std::string bytes = put_onto(file, wanted, {.take = "Take 001"});
  EXPECT_EQ(read_fbx("f", bytes, {.take = "other"}).motion.clip.channels, kept.clip.channels);
}

TEST_F(FbxOnto, TracksTakeTheNewValues) {
  const Motion motion = test::smooth_motion(3);
  ScalarTracks tracks = {
      {.kind = TrackKind::Property, .node = "event", .name = "step", .values = {0, 1, 2}},
      {.kind = TrackKind::MorphWeight, .node = "Face", .name = "smile", .values = {0, 1, 0.5}},
      {.kind = TrackKind::ScaleY,
       .node = motion.skeleton.joint(1).name,
       .name = {},
       .values = {1, 2, 3}}};
  const fs::path file = written(fbx_bytes(motion, {}, {}, tracks));
  for (ScalarTrack& track : tracks) std::reverse(track.values.begin(), track.values.end());
  const MotionFile found = again(file, motion, {}, tracks);
  EXPECT_LT(largest_joint_move(motion, found.motion), 1e-4);
  for (const ScalarTrack& track : tracks)
    EXPECT_NE(std::find(found.tracks.begin(), found.tracks.end(), track), found.tracks.end())
        << label(track);
}

TEST_F(FbxOnto, TracksOfSeveralLayersTakeTheNewValues) {
  const Motion motion = test::smooth_motion(3);
  ScalarTracks tracks = {
      {.kind = TrackKind::Property, .node = "event", .name = "step", .values = {0, 1, 2}},
      {.kind = TrackKind::MorphWeight, .node = "Face", .name = "smile", .values = {0, 1, 0.5}}};
  const std::string plain = fbx_bytes(motion, {}, {}, tracks);
  FbxRecords records("f", plain);
  const FbxObjects objects(records);
  FbxEdits edits;
  FbxCurveOutput out({0, 46186158000}, edits.added[records.find(records.top(), "Objects")],
                     edits.added[records.find(records.top(), "Connections")], 1'000'000);
  const std::int64_t layer = out.new_id();
  out.object("AnimationLayer", layer, fbx_full_name("more", "AnimLayer"), "").is_list = true;
  for (const FbxObject& object : objects.all()) {
    if (object.record == nullptr) continue;
    const std::int64_t id = records.value(*object.record, 0)->whole();
    if (object.type == "AnimationStack") out.connect(layer, id);
    if (object.kind == "BlendShapeChannel") out.add(layer, id, "DeformPercent", {7, 7}, false);
    if (object.type == "Model" && object.name == "event") out.add(layer, id, "step", {7, 7}, false);
  }
  const fs::path file = written(fbx_edited_bytes(records, edits));
  const ScalarTracks layered = read_motion(file).tracks;
  ASSERT_EQ(layered.size(), 2u);
  for (const ScalarTrack& track : layered)
    EXPECT_NEAR(track.values[2], track.name == "step" ? 9 : 0.57, 1e-6);
  EXPECT_EQ(all_but_curves(put_onto(file, motion, {}, layered)), all_but_curves(read_text(file)));
  for (ScalarTrack& track : tracks) std::reverse(track.values.begin(), track.values.end());
  const MotionFile found = again(file, motion, {}, tracks);
  for (const ScalarTrack& track : tracks)
    EXPECT_NE(std::find(found.tracks.begin(), found.tracks.end(), track), found.tracks.end())
        << label(track);
}

/// Objects of a file whose curves a test adds.
struct Aimed {
  FbxCurveOutput& out;
  std::int64_t stack = 0;
  std::int64_t layer = 0;
  std::vector<std::int64_t> joints;

  std::int64_t add_layer() {
    const std::int64_t more = out.new_id();
    out.object("AnimationLayer", more, fbx_full_name("more", "AnimLayer"), "").is_list = true;
    out.connect(more, stack);
    return more;
  }
};

/// The motion, whose joints have a property "aim" of three numbers, 0 0 3 at rest.
template <typename AddCurves>
std::string with_aims(const Motion& motion, const AddCurves& add_curves) {
  const std::string plain = fbx_bytes(motion);
  FbxRecords records("f", plain);
  const FbxObjects objects(records);
  FbxEdits edits;
  std::vector<std::int64_t> ticks;
  for (int t = 0; t < motion.clip.frames(); ++t)
    ticks.push_back(std::llround(t * kFbxTicks / motion.clip.sample_rate_hz));
  FbxCurveOutput out(ticks, edits.added[records.find(records.top(), "Objects")],
                     edits.added[records.find(records.top(), "Connections")], 1'000'000);
  Aimed aimed{.out = out};
  for (const FbxObject& object : objects.all()) {
    if (object.record == nullptr) continue;
    const std::int64_t id = records.value(*object.record, 0)->whole();
    if (object.type == "AnimationStack") aimed.stack = id;
    if (object.type == "AnimationLayer") aimed.layer = id;
    if (object.type != "Model") continue;
    FbxOutRecord more;
    more.property("aim", "Vector", "", "AU").value(0.0).value(0.0).value(3.0);
    edits.added[records.find(*object.record, "Properties70")] = std::move(more.records);
    aimed.joints.push_back(id);
  }
  add_curves(aimed);
  return fbx_edited_bytes(records, edits);
}

const std::array<std::vector<float>, 3> kAims = {
    {{1, 2, 3, 4, 5}, {10, 20, 30, 40, 50}, {7, 7, 7, 7, 7}}};

/// The first joint's movement of "aim" at a time in seconds.
Eigen::Vector3d aim_at(const std::string& bytes, double seconds) {
  FbxFile file("f", bytes);
  const FbxTake take = read_fbx_take(file, {}, FbxCurves::Keep);
  for (const FbxMovement& movement : take.movements)
    if (movement.object == take.object_of_node[1] && movement.property == "aim")
      return movement.at(seconds * kFbxTicks);
  return Eigen::Vector3d::Constant(-1);
}

TEST_F(FbxOnto, APropertyWhoseCurvesAreSharedKeepsItsOtherAxes) {
  const Motion motion = test::smooth_motion(5);
  const fs::path file = written(with_aims(motion, [](Aimed& aimed) {
    aimed.out.add(aimed.layer, aimed.joints[0], "aim", kAims);
    aimed.out.connect(1'000'000, aimed.joints[1], "aim");  // the curve node, once more
  }));
  ScalarTracks tracks = read_motion(file).tracks;
  ASSERT_EQ(tracks.size(), 4u);  // X and Y of both
  tracks[0].values = {9, 9, 9, 9, 9.5F};
  EXPECT_EQ(again(file, motion, {}, tracks).tracks.size(), 4u);
  for (const ScalarTrack& track : again(file, motion, {}, tracks).tracks)
    EXPECT_NE(std::find(tracks.begin(), tracks.end(), track), tracks.end()) << label(track);
  for (const ScalarTracks& given : {tracks, ScalarTracks{tracks[0]}})
    EXPECT_EQ(aim_at(put_onto(file, motion, {}, given), 0), Eigen::Vector3d(9, 10, 7));
}

TEST_F(FbxOnto, APropertyThatOnlyAnUpperLayerMovesKeepsItsOtherAxes) {
  const Motion motion = test::smooth_motion(5);
  const fs::path file = written(with_aims(motion, [](Aimed& aimed) {
    aimed.out.add(aimed.add_layer(), aimed.joints[0], "aim", kAims);
  }));
  ScalarTracks tracks = read_motion(file).tracks;
  ASSERT_EQ(tracks.size(), 2u);
  tracks[0].values = {9, 9, 9, 9, 9.5F};
  EXPECT_EQ(again(file, motion, {}, tracks).tracks, tracks);
  EXPECT_EQ(aim_at(put_onto(file, motion, {}, tracks), 0), Eigen::Vector3d(9, 10, 10));
}

TEST_F(FbxOnto, AnAxisOfSeveralLayersThatIsNotGivenKeepsItsTime) {
  Motion motion = test::smooth_motion(5);
  const double rate = motion.clip.sample_rate_hz;
  const fs::path file = written(with_aims(motion, [](Aimed& aimed) {
    aimed.out.add(aimed.layer, aimed.joints[0], "aim", kAims);
    aimed.out.add(aimed.add_layer(), aimed.joints[0], "aim",
                  {{{0, 1, 0, 0, 0}, {0, 0, 1, 0, 0}, {0, 1, 0, 0, 0}}});
  }));
  ScalarTracks tracks = read_motion(file).tracks;
  ASSERT_EQ(tracks.size(), 3u);
  motion.clip.sample_rate_hz = rate / 2;
  const std::string bytes = put_onto(file, motion, {}, {tracks[0]});
  EXPECT_LT((aim_at(bytes, 2 / rate) - Eigen::Vector3d(3, 31, 7)).norm(), 1e-5);
  EXPECT_LT((aim_at(bytes, 4 / rate) - Eigen::Vector3d(3, 50, 7)).norm(), 1e-5);
}

TEST_F(FbxOnto, AnAxisThatStepsStepsInCurvesOfItsOwn) {
  const Motion motion = test::smooth_motion(5);
  const fs::path file = written(with_aims(motion, [](Aimed& aimed) {
    aimed.out.add(aimed.layer, aimed.joints[0], "aim", kAims, {false, true, false});
    aimed.out.connect(1'000'000, aimed.joints[1], "aim");
  }));
  ScalarTracks tracks = read_motion(file).tracks;
  ASSERT_EQ(tracks.size(), 4u);
  EXPECT_TRUE(tracks[1].steps);
  tracks[0].values = {9, 9, 9, 9, 9.5F};
  const double between = 3.5 / motion.clip.sample_rate_hz;
  for (const ScalarTracks& given : {tracks, ScalarTracks{tracks[0]}})
    EXPECT_LT(
        (aim_at(put_onto(file, motion, {}, given), between) - Eigen::Vector3d(9.25, 40, 7)).norm(),
        1e-5);
}

TEST_F(FbxOnto, AnAsciiFileIsRefusedInOneSentence) {
  const fs::path file =
      written("; FBX 7.4.0 project file\nFBXHeaderExtension: {\n FBXVersion: 7400\n}\n");
  try {
    put_onto(file, test::smooth_motion(3));
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(),
              file.string() +
                  ": is ASCII, big-endian or older than 7.0: a motion is put only onto "
                  "other binary FBX files");
  }
}

TEST_F(FbxOnto, StrangersTakeBackTheirOwnMotionAndAnother) {
  const auto corpus = test::corpus();
  if (!corpus) GTEST_SKIP() << "the corpus of real motions is not here";
  int written_onto = 0;
  for (const char* part : {"fbx", "fbx_judged", "strangers"})
    for (const auto& entry : fs::directory_iterator(*corpus / part)) {
      if (entry.path().extension() != ".fbx") continue;
      SCOPED_TRACE(entry.path().filename().string());
      const auto put_on = [&](const Motion& motion, const MotionFile& file) {
        return FbxOnto::put_onto(entry.path(), motion, {}, file.tracks);
      };
      std::optional<MotionFile> file;
      try {
        file = read_motion(entry.path());
      } catch (const InputError&) {
        continue;  // the reader's tests judge that
      }
      const std::string source = read_text(entry.path());
      const FbxRecords records("f.fbx", source);
      if (!records.is_binary() || records.is_big_endian() || records.version() < 7000) {
        EXPECT_THROW(put_on(file->motion, *file), InputError);
        continue;
      }
      const std::string bytes = put_on(file->motion, *file);
      EXPECT_EQ(all_but_curves(bytes), all_but_curves(source));
      const double size = std::max(
          1.0, landmark_tracks(file->motion.skeleton, file->motion.clip).cwiseAbs().maxCoeff());
      const MotionFile same = read_fbx("same.fbx", bytes);
      EXPECT_LT(largest_joint_move(file->motion, same.motion), 1e-5 * size);
      const Motion wanted = turned(file->motion);
      EXPECT_LT(largest_joint_move(wanted, read_fbx("f.fbx", put_on(wanted, *file)).motion),
                1e-5 * size);
      ++written_onto;
    }
  std::cout << written_onto << " files written onto\n";
  EXPECT_GE(written_onto, 22);
}

}  // namespace
}  // namespace mocapress::fbx_onto_test
