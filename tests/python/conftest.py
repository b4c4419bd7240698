# SPDX-License-Identifier: MIT
import os
import pathlib

import numpy as np
import pytest

import mocapress

ROOT = pathlib.Path(__file__).resolve().parents[2]
SAMPLES = ROOT / "resources/samples"
PROGRAM = os.environ.get("MOCAPRESS_EXECUTABLE") and os.path.abspath(os.environ["MOCAPRESS_EXECUTABLE"])
needs_program = pytest.mark.skipif(not PROGRAM, reason="no program to compare with")

NAMES = ["hips", "spine", "head", "lleg", "lfoot"]
PARENTS = [-1, 0, 1, 0, 3]
OFFSETS = np.array([[0, 90, 0], [0, 30, 0], [0, 30, 2], [9, -5, 0], [0, -80, 0]], float)
RATE = 30.0


def turns(axis_angles):
    angles = np.linalg.norm(axis_angles, axis=-1, keepdims=True)
    return np.concatenate([np.cos(angles / 2),
                           axis_angles * np.sin(angles / 2) / np.maximum(angles, 1e-12)], axis=-1)


def matrices(quaternions):
    w, x, y, z = np.moveaxis(np.asarray(quaternions, float), -1, 0)
    return np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
                     2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                     2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
                    axis=-1).reshape(*w.shape, 3, 3)


def world(rotations, translations, parents):
    """Places of joints by forward kinematics, by other means than the library's."""
    turned, places = [], []
    for joint, parent in enumerate(parents):
        own = matrices(rotations[:, joint])
        if parent < 0:
            turned.append(own)
            places.append(translations[:, joint])
        else:
            turned.append(turned[parent] @ own)
            places.append(places[parent]
                          + np.einsum("fij,fj->fi", turned[parent], translations[:, joint]))
    return np.stack(places, axis=1)


def waving(frames=90):
    """Rotations (frames, joints, 4) and where the hips are (frames, 3)."""
    time = np.arange(frames)[:, None, None] / RATE
    phases = np.arange(15).reshape(1, 5, 3)
    rotations = turns(0.4 * np.sin(2 * time + phases))
    root = np.stack([40 * time[:, 0, 0], 90 + np.sin(3 * time[:, 0, 0]), 0 * time[:, 0, 0]], axis=-1)
    return rotations, root


@pytest.fixture(scope="session")
def arrays():
    return waving()


@pytest.fixture(scope="session")
def wave(arrays):
    rotations, root = arrays
    return mocapress.Motion.from_numpy(NAMES, PARENTS, OFFSETS, rotations, root, rate=RATE)


@pytest.fixture(scope="session")
def walk():
    return mocapress.read(SAMPLES / "human_walk.amc")


@pytest.fixture(scope="session")
def clip(walk):
    return mocapress.encode(walk, error=0.25)
