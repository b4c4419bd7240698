# SPDX-License-Identifier: MIT
# Where Blender puts every bone of some glTF files, as JSON, in metres with Y up.
# Usage: blender -b --factory-startup -P blender_gltf_positions.py -- OUT.json FRAMES FILE.glb...
# FRAMES: how many are sampled, the first and the last among them.
import json
import sys

import numpy

# Blender 3.4 asks for names that numpy 1.24 no longer has.
numpy.bool = bool

import bpy


def positions(path, wanted):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=path)
    (figure,) = [thing for thing in bpy.data.objects if thing.type == "ARMATURE"]
    curves = [curve for action in bpy.data.actions for curve in action.fcurves]
    keys = max((curve.keyframe_points for curve in curves), key=len)
    sampled = sorted({round(i * (len(keys) - 1) / max(wanted - 1, 1)) for i in range(wanted)})
    rows = []
    for key in sampled:
        frame = keys[key].co[0]
        bpy.context.scene.frame_set(int(frame), subframe=frame - int(frame))
        # Blender's own axes have Z up.
        heads = [figure.matrix_world @ bone.head for bone in figure.pose.bones]
        rows.append([[head.x, head.z, -head.y] for head in heads])
    return {"bones": [bone.name for bone in figure.pose.bones], "frames": len(keys),
            "sampled": sampled, "heads": rows}


out, wanted, *files = sys.argv[sys.argv.index("--") + 1:]
open(out + ".started", "w").close()
results = []
for file in files:
    try:
        results.append(positions(file, int(wanted)))
    except Exception as error:  # whatever it is, it is the finding
        results.append({"error": repr(error)})
with open(out, "w") as stream:
    json.dump(results, stream)
