# SPDX-License-Identifier: GPL-3.0-or-later
# The add-on for Blender, installed from its zip into a Blender without a window.
# Usage: blender_addon_test.py BLENDER MOCAPRESS ADDON.zip SAMPLES [FOLDER_OF_THE_PYTHON_PACKAGE]
# Exit code 77: Blender does not start.
import contextlib
import ctypes
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import threading
import unittest
from unittest import mock

try:
    import addon_utils
    import bpy
    import mathutils
except ImportError:
    bpy = None  # outside of Blender

WITHIN = 1e-3  # cm


def start(blender, *words):
    """Runs this file in a Blender that has a folder for its user of its own."""
    with tempfile.TemporaryDirectory() as folder:
        started = os.path.join(folder, "started")
        words = [os.path.abspath(word) for word in words]
        environment = {**os.environ, "BLENDER_USER_SCRIPTS": os.path.join(folder, "scripts"),
                       "BLENDER_USER_CONFIG": os.path.join(folder, "config"), "TMPDIR": folder}
        code = subprocess.run([blender, "--background", "--factory-startup", "--python-exit-code",
                               "1", "--python", os.path.abspath(__file__), "--", folder, *words],
                              env=environment, check=False).returncode
        left = [name for name in os.listdir(folder) if name.startswith("mocapress-")]
        if left:
            sys.exit(f"left behind: {left}")
        return code if os.path.exists(started) else 77


# Positions by other means than the add-on's: matrices.

def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def apply(a, v):
    return [sum(a[i][k] * v[k] for k in range(3)) for i in range(3)]


def turn(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    m = [[float(row == column) for column in range(3)] for row in range(3)]
    m[i][i], m[i][j], m[j][i], m[j][j] = c, -s, s, c
    return m


def positions(path):
    """Where a BVH whose positions replace OFFSET puts its joints: names, and a list of places for
    each frame."""
    words = pathlib.Path(path).read_text().split()
    joints, stack = [], []  # joints: name, parent, offset, channels
    at = 0
    while words[at] != "MOTION":
        word = words[at]
        if word in ("ROOT", "JOINT"):
            joints.append([words[at + 1], stack[-1] if stack else None, None, []])
        elif word == "{":
            stack.append(len(joints) - 1)
        elif word == "}":
            stack.pop()
        elif word == "OFFSET" and joints[stack[-1]][2] is None:
            joints[stack[-1]][2] = [float(x) for x in words[at + 1:at + 4]]
        elif word == "CHANNELS":
            joints[stack[-1]][3] = words[at + 2:at + 2 + int(words[at + 1])]
        at += 1
    values = [float(x) for x in words[words.index("Time:") + 2:]]
    frames = []
    while values:
        heads, turns = [], []
        used = 0
        for _, parent, offset, channels in joints:
            place, rotation = list(offset), turn(0, 0)
            for channel in channels:
                value, axis = values[used], "XYZ".index(channel[0])
                used += 1
                if channel.endswith("position"):
                    place[axis] = value
                else:
                    rotation = times(rotation, turn(axis, value))
            if parent is not None:
                place = [a + b for a, b in zip(heads[parent], apply(turns[parent], place))]
                rotation = times(turns[parent], rotation)
            heads.append(place)
            turns.append(rotation)
        del values[:used]
        frames.append(heads)
    return [joint[0] for joint in joints], frames


def distance(a, b):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)))


# Figures

def wave(frame, number):
    return math.sin(0.15 * frame + 1.7 * number)


def awkward_bvh(frames=40):
    """Joints that move, names of several words, one name twice, joints at one place, two roots."""
    text = """HIERARCHY
ROOT L Thigh
{
OFFSET 3 90 1
CHANNELS 6 Xposition Yposition Zposition Yrotation Xrotation Zrotation
JOINT twice
{
OFFSET 0 0 0
CHANNELS 1 Xrotation
JOINT moves
{
OFFSET 4 20 -3
CHANNELS 4 Zposition Zrotation Xrotation Yrotation
JOINT twice
{
OFFSET 5 0 0
CHANNELS 2 Yrotation Zrotation
}
JOINT End
{
OFFSET -5 1 0
CHANNELS 3 Zrotation Yrotation Xrotation
End Site
{
OFFSET 0 0 0
}
}
}
}
}
ROOT second
{
OFFSET 70 10 5
CHANNELS 2 Xposition Zrotation
}
MOTION
"""
    columns = 18
    text += f"Frames: {frames}\nFrame Time: {1 / 30!r}\n"
    for frame in range(frames):
        text += " ".join(str(50 * wave(frame, column)) for column in range(columns)) + "\n"
    return text


