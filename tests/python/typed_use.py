# SPDX-License-Identifier: MIT
"""Uses the package as a script with types does. types_test.py checks it strictly; it does not run."""
from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import mocapress
from mocapress import (Bank, Clip, Encoder, Error, FormatError, InputError, Motion, Progress, TargetMissed, Track,
                       Visibility, WriteError)


def tell(progress: Progress) -> None:
    print(progress.trial, progress.iteration, progress.error_cm)


def motions(path: Path) -> list[Motion]:
    motion = mocapress.read(path, up="y")
    channels: NDArray[np.float64] = motion.channels
    tracks: list[Track] = motion.tracks
    print(channels.shape, [track.values.shape for track in tracks], motion.contacts(), mocapress.__version__)
    return [motion, motion.with_channels(channels[::2], rate=motion.rate / 2),
            Motion.from_numpy(motion.names, motion.parents, motion.offsets, motion.local_rotations(),
                              motion.local_translations(), rate=motion.rate, end_sites=motion.end_sites)]


def clips(motion: Motion, path: Path) -> Visibility:
    encoder = Encoder(motion)
    for error in (0.2, 0.4):
        encoder.encode(error=error, effort="best", progress=tell).save(path)
    clip: Clip = mocapress.encode(motion, preset="gameplay", progress=tell)
    opened = mocapress.open(path)
    pose: NDArray[np.float32] = Clip(bytes(opened)).sample([0.0, 0.5])
    print(clip.nbytes, pose, opened.positions(0.25), opened.measure(motion, limits={"distance_m": 15})["ratio"])
    return mocapress.visibility(motion, opened.decode())


def bank(path: Path, clip: Path) -> list[str]:
    Bank.make(path, {"walk": clip}, cooked=True, tags=["gait"], texts={"licence": "MIT"})
    made = Bank(path)
    return [f"{name} {made.sample(name, 0.5).shape} {made.tags(name)}" for name in made]


def exchanged(motion: Motion, path: Path) -> list[str]:
    try:
        said = mocapress.write(motion, path) + mocapress.write_amass(motion, path)
        mocapress.read_amass(path, offsets=motion.offsets)
        return said
    except InputError as error:
        return [str(error), str(error.line)]
    except FormatError as error:
        return [str(error), str(error.byte_offset)]
    except (WriteError, TargetMissed, Error) as error:
        return [str(error)]
