# SPDX-License-Identifier: GPL-3.0-or-later
"""File > Import and File > Export."""
import json
import math
import os
import shutil
import tempfile
import time

import bpy
from bpy.props import (BoolProperty, CollectionProperty, EnumProperty, FloatProperty, IntProperty,
                       StringProperty)
from bpy_extras.io_utils import ExportHelper, ImportHelper

from . import bvh, figure, package, program
from .program import Failure

UNITS_PER_CM = dict(
    name="Scale", default=0.01, min=1e-6, max=1e6, soft_min=1e-3, soft_max=100, precision=4,
    description="Blender units per centimetre: 0.01 makes a unit a metre")

PRESETS = (  # as `mocapress batch --preset` has them
    ("gameplay", "Gameplay", "0.25 cm on the skin, with care for feet, hands and head"),
    ("hero-close-up", "Hero Close-Up", "0.065 cm on the skin: a third of the error of Gameplay"),
    ("crowd", "Crowd", "0.6 cm on the skin, for figures that are far away"),
    ("planted-feet", "Planted Feet", "As Gameplay, with more care for feet while they stand"),
    ("archive", "Archive", "No point of the skin more than 1 mm off"))


class Steps:
    """An operator whose work() is a generator that yields the share done. From a menu it runs step
    by step, so that the window is drawn and Esc stops it; from a script it runs in one go."""

    changed = False  # the file in Blender; then there is something to undo

    def execute(self, context):
        self.work_left = self.work(context)
        context.window_manager.progress_begin(0, 100)
        if bpy.app.background or not self.options.is_invoke:
            while True:
                result = self.step(context)
                if result != {"RUNNING_MODAL"}:
                    return result
        self.timer = context.window_manager.event_timer_add(0.01, window=context.window)
        context.window_manager.modal_handler_add(self)
        context.workspace.status_text_set("Mocapress is working. Esc: stop")
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        result = {"RUNNING_MODAL"}
        if event.type == "ESC" and event.value == "PRESS":
            self.work_left.close()
            context.window_manager.progress_end()
            self.report({"WARNING"}, "Stopped")
            result = self.cut_short()
        elif event.type == "TIMER":
            result = self.step(context)
        if result != {"RUNNING_MODAL"}:
            context.window_manager.event_timer_remove(self.timer)
            context.workspace.status_text_set(None)
        return result

    def step(self, context):
        try:
            # A window may take longer to draw than one step of the work.
            until = time.monotonic() + 0.1
            while time.monotonic() < until:
                share = next(self.work_left)
            context.window_manager.progress_update(int(100 * share))
            return {"RUNNING_MODAL"}
        except StopIteration:
            result = {"FINISHED"}
        except Failure as failure:
            self.report({"ERROR"}, str(failure))
            result = self.cut_short()
        except OSError as error:
            self.report({"ERROR"}, f"{error.filename}: {error.strerror}")
            result = self.cut_short()
        context.window_manager.progress_end()
        return result

    def cut_short(self):
        return {"FINISHED"} if self.changed else {"CANCELLED"}


def some(names):
    """A list for a sentence, which does not become too long."""
    names = list(names)
    return ", ".join(names[:8]) + (f" and {len(names) - 8} more" if len(names) > 8 else "")