MIXAMO = (  # name, parent, head, tail in cm (Y up), roll
    ("Hips", None, (0, 100, 0), (0, 110, 0), 0.3),
    ("Spine", "Hips", (0, 110, 0), (0, 125, -1), 0.0),
    ("Spine1", "Spine", (0, 125, -1), (0, 150, -2), -1.0),
    ("Head", "Spine1", (0, 158, -1), (0, 178, 0), 0.0),
    ("LeftArm", "Spine1", (18, 145, -3), (46, 145, -3), 1.2),
    ("LeftForeArm", "LeftArm", (46, 145, -3), (72, 145, -2), 1.2),
    ("LeftHand", "LeftForeArm", (72, 145, -2), (82, 145, 0), 2.0),
    ("RightArm", "Spine1", (-18, 145, -3), (-46, 145, -3), -1.2),
    ("RightForeArm", "RightArm", (-46, 145, -3), (-72, 145, -2), -1.2),
    ("LeftUpLeg", "Hips", (9, 95, 0), (9, 52, 1), 0.0),
    ("LeftLeg", "LeftUpLeg", (9, 52, 1), (9, 10, -2), 0.5),
    ("LeftFoot", "LeftLeg", (9, 10, -2), (9, 0, 12), 3.0),
    ("RightUpLeg", "Hips", (-9, 95, 0), (-9, 52, 1), 0.0),
    ("RightLeg", "RightUpLeg", (-9, 52, 1), (-9, 10, -2), -0.5),
    ("RightFoot", "RightLeg", (-9, 10, -2), (-9, 0, 12), -3.0))


def make_mixamo(posed=True):
    """As an FBX from there comes in: bones in cm with Y up, in an object of a hundredth's size that
    lies on its back; with an action of 60 frames."""
    data = bpy.data.armatures.new("Armature")
    rig = bpy.data.objects.new("Armature", data)
    bpy.context.collection.objects.link(rig)
    bpy.context.view_layer.objects.active = rig
    rig.select_set(True)
    rig.scale = (0.01,) * 3
    rig.rotation_euler = (math.pi / 2, 0, 0)
    bpy.ops.object.mode_set(mode="EDIT")
    for name, parent, head, tail, roll in MIXAMO:
        bone = data.edit_bones.new("mixamorig:" + name)
        bone.head, bone.tail, bone.roll = head, tail, roll
        if parent:
            bone.parent = data.edit_bones["mixamorig:" + parent]
            bone.use_connect = distance(bone.parent.tail, bone.head) < 1e-6
    bpy.ops.object.mode_set(mode="OBJECT")
    if posed:
        rig.animation_data_create().action = bpy.data.actions.new("dance")
        for number, bone in enumerate(rig.pose.bones):
            bone.rotation_mode = ("QUATERNION", "XYZ", "ZXY", "AXIS_ANGLE")[number % 4]
            for frame in range(0, 60, 3):
                angles = [0.5 * wave(frame, number), 0.3 * wave(frame, 2 * number), 0.2]
                bone.matrix_basis = mathutils.Euler(angles).to_matrix().to_4x4()
                if number == 0:
                    bone.location = (30 * wave(frame, 1), 5 * wave(frame, 2), frame)
                    bone.keyframe_insert("location", frame=10 + frame)
                path = {"QUATERNION": "rotation_quaternion", "AXIS_ANGLE": "rotation_axis_angle"}
                bone.keyframe_insert(path.get(bone.rotation_mode, "rotation_euler"),
                                     frame=10 + frame)
    bpy.context.view_layer.update()
    return rig


def heads_of(rig, frames):
    """The head of every bone in every frame, in cm, Y up."""
    rows = []
    for frame in frames:
        bpy.context.scene.frame_set(frame)
        row = {}
        for bone in rig.pose.bones:
            x, y, z = 100 * (rig.matrix_world @ bone.head)
            row[bone.name] = (x, z, -y)
        rows.append(row)
    return rows


def largest_distance(one, other, names=None):
    return max(distance(a[name], b[name])
               for a, b in zip(one, other, strict=True) for name in names or a)


