# SPDX-License-Identifier: GPL-3.0-or-later
"""Armatures: made from a clip's skeleton, given its motion, and read back into joints and poses."""
from array import array

import bpy

from . import bvh, rotation
from .program import Failure

Z_UP = rotation.about_axis(0, 1.5707963267948966)  # Blender's axes from those of a clip, Y up
LONGEST_NAME = 63  # bytes that Blender keeps
STILL = 1e-3  # cm: a joint that moves less in its parent does not move

ROTATION_PATHS = {"QUATERNION": "rotation_quaternion", "AXIS_ANGLE": "rotation_axis_angle"}


def bone_name(name):
    """A name as Blender keeps it."""
    return name.encode()[:LONGEST_NAME].decode(errors="ignore")


def rest_heads(joints):
    """Where the joints are at rest."""
    heads = []
    for joint in joints:
        parent = heads[joint.parent] if joint.parent >= 0 else rotation.ORIGIN
        heads.append(rotation.add(parent, joint.offset))
    return heads


class Space:
    """From a clip's centimetres, Y up, to an object's own space, and back."""

    def __init__(self, matrix_world, units_per_cm):
        place, turn, stretch = matrix_world.decompose()
        size = sum(stretch) / 3
        if min(stretch) <= 0 or max(stretch) - min(stretch) > 1e-4 * size:
            raise Failure("The armature is scaled unevenly: apply its scale first (Ctrl+A)")
        self.to_object = rotation.inverse(rotation.normalised(tuple(turn)))
        self.turn = rotation.multiply(self.to_object, Z_UP)
        self.size = units_per_cm / size
        self.place = rotation.scale(rotation.rotate(self.to_object, tuple(place)), -1 / size)

    def vector(self, v):
        return rotation.scale(rotation.rotate(self.turn, v), self.size)

    def point(self, p):
        return rotation.add(self.vector(p), self.place)

    def rotation(self, q):
        """A turn in the world, seen in the object."""
        return rotation.multiply(rotation.multiply(self.turn, q), rotation.inverse(self.turn))

    def clip_point(self, p):
        away = rotation.subtract(p, self.place)
        return rotation.scale(rotation.rotate(rotation.inverse(self.turn), away), 1 / self.size)


class RestBone:
    """A bone at rest, in its armature's space."""

    def __init__(self, bone):
        self.name = bone.name
        self.parent = bone.parent.name if bone.parent else None
        self.head = tuple(bone.head_local)
        self.tail = tuple(bone.tail_local)
        self.turn = rotation.from_rows(bone.matrix_local)
        self.connected = bone.use_connect
        self.turns_along = bone.use_inherit_rotation
        self.moves_locally = bone.use_local_location


def rest_bones(armature):
    """By name, parents first."""
    bones = {}
    waiting = [bone for bone in armature.bones if not bone.parent]
    while waiting:
        bone = waiting.pop(0)
        bones[bone.name] = RestBone(bone)
        waiting.extend(bone.children)
    return bones


# Making one

def depths(joints):
    """The length of the longest chain of joints below each joint."""
    below = [0] * len(joints)
    for index in range(len(joints) - 1, -1, -1):
        parent = joints[index].parent
        if parent >= 0:
            below[parent] = max(below[parent], below[index] + 1)
    return below


def bone_ends(joints):
    """For each joint the way to the tail of its bone, in cm. No bone is too short for Blender."""
    children = [[] for _ in joints]
    for index, joint in enumerate(joints):
        if joint.parent >= 0:
            children[joint.parent].append(index)
    below = depths(joints)
    lengths = [rotation.length(joint.offset) for joint in joints if joint.parent >= 0]
    usual = sum(lengths) / len(lengths) if any(lengths) else 10.0
    ends = []
    for index, joint in enumerate(joints):
        here = [joints[child].offset for child in children[index]]
        end = joint.end
        if here:
            mean = tuple(sum(axis) / len(here) for axis in zip(*here))
            deepest = max(children[index], key=lambda child: below[child])
            # Hips lie between legs and spine: there the mean says nothing.
            far = rotation.length(mean) >= 0.25 * max(map(rotation.length, here))
            end = mean if far else joints[deepest].offset
        if end is None or rotation.length(end) < 0.01 * usual:
            end = ends[joint.parent] if joint.parent >= 0 else (0.0, 1.0, 0.0)
            end = rotation.scale(end, 0.25 * usual / rotation.length(end))
        ends.append(end)
    return ends


