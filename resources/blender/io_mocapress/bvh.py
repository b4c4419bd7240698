# SPDX-License-Identifier: GPL-3.0-or-later
"""BVH text in full precision, as the program `mocapress` writes and reads it.

Blender's own BVH add-on rounds to six decimals and knows another convention for the root. Here the
root's positions add to its OFFSET (`--bvh-root add`); those of other joints replace theirs.
"""
from array import array
from dataclasses import dataclass
from math import degrees, radians

from . import rotation

ANGLES = (2, 0, 1)  # the order that is written: Z X Y


@dataclass
class Joint:
    name: str
    parent: int  # -1: a root
    offset: tuple  # from the parent, with every joint at rest
    end: tuple = None  # where the bone of a joint without children ends
    moves: bool = False  # has position channels


@dataclass
class Clip:
    """A skeleton in motion. Lengths are as in the file: centimetres, where it is ours."""
    joints: list  # parents first
    rate: float  # frames per second
    rows: list  # for each frame, an array of the file's values
    channels: list  # for each joint, (first column, its axes in order, 0-2 positions, 3-5 turns)

    def pose(self, row):
        """For each joint how far it is from its rest place in its parent, and its turn in there."""
        pose = []
        for joint, (column, axes) in zip(self.joints, self.channels):
            moved = [0.0, 0.0, 0.0]
            turn = rotation.IDENTITY
            for value, axis in zip(row[column:column + len(axes)], axes):
                if axis >= 3:
                    turn = rotation.multiply(turn, rotation.about_axis(axis - 3, radians(value)))
                else:
                    moved[axis] = value - (joint.offset[axis] if joint.parent >= 0 else 0)
            pose.append((tuple(moved), turn))
        return pose


def read(text):
    """The Clip of a text that the program has written. ValueError or IndexError: it has not."""
    header, _, motion = text.partition("\nMOTION\n")
    joints, channels, open_joints = [], [], []
    columns = 0
    in_end = False
    for line in header.splitlines():
        keyword, _, rest = line.strip().partition(" ")
        if keyword in ("ROOT", "JOINT"):
            joints.append(Joint(rest, open_joints[-1] if open_joints else -1, rotation.ORIGIN))
            channels.append((columns, ()))
            open_joints.append(len(joints) - 1)
        elif keyword == "End":
            in_end = True
        elif keyword == "OFFSET":
            offset = tuple(float(word) for word in rest.split())
            if in_end:
                joints[open_joints[-1]].end = offset
            else:
                joints[open_joints[-1]].offset = offset
        elif keyword == "CHANNELS":
            axes = tuple("XYZ".index(word[0]) + 3 * word.endswith("rotation")
                         for word in rest.split()[1:])
            channels[-1] = (columns, axes)
            joints[-1].moves = min(axes, default=3) < 3
            columns += len(axes)
        elif keyword == "}":
            if in_end:
                in_end = False
            else:
                open_joints.pop()
    lines = motion.splitlines()
    rate = 1 / float(lines[1].split()[-1])
    if abs(rate - round(rate)) < 1e-6 * rate:
        rate = float(round(rate))
    rows = [array("d", map(float, line.split())) for line in lines[2:]]
    if not rows or any(len(row) != columns for row in rows):
        raise ValueError("frames of another number of values")
    return Clip(joints, rate, rows, channels)


def joint_name(name):
    """A bone's name as a BVH can hold it: on one line, without braces."""
    return "".join("_" if c in "{}" or not c.isprintable() else c for c in name).strip() or "_"


def _number(value):
    return format(value, ".9g")


def _vector(values):
    return " ".join(map(_number, values))


def write(joints, rate, poses):
    """The text of a clip. `poses`: for each frame what Clip.pose() gives."""
    children = [[] for _ in joints]
    order = []  # as braces nest
    for index, joint in enumerate(joints):
        if joint.parent >= 0:
            children[joint.parent].append(index)
    lines = ["HIERARCHY"]

    def write_joint(index):
        joint = joints[index]
        order.append(index)
        lines.append(f"{'ROOT' if joint.parent < 0 else 'JOINT'} {joint_name(joint.name)}")
        lines.append("{")
        lines.append(f"OFFSET {_vector(joint.offset)}")
        positions = "6 Xposition Yposition Zposition" if joint.moves else "3"
        turns = " ".join("XYZ"[axis] + "rotation" for axis in ANGLES)
        lines.append(f"CHANNELS {positions} {turns}")
        for child in children[index]:
            write_joint(child)
        if joint.end:
            lines.extend(("End Site", "{", f"OFFSET {_vector(joint.end)}", "}"))
        lines.append("}")

    for index, joint in enumerate(joints):
        if joint.parent < 0:
            write_joint(index)
    lines.extend(("MOTION", f"Frames: {len(poses)}", f"Frame Time: {1 / rate:.12g}"))
    before = [(0.0, 0.0, 0.0)] * len(joints)
    for pose in poses:
        words = []
        for index in order:
            joint = joints[index]
            moved, turn = pose[index]
            if joint.moves:
                at = moved if joint.parent < 0 else rotation.add(joint.offset, moved)
                words.append(_vector(at))
            before[index] = rotation.angles(turn, ANGLES, before[index])
            words.append(_vector(map(degrees, before[index])))
        lines.append(" ".join(words))
    return "\n".join(lines) + "\n"