class MOCAPRESS_OT_import(Steps, bpy.types.Operator, ImportHelper):
    """Import compressed motion capture clips (.mcpr), each as an action of an armature"""
    bl_idname = "import_anim.mocapress"
    bl_label = "Import Mocapress"
    bl_options = {"UNDO", "PRESET"}

    filename_ext = ".mcpr"
    filter_glob: StringProperty(default="*.mcpr", options={"HIDDEN"})
    files: CollectionProperty(type=bpy.types.OperatorFileListElement,
                              options={"HIDDEN", "SKIP_SAVE"})
    directory: StringProperty(subtype="DIR_PATH", options={"HIDDEN", "SKIP_SAVE"})

    target: EnumProperty(
        name="Onto", default="NEW",
        items=(("NEW", "New Armature", "Make an armature with the skeleton of the clip"),
               ("SELECTED", "Active Armature",
                "Move the bones of the active armature that have the names of the clip's joints")))
    units_per_cm: FloatProperty(**UNITS_PER_CM)
    start: IntProperty(name="Start Frame", default=1,
                       description="Frame of the scene at which clips begin")
    set_rate: BoolProperty(
        name="Set Frame Rate", default=True,
        description="Give the scene the frame rate of the first clip. Otherwise clips keep their "
                    "speed, with keys between the scene's frames")
    set_range: BoolProperty(
        name="Set Frame Range", default=True,
        description="Let the scene begin and end with the longest of the clips")

    def paths(self):
        names = [file.name for file in self.files if file.name]
        if names:
            return [os.path.join(self.directory, name) for name in names]
        return [bpy.path.abspath(self.filepath)]

    def work(self, context):
        selected = context.object
        if self.target == "SELECTED" and (selected is None or selected.type != "ARMATURE"):
            raise Failure("The active object is no armature to import onto")
        if context.object and context.object.mode == "EDIT":
            bpy.ops.object.mode_set(mode="OBJECT")
        paths = self.paths()
        last = self.start
        made = None  # armature, joints and bones of the clip before, when it was new
        for number, path in enumerate(paths):
            with tempfile.TemporaryDirectory(prefix="mocapress-") as folder:
                clip, words = yield from self.load(path, folder, number / len(paths))
            self.changed = True
            if number == 0 and self.set_rate:
                set_scene_rate(context.scene, clip.rate)
            name = os.path.splitext(os.path.basename(path))[0]
            if self.target == "SELECTED":
                armature = selected
                bone_of = figure.match(clip.joints, words, armature.data)
                self.tell_of_missing(name, clip, bone_of, armature)
            elif made and made[1] == clip.joints:
                armature, _, bone_of = made
            else:
                armature, bone_of = figure.make(context, name, clip, self.units_per_cm)
                made = (armature, clip.joints, bone_of)
            step = scene_rate(context.scene) / clip.rate
            frames = [self.start + i * step for i in range(len(clip.rows))]
            for share in figure.animate(armature, clip, bone_of, name, frames, self.units_per_cm):
                yield (number + 0.3 + 0.7 * share) / len(paths)
            last = max(last, math.ceil(frames[-1] - 1e-6))
        if self.set_range:
            context.scene.frame_start = self.start
            context.scene.frame_end = last
        context.scene.frame_set(self.start)
        count = f"{len(paths)} clips" if len(paths) > 1 else "1 clip"
        self.report({"INFO"}, f"Imported {count} onto {armature.name}")

    def load(self, path, folder, done):
        """The clip of a file, and the words by which a BVH names its joints."""
        if package.is_used():
            clip = yield from package.read(path, done)
            name_joints(clip.joints, [joint.name for joint in clip.joints], clip.words)
            return clip, clip.words
        warnings = []
        text_path = os.path.join(folder, "clip.bvh")
        for _ in program.run(["decompress", path, "-o", text_path, "--out-cm-per-unit", "1",
                              "--out-up", "y", "--out-bvh-root", "add"], folder, warnings):
            yield done
        lines = []
        for line in program.run(["info", "--json", path], folder, warnings):
            lines.append(line)
            yield done
        for warning in warnings:
            self.report({"WARNING"}, warning)
        try:
            names = json.loads("\n".join(lines))[0].get("bvh_names", {})
            with open(text_path, encoding="utf-8") as text:
                clip = bvh.read(text.read())
        except (ValueError, IndexError) as error:
            raise Failure(f"{path}: mocapress wrote what the add-on does not understand "
                          f"({error}): are both of one version?") from error
        words = [joint.name for joint in clip.joints]
        name_joints(clip.joints, [names.get(word, word) for word in words], words)
        return clip, words

    def tell_of_missing(self, name, clip, bone_of, armature):
        missing = [joint.name for joint, bone in zip(clip.joints, bone_of) if bone is None]
        if len(missing) == len(bone_of):
            raise Failure(f"{name}: no joint has the name of a bone of {armature.name}; the "
                          f"joints are {some(missing)}")
        if missing:
            self.report({"WARNING"}, f"{name}: no bone for {some(missing)}")
        bones = [bone for bone in bone_of if bone is not None]
        still = [bone for joint, bone in zip(clip.joints, bone_of)
                 if bone is not None and joint.moves and armature.data.bones[bone].use_connect]
        if still:
            self.report({"WARNING"}, f"{name}: bones that are connected cannot move as their "
                                     f"joints do: {some(still)}")
        held = [bone for bone in bones
                if any(not one.mute for one in armature.pose.bones[bone].constraints)]
        if held:
            self.report({"WARNING"}, f"{name}: constraints change the motion of {some(held)}")


def name_joints(joints, names, words):
    """Gives each joint its name, or its word in a BVH where others have that name too."""
    for joint, name, word in zip(joints, names, words):
        joint.name = name if names.count(name) == 1 else word


def scene_rate(scene):
    return scene.render.fps / scene.render.fps_base


def set_scene_rate(scene, rate):
    scene.render.fps = max(1, round(rate))
    scene.render.fps_base = scene.render.fps / rate