def make(context, name, clip, units_per_cm):
    """A new armature with the clip's joints, the active object of the scene. Returns it and the
    bone of every joint."""
    if context.object and context.object.mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.object.select_all(action="DESELECT")
    figure = bpy.data.objects.new(name, bpy.data.armatures.new(name))
    context.collection.objects.link(figure)
    figure.select_set(True)
    context.view_layer.objects.active = figure
    space = Space(figure.matrix_world, units_per_cm)
    ends = bone_ends(clip.joints)
    heads = rest_heads(clip.joints)
    bpy.ops.object.mode_set(mode="EDIT")
    made = []
    for joint, head, end in zip(clip.joints, heads, ends):
        bone = figure.data.edit_bones.new(bone_name(joint.name))
        bone.head = space.point(head)
        bone.tail = space.point(rotation.add(head, end))
        if joint.parent >= 0:
            bone.parent = made[joint.parent]
            bone.use_connect = not joint.moves and joint.offset == ends[joint.parent]
        made.append(bone)
    names = [bone.name for bone in made]
    bpy.ops.object.mode_set(mode="OBJECT")
    return figure, names


# Giving it a motion

def match(joints, words, armature):
    """For each joint the bone of its name, or None. `words`: other names to try."""
    free = {}
    for bone in armature.bones:
        free.setdefault(bvh.joint_name(bone.name), bone.name)
    found = []
    for joint, word in zip(joints, words):
        name = next((one for one in map(bone_name, (joint.name, word)) if one in free), None)
        found.append(free.pop(name) if name is not None else None)
    return found


def rest_differences(joints, bone_of, bones, space):
    """For each joint the turn from its bone's rest to the clip's rest: that which takes the next
    bones where the clip has the next joints. A last joint is turned as its parent."""
    heads = rest_heads(joints)
    pairs = [[] for _ in joints]
    above = []  # the nearest joint above that has a bone
    for index, joint in enumerate(joints):
        up = joint.parent
        while up >= 0 and bone_of[up] is None:
            up = joints[up].parent
        above.append(up)
        if up >= 0 and bone_of[index] is not None:
            has = rotation.subtract(bones[bone_of[index]].head, bones[bone_of[up]].head)
            should = space.vector(rotation.subtract(heads[index], heads[up]))
            pairs[up].append((has, should))
    turns = []
    for up, here in zip(above, pairs):
        if any(rotation.length(has) * rotation.length(should) > 0 for has, should in here):
            turns.append(rotation.between(here))
        else:
            turns.append(turns[up] if up >= 0 else rotation.IDENTITY)
    return turns


class Curves:
    """The values of one channel of a bone in every frame, for F-curves."""

    def __init__(self, path, count):
        self.path = path
        self.values = [array("f") for _ in range(count)]

    def append(self, values):
        for curve, value in zip(self.values, values):
            curve.append(value)

    def write(self, new_curve, group, frames):
        kinds = bpy.types.Keyframe.bl_rna.properties["interpolation"].enum_items
        for index, values in enumerate(self.values):
            curve = new_curve(self.path, index, group)
            points = curve.keyframe_points
            points.add(len(frames))
            points.foreach_set("co", [x for pair in zip(frames, values) for x in pair])
            points.foreach_set("interpolation", [kinds["LINEAR"].value] * len(frames))
            curve.update()


def curve_maker(action, figure):
    """Makes F-curves of an action: since Blender 5 they belong to a slot of it."""
    if hasattr(action, "fcurves"):
        return lambda path, index, group: action.fcurves.new(path, index=index, action_group=group)
    slot = action.slots.new(id_type="OBJECT", name=figure.name)
    strip = action.layers.new("Clip").strips.new(type="KEYFRAME")
    curves = strip.channelbag(slot, ensure=True).fcurves
    return lambda path, index, group: curves.new(path, index=index, group_name=group)


def play(figure, action):
    data = figure.animation_data or figure.animation_data_create()
    data.action = action
    if hasattr(data, "action_slot") and data.action_slot is None:
        data.action_slot = action.slots[0]


