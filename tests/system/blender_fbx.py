# SPDX-License-Identifier: MIT
# Blender's own FBX. Usage: blender -b --factory-startup -P blender_fbx.py -- OUT.json FILE...
# FILE.bvh, in centimetres, is written as FILE.bvh.fbx. Of FILE.fbx@FIRST@FRAMES, the places of all
# bones go to OUT.json, in cm with Y up, in so many frames from Blender's frame FIRST on.
import builtins
import json
import sys

import bpy
from io_anim_bvh import import_bvh


def open_without_u(path, mode="r", *rest, **named):
    """Blender 3.4 opens in mode "rU", which Python 3.11 no longer knows."""
    return builtins.open(path, mode.replace("U", ""), *rest, **named)


import_bvh.open = open_without_u


def write_fbx(path):
    bpy.ops.import_anim.bvh(filepath=path, global_scale=0.01, update_scene_fps=True)
    action = bpy.context.view_layer.objects.active.animation_data.action
    bpy.context.scene.frame_start = 1
    bpy.context.scene.frame_end = len(action.fcurves[0].keyframe_points)
    bpy.ops.export_scene.fbx(filepath=path + ".fbx", add_leaf_bones=False,
                             bake_anim_use_nla_strips=False, bake_anim_use_all_actions=False,
                             bake_anim_simplify_factor=0)


def places(path, first, frames):
    bpy.ops.import_scene.fbx(filepath=path)
    figure = next(item for item in bpy.context.scene.objects if item.type == "ARMATURE")
    rows = []
    for frame in range(int(first), int(first) + int(frames)):
        bpy.context.scene.frame_set(frame)
        heads = {bone.name: figure.matrix_world @ bone.head for bone in figure.pose.bones}
        rows.append({name: [100 * at.x, 100 * at.z, -100 * at.y] for name, at in heads.items()})
    return rows


out, *files = sys.argv[sys.argv.index("--") + 1:]
open(out + ".started", "w").close()
results = {}
for file in files:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if file.endswith(".bvh"):
        write_fbx(file)
    else:
        results[file] = places(*file.split("@"))
with open(out, "w") as stream:
    json.dump(results, stream)