class Addon(unittest.TestCase):
    def setUp(self):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        bpy.ops.preferences.addon_enable(module="io_mocapress")
        self.preferences().program = MOCAPRESS
        self.folder = pathlib.Path(tempfile.mkdtemp(dir=FOLDER))

    @staticmethod
    def preferences():
        return bpy.context.preferences.addons["io_mocapress"].preferences

    def compress(self, source, name="clip"):
        path = self.folder / f"{name}.mcpr"
        subprocess.run([MOCAPRESS, "compress", source, "-o", path, "--target-error", "0.05"],
                       check=True, capture_output=True)
        return path

    def small_clip(self):
        source = self.folder / "awkward.bvh"
        source.write_text(awkward_bvh())
        return self.compress(source)

    def positions(self, clip):
        """The program's, in cm with Y up."""
        path = self.folder / "positions.bvh"
        subprocess.run([MOCAPRESS, "decompress", clip, "-o", path, "--out-cm-per-unit", "1",
                        "--out-up", "y", "--out-bvh-root", "replace"], check=True)
        return positions(path)

    def bring_in(self, clip, **options):
        self.assertEqual(bpy.ops.import_anim.mocapress(filepath=str(clip), **options), {"FINISHED"})
        return bpy.context.object

    def send_out(self, path, **options):
        self.assertEqual(bpy.ops.export_anim.mocapress(filepath=str(path), **options), {"FINISHED"})

    def refusal(self, operator, **options):
        """The text of the error report; fails without a report."""
        with self.assertRaises(RuntimeError) as refused:
            operator(**options)
        said = str(refused.exception)
        self.assertTrue(said.startswith("Error: "), said)
        self.assertNotIn("Traceback", said)
        return said

    def expect_places(self, rig, clip, words_to_bones=None):
        words, expected = self.positions(clip)
        rename = words_to_bones or {}
        found = heads_of(rig, range(1, len(expected) + 1))
        wanted = [{rename.get(word, word): head for word, head in zip(words, row)}
                  for row in expected]
        self.assertEqual(set(wanted[0]), set(found[0]))
        far = largest_distance(wanted, found)
        print(f"{self.id()}: {far:.2e} cm")
        self.assertLess(far, WITHIN)

    # Importing

    def test_a_sample_stands_where_the_program_puts_it_in_every_frame(self):
        for sample in ("human_walk", "human_run", "human_jump"):
            with self.subTest(sample):
                bpy.ops.wm.read_factory_settings(use_empty=True)
                self.setUp()
                clip = self.compress(SAMPLES / f"{sample}.amc", sample)
                rig = self.bring_in(clip)
                scene = bpy.context.scene
                self.assertEqual(rig.animation_data.action.name, sample)
                self.assertEqual((scene.render.fps, scene.render.fps_base), (120, 1))
                frames = json.loads(subprocess.run(
                    [MOCAPRESS, "info", "--json", clip], capture_output=True).stdout)[0]["frames"]
                self.assertEqual((scene.frame_start, scene.frame_end), (1, frames))
                self.expect_places(rig, clip, {"_root": "root"})

    def test_joints_that_move_and_odd_names_come_in(self):
        clip = self.small_clip()
        rig = self.bring_in(clip)
        self.assertEqual({bone.name for bone in rig.data.bones},
                         {"L Thigh", "twice", "moves", "twice_2", "End", "second"})
        paths = {curve.data_path for curve in rig.animation_data.action.fcurves}
        self.assertEqual({re.search(r'"(.*)"', path)[1] for path in paths if "location" in path},
                         {"L Thigh", "moves", "second"})
        self.expect_places(rig, clip, {"L_Thigh": "L Thigh", "_End": "End"})

    def test_several_clips_of_one_skeleton_become_actions_of_one_armature(self):
        clips = [self.compress(SAMPLES / f"human_{name}.amc", name) for name in ("walk", "jump")]
        self.assertEqual(bpy.ops.import_anim.mocapress(
            directory=str(self.folder), files=[{"name": clip.name} for clip in clips]),
            {"FINISHED"})
        self.assertEqual(len(bpy.data.armatures), 1)
        self.assertEqual({action.name for action in bpy.data.actions}, {"walk", "jump"})
        self.expect_places(bpy.context.object, clips[1], {"_root": "root"})

    def test_the_scene_may_keep_its_rate_and_its_range(self):
        clip = self.small_clip()
        scene = bpy.context.scene
        scene.render.fps = 10
        rig = self.bring_in(clip, set_rate=False, set_range=False, start=5)
        self.assertEqual((scene.render.fps, scene.frame_end), (10, 250))
        self.assertAlmostEqual(rig.animation_data.action.frame_range[1], 5 + 39 / 3, places=4)
        _, expected = self.positions(clip)
        found = heads_of(rig, range(5, 19))
        self.assertLess(max(distance(expected[3 * i][0], found[i]["L Thigh"]) for i in range(14)),
                        WITHIN)

    def test_a_clip_goes_onto_an_armature_in_another_pose_and_place(self):
        clip = self.compress(SAMPLES / "human_walk.amc")
        rig = self.bring_in(clip)
        rig.location, rig.scale, rig.rotation_euler = (3, -2, 1), (2, 2, 2), (0.4, 0.2, -2)
        for number, bone in enumerate(rig.pose.bones):
            bone.rotation_mode = ("QUATERNION", "XYZ", "YXZ", "ZYX", "AXIS_ANGLE")[number % 5]
        rig.animation_data_clear()
        bpy.ops.object.mode_set(mode="POSE")  # another rest pose, of bones as long as before
        for number, bone in enumerate(rig.pose.bones):
            bone.matrix_basis = mathutils.Euler((0.3, 0.1 * (number % 3), 0.2)).to_matrix().to_4x4()
        bpy.ops.pose.armature_apply()
        bpy.ops.object.mode_set(mode="EDIT")
        for bone in rig.data.edit_bones:
            bone.roll += 0.7
        rig.data.edit_bones["lhand"].use_inherit_rotation = False
        rig.data.edit_bones["root"].use_local_location = False
        bpy.ops.object.mode_set(mode="OBJECT")
        bpy.context.view_layer.update()
        # Lengths in the world are to be those of the clip.
        self.bring_in(clip, target="SELECTED", units_per_cm=0.02)
        self.assertEqual(len(bpy.data.armatures), 1)
        words, expected = self.positions(clip)
        found = heads_of(rig, range(1, len(expected) + 1))
        wanted = [{{"_root": "root"}.get(word, word): [2 * x for x in head]
                   for word, head in zip(words, row)} for row in expected]
        far = largest_distance(wanted, found)
        print(f"{self.id()}: {far:.2e} cm")
        self.assertLess(far, 2 * WITHIN)

    def test_joints_without_a_bone_are_named(self):
        clip = self.small_clip()
        rig = self.bring_in(clip)
        bpy.ops.object.mode_set(mode="EDIT")
        rig.data.edit_bones.remove(rig.data.edit_bones["moves"])
        bpy.ops.object.mode_set(mode="OBJECT")
        with captured() as said:
            self.bring_in(clip, target="SELECTED")
        self.assertIn("no bone for moves", said())
        make_mixamo(posed=False)
        self.assertIn("no joint has the name of a bone", self.refusal(
            bpy.ops.import_anim.mocapress, filepath=str(clip), target="SELECTED"))
        bpy.context.view_layer.objects.active = None
        self.assertIn("no armature", self.refusal(
            bpy.ops.import_anim.mocapress, filepath=str(clip), target="SELECTED"))

    # There and back

    def test_a_mixamo_rig_comes_back_within_the_error(self):
        rig = make_mixamo()
        frames = range(10, 68)
        before = heads_of(rig, frames)
        path = self.folder / "dance.mcpr"
        bpy.context.scene.frame_set(33)
        self.send_out(path, quality="error", target_error=0.05)
        self.assertEqual(bpy.context.scene.frame_current, 33)
        info = json.loads(subprocess.run([MOCAPRESS, "info", "--json", path],
                                         capture_output=True).stdout)[0]
        self.assertEqual((info["frames"], info["joints"], info["sample_rate_hz"]),
                         (len(frames), len(MIXAMO), 24))
        self.assertEqual(info["channels"], 3 * len(MIXAMO) + 3)  # only the hips move
        self.assertLess(info["eps_x_cm"], 0.05)
        largest = info["max_error_cm"]

        # On the rig itself: names, lengths and rolls are the rig's.
        self.bring_in(path, target="SELECTED", start=10)
        far = largest_distance(before, heads_of(rig, frames))
        print(f"{self.id()}: same rig {far:.3f} cm, the program says at most {largest:.3f}")
        self.assertLess(far, largest + 2 * WITHIN)

        # On a new one: the same joints at the same places.
        new = self.bring_in(path, start=10)
        self.assertIsNot(new, rig)
        self.assertEqual([bone.name for bone in new.data.bones],
                         ["mixamorig:" + one[0] for one in MIXAMO])
        for name, parent, head, tail, _ in MIXAMO:
            bone = new.data.bones["mixamorig:" + name]
            self.assertEqual(bone.parent.name if bone.parent else None,
                             "mixamorig:" + parent if parent else None)
            x, y, z = 100 * bone.head_local
            self.assertLess(distance((x, z, -y), head), WITHIN)
            if not bone.children or name.startswith("Left"):
                self.assertLess(abs(100 * bone.length - distance(head, tail)), WITHIN, name)
        self.assertLess(largest_distance(before, heads_of(new, frames)), largest + 2 * WITHIN)

    def test_a_finer_target_brings_every_joint_closer(self):
        rig = make_mixamo()
        frames = range(10, 68)
        before = heads_of(rig, frames)
        far = {}
        for error in (0.5, 0.005):
            path = self.folder / f"{error}.mcpr"
            bpy.context.view_layer.objects.active = rig
            rig.animation_data.action = bpy.data.actions["dance"]
            self.send_out(path, quality="error", target_error=error)
            far[error] = largest_distance(before, heads_of(self.bring_in(path, start=10), frames))
        print(f"{self.id()}: {far}")
        self.assertLess(far[0.005], 0.05)
        self.assertLess(far[0.005], far[0.5])

    def test_bones_that_move_in_their_parents_are_kept(self):
        rig = make_mixamo()
        head = rig.pose.bones["mixamorig:Head"]  # moves about its place
        arm = rig.pose.bones["mixamorig:LeftArm"]  # leaves it
        for frame in range(10, 68, 3):
            head.location = (3 * wave(frame, 1), 2, 0)
            head.keyframe_insert("location", frame=frame)
            arm.location = (0, 60 + 30 * wave(frame, 2), 0)
            arm.keyframe_insert("location", frame=frame)
        frames = range(10, 68)
        before = heads_of(rig, frames)
        path = self.folder / "moves.mcpr"
        with captured() as said:
            self.send_out(path, quality="error", target_error=0.005)
        self.assertIn("Too far from where they rest, which is not kept: mixamorig:LeftArm", said())
        for target in ("SELECTED", "NEW"):
            rig = self.bring_in(path, start=10, target=target)
            far = largest_distance(before, heads_of(rig, frames))
            print(f"{self.id()}: {target} {far:.4f} cm")
            self.assertLess(far, 0.05)

    def test_every_preset_of_the_program_exports(self):
        help_text = subprocess.run([MOCAPRESS, "batch", "--help"], capture_output=True,
                                   text=True).stdout
        known = re.search(r"--preset P\|FILE +Preset: (.*), or a preset file", help_text)[1].split(", ")
        operator = bpy.ops.export_anim.mocapress.get_rna_type()
        offered = [item.identifier for item in operator.properties["quality"].enum_items]
        self.assertEqual(sorted(offered), sorted([*known, "error"]))
        make_mixamo()
        for preset in known:
            path = self.folder / f"{preset}.mcpr"
            self.send_out(path, quality=preset)
            self.assertTrue(path.exists())

    def test_only_deforming_bones_of_the_scenes_frames(self):
        rig = make_mixamo()
        rig.data.bones["mixamorig:Spine"].use_deform = False
        scene = bpy.context.scene
        scene.frame_start, scene.frame_end = 20, 29
        path = self.folder / "part.mcpr"
        self.send_out(path, only_deform=True, frames="SCENE", quality="error", target_error=0.002)
        before = heads_of(rig, range(20, 30))
        new = self.bring_in(path, start=20)
        self.assertEqual(len(new.data.bones), len(MIXAMO) - 1)
        self.assertEqual(new.data.bones["mixamorig:Spine1"].parent.name, "mixamorig:Hips")
        names = [bone.name for bone in new.data.bones]
        self.assertLess(largest_distance(before, heads_of(new, range(20, 30)), names), 0.05)

    def test_an_uneven_scale_is_refused(self):
        make_mixamo().scale = (0.01, 0.02, 0.01)
        bpy.context.view_layer.update()
        self.assertIn("scaled unevenly", self.refusal(
            bpy.ops.export_anim.mocapress, filepath=str(self.folder / "x.mcpr")))

    # Errors

    def test_a_missing_program_is_reported_with_what_to_do(self):
        clip = self.small_clip()
        self.preferences().program = str(self.folder / "none")
        said = self.refusal(bpy.ops.import_anim.mocapress, filepath=str(clip))
        self.assertIn("There is no program at", said)
        self.assertIn("Preferences > Add-ons", said)
        make_mixamo()
        out = self.folder / "out.mcpr"
        self.assertIn("There is no program at",
                      self.refusal(bpy.ops.export_anim.mocapress, filepath=str(out)))
        self.assertFalse(out.exists())

    def test_the_program_is_found_on_the_path(self):
        clip = self.small_clip()
        self.preferences().program = ""
        path = os.path.dirname(MOCAPRESS) + os.pathsep + os.environ["PATH"]
        with mock.patch.dict(os.environ, PATH=path), \
                mock.patch.object(sys.modules["io_mocapress.package"], "library", None):
            self.bring_in(clip)

    def test_a_damaged_file_gives_the_programs_sentence(self):
        whole = self.small_clip().read_bytes()
        bad = self.folder / "bad.mcpr"
        for content in (b"", whole[:300], b"PK\3\4 something else",
                        whole[:200] + b"\xff" * 50 + whole[250:]):
            bad.write_bytes(content)
            program = subprocess.run([MOCAPRESS, "info", bad], capture_output=True, text=True)
            self.assertNotEqual(program.returncode, 0)
            sentence = program.stderr.strip().removeprefix("mocapress: ")
            self.assertIn(sentence,
                          self.refusal(bpy.ops.import_anim.mocapress, filepath=str(bad)))
        self.assertIn("No such file", self.refusal(bpy.ops.import_anim.mocapress,
                                                   filepath=str(self.folder / "none.mcpr")))
        self.assertEqual(len(bpy.data.objects), 0)

    def test_an_export_that_fails_leaves_the_old_file(self):
        make_mixamo()
        path = self.folder / "old.mcpr"
        path.write_text("old")
        for program in ("/bin/true", "/bin/false"):
            self.preferences().program = program
            self.assertIn("mocapress", self.refusal(bpy.ops.export_anim.mocapress,
                                                    filepath=str(path)))
        self.assertEqual(path.read_text(), "old")
        self.preferences().program = MOCAPRESS
        self.assertIn("No such file", self.refusal(bpy.ops.export_anim.mocapress,
                                                   filepath=str(self.folder / "no/x.mcpr")))

    def test_a_program_that_does_not_end_is_stopped(self):
        sleeper = self.folder / "sleeper"
        sleeper.write_text("#!/bin/sh\nexec sleep 1000\n")
        sleeper.chmod(0o755)
        self.preferences().program = str(sleeper)
        self.preferences().timeout = 1
        self.assertIn("took longer than 1 s", self.refusal(bpy.ops.import_anim.mocapress,
                                                           filepath="x.mcpr"))

    def test_a_program_of_another_kind_is_reported(self):
        for program in ("/bin/true", "/bin/false"):
            self.preferences().program = program
            self.refusal(bpy.ops.import_anim.mocapress, filepath="x.mcpr")

    # The Python package in place of the program

    @contextlib.contextmanager
    def package(self):
        """No program is run meanwhile, nor found."""
        if sys.modules["io_mocapress.package"].library is None:
            self.skipTest("Blender's Python has not both the Python package and NumPy")
        self.preferences().program = ""
        with mock.patch.object(sys.modules["io_mocapress.program"], "find",
                               side_effect=AssertionError("the program is looked for")):
            yield
        self.preferences().program = MOCAPRESS

    def test_the_package_imports_what_the_program_does(self):
        clip = self.small_clip()
        frames = range(1, 41)
        expected = heads_of(self.bring_in(clip), frames)
        with self.package():
            found = heads_of(self.bring_in(clip), frames)
        self.assertEqual(set(found[0]), set(expected[0]))
        self.assertLess(largest_distance(expected, found), WITHIN)

    def test_the_package_exports_what_the_program_does(self):
        rig = make_mixamo()
        paths = [self.folder / "program.mcpr", self.folder / "package.mcpr"]
        self.send_out(paths[0], quality="error", target_error=0.01)
        with self.package(), captured() as said:
            self.send_out(paths[1], quality="error", target_error=0.01)
        self.assertIn(f"package.mcpr: {paths[1].stat().st_size} bytes", said())
        sizes = [path.stat().st_size for path in paths]
        self.assertLess(abs(sizes[1] - sizes[0]), 0.05 * sizes[0], sizes)
        before = heads_of(rig, range(10, 68))
        with self.package():
            rig = self.bring_in(paths[1], start=10)
        self.assertLess(largest_distance(before, heads_of(rig, range(10, 68))), 0.05)

    def test_the_package_keeps_joints_in_their_places_as_the_program_does(self):
        self.bring_in(self.compress(SAMPLES / "human_run.amc"))
        path = self.folder / "again.mcpr"
        with self.package():
            self.send_out(path)
        info = json.loads(subprocess.run([MOCAPRESS, "info", "--json", path],
                                         capture_output=True).stdout)[0]
        # Blender's floats move them by some 1e-5 cm.
        self.assertEqual(info["channels"], 3 * info["joints"] + 3)

    def test_the_package_refuses_with_the_programs_sentences(self):
        bad = self.folder / "bad.mcpr"
        bad.write_bytes(self.small_clip().read_bytes()[:300])
        expected = self.refusal(bpy.ops.import_anim.mocapress, filepath=str(bad))
        with self.package():
            self.assertEqual(self.refusal(bpy.ops.import_anim.mocapress, filepath=str(bad)),
                             expected)
            make_mixamo()
            self.assertIn("No such file", self.refusal(bpy.ops.export_anim.mocapress,
                                                       filepath=str(self.folder / "no/x.mcpr")))

    def test_a_stopped_run_of_the_package_leaves_no_thread(self):
        def never_done(stop):
            while True:
                stop()

        running = sys.modules["io_mocapress.package"]._run(never_done, 0.5)
        self.assertEqual(next(running), 0.5)
        running.close()
        self.assertEqual(threading.active_count(), 1)

    # The add-on itself

    def test_it_has_the_version_of_the_program_and_leaves_nothing(self):
        info = addon_utils.module_bl_info(sys.modules["io_mocapress"])
        version = subprocess.run([MOCAPRESS, "--version"], capture_output=True, text=True).stdout
        self.assertEqual(".".join(map(str, info["version"])), version.strip())
        for key in ("name", "description", "author", "blender", "location", "category"):
            self.assertTrue(info[key], key)
        menus = (bpy.types.TOPBAR_MT_file_import, bpy.types.TOPBAR_MT_file_export)
        entries = [len(menu._dyn_ui_initialize()) for menu in menus]
        for _ in range(2):
            bpy.ops.preferences.addon_disable(module="io_mocapress")
            self.assertEqual([len(menu._dyn_ui_initialize()) for menu in menus],
                             [count - 1 for count in entries])
            self.assertFalse(hasattr(bpy.types, "IMPORT_ANIM_OT_mocapress"))
            bpy.ops.preferences.addon_enable(module="io_mocapress")
            self.assertEqual([len(menu._dyn_ui_initialize()) for menu in menus], entries)
            self.assertTrue(hasattr(bpy.types, "IMPORT_ANIM_OT_mocapress"))


@contextlib.contextmanager
def captured():
    """The output meanwhile, including operators' reports."""
    with tempfile.TemporaryFile("w+") as into:
        sys.stdout.flush()
        kept = os.dup(1)
        os.dup2(into.fileno(), 1)
        text = []
        try:
            yield lambda: text[0]
        finally:
            sys.stdout.flush()
            ctypes.CDLL(None).fflush(None)
            os.dup2(kept, 1)
            os.close(kept)
            into.seek(0)
            text.append(into.read())


if bpy is None:
    sys.exit(start(*sys.argv[1:]))

FOLDER, MOCAPRESS, ZIP, SAMPLES, *PACKAGE = sys.argv[sys.argv.index("--") + 1:]
SAMPLES = pathlib.Path(SAMPLES)
sys.path[:0] = PACKAGE
pathlib.Path(FOLDER, "started").touch()
bpy.ops.preferences.addon_install(filepath=ZIP)
if not unittest.main(argv=["blender_addon_test"], exit=False, verbosity=2).result.wasSuccessful():
    raise SystemExit(1)