def blender_axes(mode):
    """An order such as "XYZ" turns about X first, and so has it rightmost."""
    return tuple("XYZ".index(letter) for letter in reversed(mode))


def rotation_values(mode, q, before):
    """A turn as a bone keeps it, near to that of the frame before."""
    if mode == "QUATERNION":
        return tuple(-x for x in q) if before and rotation.dot(q, before) < 0 else q
    if mode == "AXIS_ANGLE":
        return rotation.axis_angle(q)
    axes = blender_axes(mode)
    before = before and tuple(before[axis] for axis in axes)
    found = rotation.angles(q, axes, before)
    return tuple(found[axes.index(axis)] for axis in range(3))


def basis(bone):
    """The place and turn that a bone without a joint stays in."""
    return tuple(bone.matrix_basis.translation), rotation.from_rows(bone.matrix_basis.normalized())


def animate(figure, clip, bone_of, name, frames, units_per_cm):
    """Makes an action of the clip for the bones of its joints. A generator: yields the share
    done."""
    space = Space(figure.matrix_world, units_per_cm)
    bones = rest_bones(figure.data)
    differences = rest_differences(clip.joints, bone_of, bones, space)
    joint_of = {bone: joint for joint, bone in enumerate(bone_of) if bone is not None}
    fixed, turning, moving = {}, {}, {}
    for bone in figure.pose.bones:
        joint = joint_of.get(bone.name)
        if joint is None:
            fixed[bone.name] = basis(bone)
            continue
        bone.location = (0, 0, 0)
        bone.scale = (1, 1, 1)
        path = ROTATION_PATHS.get(bone.rotation_mode, "rotation_euler")
        count = 3 if path == "rotation_euler" else 4
        turning[bone.name] = Curves(bone.path_from_id(path), count)
        if clip.joints[joint].moves and not bones[bone.name].connected:
            moving[bone.name] = Curves(bone.path_from_id("location"), 3)

    before = {}
    modes = {bone.name: bone.rotation_mode for bone in figure.pose.bones}
    for number, row in enumerate(clip.rows):
        if number % 50 == 0:
            yield number / len(clip.rows)
        world = []  # turns of the joints, in the clip's axes
        pose = clip.pose(row)
        for joint, (_, turn) in zip(clip.joints, pose):
            world.append(rotation.multiply(world[joint.parent], turn) if joint.parent >= 0 else turn)
        posed = {}  # head and turn of each bone, in the armature's space
        for bone in bones.values():
            joint = joint_of.get(bone.name)
            # Where it is while nothing moves it, and the axes along which it would be moved.
            origin, base, along = bone.head, bone.turn, bone.turn
            if bone.parent is None:
                along = bone.turn if bone.moves_locally else rotation.IDENTITY
            else:
                parent = bones[bone.parent]
                head, turn = posed[bone.parent]
                carried = rotation.multiply(turn, rotation.inverse(parent.turn))
                away = rotation.subtract(bone.head, parent.head)
                origin = rotation.add(head, rotation.rotate(carried, away))
                along = rotation.multiply(carried, bone.turn) if bone.moves_locally else turn
                if bone.turns_along:
                    base = rotation.multiply(carried, bone.turn)
            if joint is None:
                moved, turned = fixed[bone.name]
                posed[bone.name] = (rotation.add(origin, rotation.rotate(along, moved)),
                                    rotation.multiply(base, turned))
                continue
            turn = rotation.multiply(rotation.multiply(space.rotation(world[joint]),
                                                       differences[joint]), bone.turn)
            head = origin
            if bone.name in moving:
                parent = clip.joints[joint].parent
                moved = pose[joint][0]
                if parent < 0:
                    head = space.point(rotation.add(clip.joints[joint].offset, moved))
                elif not any(clip.joints[joint].offset) and bone_of[parent] is not None:
                    # It has no place of its own in its parent (see Recorder.settle).
                    head = rotation.add(posed[bone_of[parent]][0],
                                        space.vector(rotation.rotate(world[parent], moved)))
                else:
                    head = rotation.add(origin,
                                        space.vector(rotation.rotate(world[parent], moved)))
                away = rotation.subtract(head, origin)
                moving[bone.name].append(rotation.rotate(rotation.inverse(along), away))
            posed[bone.name] = (head, turn)
            local = rotation.multiply(rotation.inverse(base), turn)
            values = rotation_values(modes[bone.name], local, before.get(bone.name))
            before[bone.name] = values
            turning[bone.name].append(values)

    action = bpy.data.actions.new(name)
    action.use_fake_user = True  # an armature keeps only one of several clips
    new_curve = curve_maker(action, figure)
    for bone in turning:
        for curves in (moving.get(bone), turning[bone]):
            if curves:
                curves.write(new_curve, bone, frames)
    play(figure, action)


