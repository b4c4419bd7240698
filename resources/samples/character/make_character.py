# SPDX-License-Identifier: MIT
"""Makes the bundled character: a skinned figure that walks, as glTF and as FBX.

    mocapress compress resources/samples/human_walk.amc --target-error 0.005 -o walk.mcpr
    mocapress decompress walk.mcpr -o walk.bvh
    blender --background --factory-startup --python resources/samples/character/make_character.py -- \
        walk.bvh resources/samples

Written for Blender 3.4. The body is one capsule a bone, of the radii below. Those of a limb, and those
of the trunk, melt into one surface: arms hang so close to the thighs that they would melt together.
A vertex follows the bones of its part that it lies near to; skin_weights() says by how much.
"""

import sys
from pathlib import Path

import bmesh
import bpy
from io_anim_bvh import import_bvh
from mathutils import Matrix

METRES_PER_UNIT = 0.01  # the BVH is in centimetres
EVERY = 4  # 120 Hz becomes 30
VOXEL = 0.012  # m
BONES_A_VERTEX = 4

# Radius at a bone's head and at its tail, m, and how much wider than deep. Sides share a row.
SHAPES = {
    "_root": (0.0, 0.0, 1.0), "hipjoint": (0.085, 0.085, 1.0), "femur": (0.082, 0.056, 1.0),
    "tibia": (0.056, 0.036, 1.0), "foot": (0.038, 0.034, 1.2), "toes": (0.030, 0.022, 1.5),
    "lowerback": (0.105, 0.098, 1.4), "upperback": (0.098, 0.108, 1.4), "thorax": (0.108, 0.070, 1.4),
    "lowerneck": (0.058, 0.050, 1.0), "upperneck": (0.050, 0.050, 1.0), "head": (0.072, 0.086, 0.88),
    "clavicle": (0.050, 0.052, 1.0), "humerus": (0.048, 0.040, 1.0), "radius": (0.040, 0.030, 1.0),
    "wrist": (0.029, 0.025, 1.0), "hand": (0.024, 0.024, 1.0), "fingers": (0.020, 0.011, 1.0),
    "thumb": (0.014, 0.010, 1.0),
}  # fmt: skip
HEAD_ENDS = (0.28, 0.58)  # shares of the head's bone that the centres of chin and crown stand at


def shape_of(bone_name):
    plain = bone_name if bone_name in SHAPES else bone_name[1:]  # lfemur and rfemur: femur
    return SHAPES[plain]


def has_volume(bone):
    return shape_of(bone.name)[0] > 0


def part_of(bone):
    """The limb, named by the bone it begins with; or the trunk."""
    for above in (bone, *bone.parent_recursive):
        if above.name[1:] in ("humerus", "femur"):
            return above.name
    return "trunk"


def every_fourth_frame(bvh, folder):
    """The BVH with a quarter of its frames, in a file in `folder`."""
    head, rows = bvh.read_text().split("MOTION\n")
    _, frame_time, *rows = rows.splitlines()
    seconds = float(frame_time.split(":")[1]) * EVERY
    rows = rows[::EVERY]
    thinned = folder / "human_walk_30.bvh"
    thinned.write_text(f"{head}MOTION\nFrames: {len(rows)}\nFrame Time: {seconds}\n" + "\n".join(rows) + "\n")
    return thinned


def read_armature(bvh):
    bpy.context.scene.render.fps = 30
    # Debian's Blender 3.4 runs on Python 3.11, which no longer knows the mode "rU" that its importer asks for.
    import_bvh.open = lambda path, _mode: open(path)
    bpy.ops.import_anim.bvh(filepath=str(bvh), global_scale=METRES_PER_UNIT, axis_forward="-Z", axis_up="Y",
                            rotate_mode="QUATERNION", update_scene_duration=True)
    armature = bpy.context.object
    armature.name = armature.data.name = "human"
    armature.animation_data.action.name = "walk"
    bpy.context.scene.frame_end = int(armature.animation_data.action.frame_range[1])
    return armature


def capsule(mesh, bone):
    """Spheres along the bone, as many as make a smooth capsule of them; flattened, where it is wider than deep."""
    head_radius, tail_radius, width = shape_of(bone.name)
    first, last = HEAD_ENDS if bone.name == "head" else (0.0, 1.0)
    steps = max(2, int(bone.length / (0.4 * min(head_radius, tail_radius))))
    for step in range(steps + 1):
        share = first + (last - first) * step / steps
        radius = head_radius + step / steps * (tail_radius - head_radius)
        place = Matrix.Translation(bone.head_local.lerp(bone.tail_local, share)) @ Matrix.Diagonal((width, 1, 1, 1))
        bmesh.ops.create_icosphere(mesh, subdivisions=2, radius=radius, matrix=place)


