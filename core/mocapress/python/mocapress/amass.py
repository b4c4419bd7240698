# SPDX-License-Identifier: MIT
"""AMASS-like .npz files: poses as axis times angle, metres, z up.

Arrays: poses (frames, 3 * joints), radians; trans (frames, 3), metres; mocap_framerate. Ours also
have joint_names, parents and offsets (joints, 3), metres, which AMASS keeps in its body models.
"""
from __future__ import annotations

import io
import os
import zipfile
from typing import TYPE_CHECKING, Any

from ._core import InputError, Motion, WriteError, write_bytes

if TYPE_CHECKING:
    import numpy
    from numpy.typing import ArrayLike, NDArray

_FINGERS = ("index", "middle", "pinky", "ring", "thumb")
_BODY = (  # name, parent, offset in cm: an adult of some 1.7 m with arms held out, rounded by us
    ("pelvis", -1, (0, 95, 0)), ("left_hip", 0, (8, -8, 0)), ("right_hip", 0, (-8, -8, 0)),
    ("spine1", 0, (0, 11, -2)), ("left_knee", 1, (1, -39, 0)), ("right_knee", 2, (-1, -39, 0)),
    ("spine2", 3, (0, 13, 0)), ("left_ankle", 4, (0, -41, -3)), ("right_ankle", 5, (0, -41, -3)),
    ("spine3", 6, (0, 6, 2)), ("left_foot", 7, (3, -5, 12)), ("right_foot", 8, (-3, -5, 12)),
    ("neck", 9, (0, 21, -3)), ("left_collar", 9, (8, 12, -2)), ("right_collar", 9, (-8, 12, -2)),
    ("head", 12, (0, 9, 5)), ("left_shoulder", 13, (10, 4, -1)),
    ("right_shoulder", 14, (-10, 4, -1)), ("left_elbow", 16, (26, -1, -2)),
    ("right_elbow", 17, (-26, -1, -2)), ("left_wrist", 18, (25, 1, 0)),
    ("right_wrist", 19, (-25, 1, 0)))
_SMPLX_FACE = (("jaw", 15, (0, 2, 1)), ("left_eye", 15, (3, 7, 6)), ("right_eye", 15, (-3, 7, 6)))
_SMPL_HANDS = (("left_hand", 20, (8, -1, -1)), ("right_hand", 21, (-8, -1, -1)))


def _fingers(side: str, sign: int, wrist: int, first: int) -> list[tuple[str, int, Any]]:
    joints: list[tuple[str, int, Any]] = []
    for number, finger in enumerate(_FINGERS):
        across = (3, 0, -5, -3, 3)[number]
        root = (sign * (3 if finger == "thumb" else 10), -2 if finger == "thumb" else 0, across)
        for part in range(3):
            parent = wrist if part == 0 else first + len(joints) - 1
            joints.append((f"{side}_{finger}{part + 1}", parent,
                           root if part == 0 else (sign * 3, 0, 0)))
    return joints


def _joints(count: int) -> list[tuple[str, int, Any]] | None:
    """The skeleton of SMPL's body (22), SMPL (24), SMPL-H (52) or SMPL-X (55)."""
    if count == 22:
        return list(_BODY)
    if count == 24:
        return [*_BODY, *_SMPL_HANDS]
    if count in (52, 55):
        head = [*_BODY, *_SMPLX_FACE] if count == 55 else [*_BODY]
        return [*head, *_fingers("left", 1, 20, len(head)), *_fingers("right", -1, 21, len(head) + 15)]
    return None


def _quaternions(vectors: NDArray[Any]) -> NDArray[Any]:
    import numpy as np
    angles = np.linalg.norm(vectors, axis=-1, keepdims=True)
    # sinc(x) is sin(pi x) / (pi x), and 1 at 0.
    return np.concatenate(
        [np.cos(angles / 2), vectors * (0.5 * np.sinc(angles / (2 * np.pi)))], axis=-1)


def _axis_angles(quaternions: NDArray[Any]) -> NDArray[Any]:
    import numpy as np
    quaternions = np.where(quaternions[..., :1] < 0, -quaternions, quaternions)
    sines = np.linalg.norm(quaternions[..., 1:], axis=-1, keepdims=True)
    angles = 2 * np.arctan2(sines, quaternions[..., :1])
    scale = np.where(sines > 1e-12, angles / np.where(sines > 1e-12, sines, 1), 2)
    vectors: NDArray[Any] = quaternions[..., 1:] * scale
    return vectors


def _turned(quaternions: NDArray[Any], half: float) -> NDArray[Any]:
    """The turn by a right angle about x, half of it given by its sign, after the others."""
    import numpy as np
    c, s = np.sqrt(0.5), half * np.sqrt(0.5)
    w, x, y, z = np.moveaxis(quaternions, -1, 0)
    return np.stack([c * w - s * x, c * x + s * w, c * y - s * z, c * z + s * y], axis=-1)