# Reading it back

class Recorder:
    """The joints of an armature, and their poses as the scene has them from frame to frame."""

    def __init__(self, figure, only_deform, units_per_cm):
        self.figure = figure
        self.units_per_cm = units_per_cm
        bones = rest_bones(figure.data)
        self.rest = {name: bone for name, bone in bones.items()
                     if figure.data.bones[name].use_deform or not only_deform}
        if not self.rest:
            raise Failure("The armature has no bones that deform" if only_deform
                          else "The armature has no bones")
        # At rest joints are turned as the world, so that all turns are those since rest.
        self.space = Space(figure.matrix_world, units_per_cm)
        names = list(self.rest)
        self.joints = []
        parents = set()
        for bone in self.rest.values():
            up = bone.parent
            while up is not None and up not in self.rest:
                up = bones[up].parent
            head = self.space.clip_point(bone.head)
            parents.add(up)
            if up is not None:
                head = rotation.subtract(head, self.space.clip_point(self.rest[up].head))
            self.joints.append(bvh.Joint(bone.name, names.index(up) if up is not None else -1, head,
                                         moves=up is None))
        for joint, bone in zip(self.joints, self.rest.values()):
            if bone.name not in parents:
                joint.end = rotation.subtract(self.space.clip_point(bone.tail),
                                              self.space.clip_point(bone.head))
        self.poses = []
        self.scaled = set()  # bones whose scale is left out

    def record(self, depsgraph):
        figure = self.figure.evaluated_get(depsgraph)
        space = Space(figure.matrix_world, self.units_per_cm)
        world = []
        pose = []
        for joint, bone in zip(self.joints, self.rest.values()):
            matrix = figure.pose.bones[bone.name].matrix
            if max(abs(size - 1) for size in matrix.to_scale()) > 1e-3:
                self.scaled.add(bone.name)
            since_rest = rotation.multiply(rotation.from_rows(matrix.normalized()),
                                           rotation.inverse(bone.turn))
            # An armature that turns as a whole turns its joints.
            turn = rotation.multiply(rotation.multiply(rotation.inverse(space.turn), since_rest),
                                     self.space.turn)
            at = space.clip_point(tuple(matrix.translation))
            if joint.parent >= 0:
                up_at, up_turn = world[joint.parent]
                back = rotation.inverse(up_turn)
                moved = rotation.subtract(rotation.rotate(back, rotation.subtract(at, up_at)),
                                          joint.offset)
                pose.append((moved, rotation.normalised(rotation.multiply(back, turn))))
            else:
                pose.append((rotation.subtract(at, joint.offset), rotation.normalised(turn)))
            world.append((at, turn))
        self.poses.append(pose)

    def settle(self):
        """Says which joints move, once all poses are there. Returns the bones that lose the place
        they rest in, because they hardly ever are there.

        A BVH does not say whether positions replace OFFSET; the program goes by whether they are
        near to it."""
        displaced = []
        for index, joint in enumerate(self.joints):
            if joint.parent < 0:
                continue
            moved = [pose[index][0] for pose in self.poses]
            if max(map(rotation.length, moved)) <= STILL:
                continue
            joint.moves = True
            mean = rotation.scale((sum(m[0] for m in moved), sum(m[1] for m in moved),
                                   sum(m[2] for m in moved)), 1 / len(moved))
            offset = joint.offset
            if abs(rotation.dot(mean, offset)) > 0.2 * rotation.dot(offset, offset) > 0:
                displaced.append(joint.name)
                joint.offset = rotation.ORIGIN
                for number, pose in enumerate(self.poses):
                    pose[index] = (rotation.add(moved[number], offset), pose[index][1])
        return displaced
