// SPDX-License-Identifier: MIT
// A take of an FBX file in the form that all node-based formats share (node_motion.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/fbx/fbx_animation.h"
#include "core/formats/fbx/fbx_objects.h"
#include "core/formats/fbx/fbx_records.h"
#include "core/formats/fbx/fbx_transform.h"
#include "core/formats/motion_file.h"
#include "core/formats/node_motion.h"

namespace mocapress {

// Frames a second for each time mode; 0: the mode has no rate.
inline constexpr double kFbxRates[] = {30,
                                       120,
                                       100,
                                       60,
                                       50,
                                       48,
                                       30,
                                       30,
                                       30000.0 / 1001,
                                       30000.0 / 1001,
                                       25,
                                       24,
                                       1000,
                                       24000.0 / 1001,
                                       0,
                                       96,
                                       72,
                                       60000.0 / 1001,
                                       120000.0 / 1001};
inline constexpr std::size_t kFbxDefaultMode = 0;
inline constexpr std::size_t kFbxCustomMode = 14;  // mode whose rate is stated as CustomFrameRate

/// A parsed FBX file.
struct FbxFile {
  FbxFile(const std::string& file, std::string_view bytes)
      : records(file, bytes), objects(records) {}
  double ticks_per_second() const;

  FbxRecords records;
  FbxObjects objects;
};

/// Limit in seconds: keys beyond it are refused, and a take's stated span beyond it is ignored.
inline constexpr double kMostFbxSeconds = 1e7;

struct FbxTake {
  NodeTake take;
  std::vector<std::size_t> object_of_node;  // object of each of take.nodes; the first is the scene
  std::vector<int> node_of_object;          // node of each object; -1: none
  std::vector<FbxTransform> transforms;     // take.nodes at rest
  std::size_t index = 0;                    // index among the file's takes
  double first_s = 0;                       // time of the first frame
  struct TrackPlace {                       // The source of each of take.tracks.
    std::size_t object = 0;
    std::string property;
    std::size_t axis = 0;
    double scale = 1;  // track value = scale * curve value
  };
  std::vector<TrackPlace> track_places;
  std::vector<FbxMovement> movements;  // their curves are emptied, unless FbxCurves::Keep
  Takes takes;
  Warnings warnings;
};

enum class FbxCurves : std::uint8_t { Release, Keep };

/// Reads a take with its meshes. Throws InputError.
FbxTake read_fbx_take(FbxFile& file, const ReadOptions& options,
                      FbxCurves curves = FbxCurves::Release);

/// Reads the nodes at rest, whatever takes the file has.
FbxTake read_fbx_rest(FbxFile& file);

}  // namespace mocapress
