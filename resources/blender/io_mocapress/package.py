# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python package `mocapress`, where this Python has it: no process, no text in between."""
import threading
import time

from . import bvh
from .program import Failure, settings

try:
    import numpy  # noqa: F401  the package imports it only when it makes an array
    import mocapress as library
except ImportError:
    library = None


def is_used():
    """True where the package is installed and the preferences name no program."""
    return library is not None and not settings().program


class Clip:
    """As bvh.Clip has it, from arrays."""

    def __init__(self, motion):
        places = motion.local_translations() - motion.offsets
        self.joints = [
            bvh.Joint(name, int(parent), tuple(offset), motion.end_sites.get(index),
                      moves=bool(parent < 0 or places[:, index].any()))
            for index, (name, parent, offset) in enumerate(
                zip(motion.names, motion.parents, motion.offsets.tolist()))]
        self.words = motion.bvh_names
        self.rate = motion.rate
        self.rows = range(motion.frames)
        self.places = places
        self.turns = motion.local_rotations()

    def pose(self, row):
        return list(zip(map(tuple, self.places[row].tolist()), map(tuple, self.turns[row].tolist())))


def read(path, share):
    """A generator: yields the share done meanwhile, and returns the Clip of a .mcpr."""
    return (yield from _run(lambda stop: Clip(library.open(path).decode()), share))


def write(path, joints, rate, poses, preset, target, share):
    """A generator, as read(): returns what a .mcpr measures, once it is written."""
    def work(stop):
        motion = library.Motion.from_numpy(
            [bvh.joint_name(joint.name) for joint in joints], [joint.parent for joint in joints],
            [joint.offset for joint in joints], [[turn for _, turn in pose] for pose in poses],
            [[[a + b for a, b in zip(joint.offset, moved)] if joint.moves else joint.offset
              for joint, (moved, _) in zip(joints, pose)] for pose in poses],
            rate=rate, end_sites={index: joint.end for index, joint in enumerate(joints) if joint.end})
        clip = library.encode(motion, preset=preset, progress=stop, **target)
        stop()
        clip.save(path)
        return clip.measurement

    return (yield from _run(work, share))


class _Stopped(Exception):
    pass


def _run(work, share):
    """Runs work(stop) on a thread, and yields `share` every 50 ms until it is done. Once this
    generator has been closed, or the time of the preferences is up, stop() raises."""
    ended = threading.Event()
    seconds = settings().timeout
    deadline = time.monotonic() + seconds
    found = []

    def stop(*_):
        if ended.is_set():
            raise _Stopped

    def run():
        try:
            found.append((work(stop), None))
        except BaseException as failure:  # raised below, on Blender's thread
            found.append((None, failure))

    thread = threading.Thread(target=run)
    thread.start()
    try:
        while thread.is_alive():
            thread.join(0.05)
            if time.monotonic() > deadline:
                raise Failure(f"mocapress took longer than {seconds} s and was stopped: the add-on's "
                              "preferences say how long it may")
            yield share
    finally:
        ended.set()
        thread.join()
    result, failure = found[0]
    if isinstance(failure, (library.Error, ValueError)):
        raise Failure(str(failure)) from failure
    if failure is not None:
        raise failure
    return result
