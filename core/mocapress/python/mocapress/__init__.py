# SPDX-License-Identifier: MIT
"""Compression of motion capture clips.

    import mocapress
    walk = mocapress.read("walk.bvh")
    clip = mocapress.encode(walk, error=0.25)    # cm
    clip.save("walk.mcpr")
    clip.sample([0.0, 0.5])                      # poses at any instants

Everything is in centimetres, radians and seconds; right-handed, y up. Every failure of the library
is an Error with a sentence that can be shown.
"""
from __future__ import annotations

import os
from typing import Any

from ._core import (Bank, Clip, Error, FormatError, InputError, Motion, Progress, TargetMissed,
                    Track, Visibility, WriteError, __version__, visibility)
from ._core import open_clip as _open_clip
from ._core import read_motion as _read_motion
from ._core import write_motion as _write_motion
from .amass import read_amass, write_amass
from .encoder import Encoder, encode

__all__ = ["Bank", "Clip", "Encoder", "Error", "FormatError", "InputError", "Motion", "Progress",
           "TargetMissed", "Track", "Visibility", "WriteError", "encode", "open", "read",
           "__version__", "read_amass", "visibility", "write", "write_amass"]


def _is_npz(path: str | os.PathLike[str]) -> bool:
    return os.fspath(path).lower().endswith(".npz")


def read(path: str | os.PathLike[str], **options: Any) -> Motion:
    """Reads a .bvh, .amc, .fbx, .gltf, .glb, .vrm, .vrma or AMASS-like .npz by its extension.

    options say what a file does not, or says wrongly: skeleton (the .asf of an .amc), rate (frames
    a second), cm_per_unit, up ("y", "z"), bvh_root ("add", "replace"), take (of a file with
    several: its name or number), character (a .fbx, .gltf or .glb that is put on), tracks (a .csv
    of curves); of an .npz, offsets as read_amass() has them. Motion.warnings tells what was
    guessed. Raises InputError.
    """
    return read_amass(path, **options) if _is_npz(path) else _read_motion(path, **options)


def write(motion: Motion, path: str | os.PathLike[str], **options: Any) -> list[str]:
    """Writes a .bvh, .amc, .fbx, .gltf, .glb, .csv or AMASS-like .npz by its extension.

    Without options, a file is in the axes and unit that its motion was read in. options: skeleton
    (where the .asf of an .amc goes), rate (only stated), cm_per_unit, up, bvh_root. Returns
    sentences on what had no place in the file. Raises WriteError, and Error for other extensions.
    """
    if _is_npz(path):
        return write_amass(motion, path, **options)
    return _write_motion(motion, path, **options)


def open(path: str | os.PathLike[str]) -> Clip:
    """A .mcpr by a method of ours: those of rivals, which `mocapress study` compares, are not read.

    Raises InputError. Bank(path) opens a .mcpk.
    """
    return _open_clip(path)