class MOCAPRESS_OT_export(Steps, bpy.types.Operator, ExportHelper):
    """Export the motion of the active armature as a compressed clip (.mcpr)"""
    bl_idname = "export_anim.mocapress"
    bl_label = "Export Mocapress"
    bl_options = {"PRESET"}

    filename_ext = ".mcpr"
    filter_glob: StringProperty(default="*.mcpr", options={"HIDDEN"})

    quality: EnumProperty(
        name="Quality", default="gameplay",
        description="How far the clip may be from the motion",
        items=(*PRESETS, ("error", "Target Error", "The smallest file with a mean error")))
    target_error: FloatProperty(
        name="Error", default=0.25, min=1e-4, soft_max=5, precision=3,
        description="Mean error (RMS) of points on the skin in cm, with the care of Gameplay for "
                    "feet, hands and head")
    frames: EnumProperty(
        name="Frames", default="ACTION",
        items=(("ACTION", "Of the Action", "All frames of the armature's action"),
               ("SCENE", "Of the Scene", "From the scene's first frame to its last")))
    only_deform: BoolProperty(
        name="Only Deform Bones", default=False,
        description="Leave out bones that deform nothing, such as controls")
    units_per_cm: FloatProperty(**UNITS_PER_CM)

    @classmethod
    def poll(cls, context):
        return (context.object is not None and context.object.type == "ARMATURE"
                and context.object.mode != "EDIT")

    def draw(self, context):
        self.layout.use_property_split = True
        self.layout.prop(self, "quality")
        row = self.layout.row()
        row.enabled = self.quality == "error"
        row.prop(self, "target_error")
        for name in ("frames", "only_deform", "units_per_cm"):
            self.layout.prop(self, name)

    def frame_range(self, context):
        data = context.object.animation_data
        action = data.action if data else None
        if self.frames == "ACTION" and action:
            first, last = action.frame_range
            return math.floor(first + 1e-3), math.ceil(last - 1e-3)
        return context.scene.frame_start, context.scene.frame_end

    def work(self, context):
        if not package.is_used():
            program.find()  # before anything takes long
        scene = context.scene
        first, last = self.frame_range(context)
        shown = scene.frame_current, scene.frame_subframe
        try:
            scene.frame_set(first)
            recorder = figure.Recorder(context.object, self.only_deform, self.units_per_cm)
            for frame in range(first, last + 1):
                scene.frame_set(frame)
                recorder.record(context.evaluated_depsgraph_get())
                yield 0.5 * (frame - first) / (last - first + 1)
        finally:
            scene.frame_set(shown[0], subframe=shown[1])
        displaced = recorder.settle()
        preset, target = self.quality, {}
        if self.quality == "error":
            preset, target = "gameplay", {"error": self.target_error}
        if package.is_used():
            done = yield from package.write(self.filepath, recorder.joints, scene_rate(scene),
                                            recorder.poses, preset, target, 0.75)
        else:
            with tempfile.TemporaryDirectory(prefix="mocapress-") as folder:
                done = yield from self.compress(recorder, scene_rate(scene), preset, target, folder)
                # Whole or not at all: on the way the file has another name.
                staged = self.filepath + ".part"
                shutil.copyfile(os.path.join(folder, "out", "clip.mcpr"), staged)
                os.replace(staged, self.filepath)
        if recorder.scaled:
            self.report({"WARNING"}, f"A clip has no scale: left out at {some(recorder.scaled)}")
        if displaced:
            self.report({"WARNING"}, "Too far from where they rest, which is not kept: "
                                     f"{some(displaced)}")
        self.report({"INFO"}, f"{os.path.basename(self.filepath)}: {done['file_bytes']} bytes, "
                              f"{done['ratio']:.0f}:1, {done['eps_x_cm']:.3f} cm off (RMS)")

    def compress(self, recorder, rate, preset, target, folder):
        """Leaves out/clip.mcpr in the folder. Returns what the program says of it."""
        source = os.path.join(folder, "clip.bvh")
        with open(source, "w", encoding="utf-8") as text:
            text.write(bvh.write(recorder.joints, rate, recorder.poses))
        wanted = ["--preset", preset]
        if target:
            wanted += ["--target-error", str(target["error"])]
        # A batch of one: it knows the presets, says how far it is, and verifies what it writes.
        arguments = ["batch", source, "-o", os.path.join(folder, "out"), "--json-progress",
                     "--cm-per-unit", "1", "--up", "y", "--bvh-root", "add", *wanted]
        done = {}
        fraction = 0
        try:
            # Its warnings are about the BVH, which is the add-on's own affair.
            for line in program.run(arguments, folder, []):
                event = json.loads(line) if line.startswith("{") else {}
                fraction = max(fraction, event.get("fraction") or 0)
                if event.get("event", "").startswith("clip-"):
                    done = event
                yield 0.5 + 0.5 * fraction
        except Failure as failure:
            raise Failure(done.get("error") or str(failure)) from failure
        if not done.get("done"):
            raise Failure("mocapress made no clip: are it and the add-on of one version?")
        return done
