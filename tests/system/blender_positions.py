# SPDX-License-Identifier: MIT
# Where Blender puts every bone of some BVH files, as JSON, in the files' own axes and unit.
# Usage: blender -b --factory-startup -P blender_positions.py -- OUT.json FRAMES FILE.bvh...
# FRAMES: how many are sampled, the first and the last among them.
import builtins
import json
import sys

import bpy
from io_anim_bvh import import_bvh


def open_without_u(path, mode="r", *rest, **named):
    """Blender 3.4 opens in mode "rU", which Python 3.11 no longer knows."""
    return builtins.open(path, mode.replace("U", ""), *rest, **named)


import_bvh.open = open_without_u


def positions(path, wanted):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    # No turn to Blender's own axes: Y forward and Z up are those.
    bpy.ops.import_anim.bvh(filepath=path, axis_forward="Y", axis_up="Z")
    figure = bpy.context.view_layer.objects.active
    frames = len(figure.animation_data.action.fcurves[0].keyframe_points)
    sampled = sorted({round(i * (frames - 1) / max(wanted - 1, 1)) for i in range(wanted)})
    rows = []
    for frame in sampled:
        bpy.context.scene.frame_set(frame + 1)
        rows.append([list(figure.matrix_world @ bone.head) for bone in figure.pose.bones])
    return {"bones": [bone.name for bone in figure.pose.bones], "frames": frames,
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