def read_amass(path: str | os.PathLike[str], *, offsets: ArrayLike | None = None) -> Motion:
    """Reads an AMASS-like .npz: SMPL's body (22 joints), SMPL (24), SMPL-H (52), SMPL-X (55), or ours.

    offsets: (joints, 3), cm: each joint's place in its parent, the pelvis in the body model.
    AMASS has them in its body models alone. Left out, they are the file's, else those of an adult
    of 1.7 m, and Motion.warnings says so. Shapes (betas) and soft tissue are not read. Raises
    InputError.
    """
    import numpy as np

    def refuse(why: str) -> InputError:
        return InputError(f"{os.fspath(path)}: {why}")

    try:
        loaded = np.load(path, allow_pickle=False)
        if not isinstance(loaded, np.lib.npyio.NpzFile):
            raise refuse("is not an .npz archive")
        with loaded as file:
            rates = [file[key] for key in ("mocap_framerate", "mocap_frame_rate") if key in file]
            held = {key: file[key] for key in ("poses", "trans", "joint_names", "parents", "offsets")
                    if key in file}
    except OSError as error:
        raise refuse(error.strerror or "is not an .npz archive") from None
    except (ValueError, EOFError, KeyError, MemoryError, zipfile.BadZipFile) as error:
        raise refuse(f"is not an .npz archive that can be read: {error}") from None
    if "poses" not in held or "trans" not in held or not rates or rates[0].size != 1:
        raise refuse("lacks poses, trans or mocap_framerate")
    try:
        poses, places = (np.asarray(held[key], dtype=float) for key in ("poses", "trans"))
        rate = float(rates[0].reshape(()))
    except (TypeError, ValueError):
        raise refuse("poses, trans and mocap_framerate are not numbers") from None
    if poses.ndim != 2 or poses.shape[1] == 0 or poses.shape[1] % 3 != 0:
        raise refuse("poses are not frames x 3 * joints")
    if places.shape != (len(poses), 3):
        raise refuse("trans is not frames x 3")
    count = poses.shape[1] // 3
    known = _joints(count)
    if "joint_names" in held and "parents" in held:
        names = [str(name) for name in held["joint_names"].ravel()]
        if held["parents"].dtype.kind not in "iu":
            raise refuse("parents are not whole numbers")
        parents = held["parents"].ravel().tolist()
    elif known:
        names, parents = [joint[0] for joint in known], [joint[1] for joint in known]
    else:
        raise refuse(f"has {count} joints; SMPL's body has 22, SMPL 24, SMPL-H 52, SMPL-X 55, and others "
                     "need joint_names, parents and offsets")
    warnings = []
    if offsets is not None or "offsets" in held:
        try:
            at_rest = (np.asarray(offsets, dtype=float) if offsets is not None
                       else 100 * np.asarray(held["offsets"], dtype=float))
        except (TypeError, ValueError):
            raise refuse("offsets are not numbers") from None
    elif known:
        at_rest = np.array([joint[2] for joint in known], dtype=float)
        at_rest[0] = 0  # trans says where the pelvis is, but for a shift
        warnings = [f"{os.fspath(path)}: has no offsets of joints: those of an adult of 1.7 m are "
                    "assumed"]
    else:
        raise refuse("has no offsets of joints")
    if at_rest.shape != (count, 3):
        raise refuse("offsets are not joints x 3")
    rotations = _quaternions(poses.reshape(len(poses), count, 3))
    rotations[:, 0] = _turned(rotations[:, 0], -1)
    x, y, z = (100 * places + at_rest[0]).T
    try:
        return Motion.from_numpy(names, parents, at_rest, rotations, np.stack([x, z, -y], axis=-1),
                                 rate=rate, warnings=warnings)
    except (TypeError, ValueError) as error:
        raise refuse(str(error).splitlines()[0]) from None


def write_amass(motion: Motion, path: str | os.PathLike[str]) -> list[str]:
    """Writes an AMASS-like .npz, with joint_names, parents and offsets, whole or not at all.

    Returns sentences on what had no place: joints that move in their parents, and tracks. Raises
    WriteError.
    """
    import numpy as np
    if (motion.parents < 0).sum() != 1:
        raise WriteError(f"{os.fspath(path)}: an AMASS-like file has one root, the motion several")
    rotations = motion.local_rotations()
    places = motion.local_translations()
    offsets = motion.offsets
    root = places[:, 0]
    rotations[:, 0] = _turned(rotations[:, 0], 1)
    moving = [name for joint, name in enumerate(motion.names)
              if joint > 0 and np.abs(places[:, joint] - offsets[joint]).max() > 1e-6]
    arrays = {
        "poses": _axis_angles(rotations).reshape(len(rotations), -1),
        "trans": (np.stack([root[:, 0], -root[:, 2], root[:, 1]], axis=-1) - offsets[0]) / 100,
        "mocap_framerate": np.array(motion.rate), "joint_names": np.array(motion.names),
        "parents": motion.parents, "offsets": offsets / 100}
    file = io.BytesIO()
    np.savez_compressed(file, **arrays)
    write_bytes(path, file.getvalue())
    said = []
    if moving:
        said.append(f"joints that move in their parents stay at their offsets: {moving[0]}"
                    + (f" and {len(moving) - 1} more" if len(moving) > 1 else ""))
    if motion.tracks:
        said.append(f"tracks are left out: {len(motion.tracks)}")
    return said