def make_part(name, bones, armature):
    """The surface of these bones, bound to them."""
    capsules = bmesh.new()
    for bone in bones:
        capsule(capsules, bone)
    part = bpy.data.objects.new(name, bpy.data.meshes.new(name))
    capsules.to_mesh(part.data)
    bpy.context.collection.objects.link(part)
    bpy.context.view_layer.objects.active = part
    part.matrix_world = armature.matrix_world
    part.data.remesh_voxel_size = VOXEL
    bpy.ops.object.voxel_remesh()
    smooth = part.modifiers.new("smooth", "SMOOTH")
    smooth.factor, smooth.iterations = 0.5, 4
    fewer = part.modifiers.new("fewer", "DECIMATE")
    fewer.ratio = 0.12
    for modifier in ("smooth", "fewer"):
        bpy.ops.object.modifier_apply(modifier=modifier)
    for polygon in part.data.polygons:
        polygon.use_smooth = True
    groups = {bone.name: part.vertex_groups.new(name=bone.name) for bone in bones}
    for vertex in part.data.vertices:
        for weight, name in skin_weights(vertex.co, bones):
            groups[name].add([vertex.index], weight, "REPLACE")
    return part


def make_body(armature):
    bones_of = {}
    for bone in filter(has_volume, armature.data.bones):
        bones_of.setdefault(part_of(bone), []).append(bone)
    parts = [make_part(name, bones, armature) for name, bones in bones_of.items()]
    bpy.ops.object.select_all(action="DESELECT")
    for part in parts:
        part.select_set(True)
    bpy.ops.object.join()  # onto the active one, which was made last; groups of one name become one
    body = bpy.context.object
    body.name = body.data.name = "body"
    body.parent = armature
    body.matrix_parent_inverse = armature.matrix_world.inverted()
    body.modifiers.new("armature", "ARMATURE").object = armature
    return body


def distance_to_bone(point, bone):
    """From the bone's capsule rather than its line, in radii: thick bones reach farther."""
    along = bone.tail_local - bone.head_local
    share = (point - bone.head_local).dot(along) / max(along.length_squared, 1e-12)
    share = min(max(share, 0.0), 1.0)
    head_radius, tail_radius, _ = shape_of(bone.name)
    radius = head_radius * (1 - share) + tail_radius * share
    return (point - (bone.head_local + share * along)).length / radius


def skin_weights(point, bones):
    """The nearest bones by the inverse eighth power of the distance in radii."""
    near = sorted((distance_to_bone(point, bone), bone.name) for bone in bones)[:BONES_A_VERTEX]
    weights = [(max(distance, 1e-3) ** -8, name) for distance, name in near]
    total = sum(weight for weight, _ in weights)
    return [(weight / total, name) for weight, name in weights if weight / total > 0.01]


def paint(body):
    skin = bpy.data.materials.new("skin")
    skin.use_nodes = True
    shader = skin.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (0.42, 0.33, 0.27, 1)
    shader.inputs["Roughness"].default_value = 0.7
    body.data.materials.append(skin)


def main():
    bvh, folder = (Path(name) for name in sys.argv[sys.argv.index("--") + 1:])
    bpy.ops.object.select_all(action="SELECT")
    bpy.ops.object.delete()
    armature = read_armature(every_fourth_frame(bvh, bvh.parent))
    body = make_body(armature)
    paint(body)
    bpy.context.view_layer.objects.active = armature
    bpy.ops.export_scene.gltf(filepath=str(folder / "character.glb"), export_format="GLB",
                              export_force_sampling=True, export_optimize_animation_size=True,
                              export_copyright="CC0 1.0")
    bpy.ops.export_scene.fbx(filepath=str(folder / "character.fbx"), object_types={"ARMATURE", "MESH"},
                             add_leaf_bones=False, bake_anim_use_all_actions=False,
                             bake_anim_use_nla_strips=False, bake_anim_simplify_factor=0.0)
    print(f"character: {len(body.data.vertices)} vertices, {len(armature.data.bones)} bones")


main()
