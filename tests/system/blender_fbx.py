# SPDX-License-Identifier: MIT
# Blender's own FBX. Usage: blender -b --factory-startup -P blender_fbx.py -- OUT.json FILE...
# FILE.bvh, in centimetres, is written as FILE.bvh.fbx. FILE.fbx@SECONDS@RATE@FRAMES writes
# the places of all bones to OUT.json, in cm with Y up, at so many times from SECONDS on.
# FILE.fbx@FRAME writes the names of materials and the places of all points of its meshes, skinned.
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


def places(path, first, rate, frames):
    bpy.ops.import_scene.fbx(filepath=path)
    figures = [item for item in bpy.context.scene.objects if item.type == "ARMATURE"]
    rows = []
    for i in range(int(frames)):
        # Keys begin with frame 1 at time 0; a rate that is no whole number is rounded.
        frame = 1 + (float(first) + i / float(rate)) * bpy.context.scene.render.fps
        bpy.context.scene.frame_set(int(frame), subframe=frame - int(frame))
        heads = {bone.name: figure.matrix_world @ bone.head
                 for figure in figures for bone in figure.pose.bones}
        rows.append({name: [100 * at.x, 100 * at.z, -100 * at.y] for name, at in heads.items()})
    return rows


def skin(path, frame):
    bpy.ops.import_scene.fbx(filepath=path)
    bpy.context.scene.frame_set(int(frame))
    posed = bpy.context.evaluated_depsgraph_get()
    meshes = [item for item in bpy.context.scene.objects if item.type == "MESH"]
    points = [mesh.matrix_world @ point.co
              for mesh in meshes for point in mesh.evaluated_get(posed).data.vertices]
    return {"materials": [slot.name for mesh in meshes for slot in mesh.material_slots],
            "points": [[100 * at.x, 100 * at.z, -100 * at.y] for at in points]}


out, *files = sys.argv[sys.argv.index("--") + 1:]
open(out + ".started", "w").close()
results = {}
for file in files:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if file.endswith(".bvh"):
        write_fbx(file)
    else:
        try:
            results[file] = (skin if file.count("@") == 1 else places)(*file.split("@"))
        except RuntimeError as error:  # Blender's own word for what it does not read
            results[file] = {"error": str(error)}
with open(out, "w") as stream:
    json.dump(results, stream)
