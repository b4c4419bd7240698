# SPDX-License-Identifier: MIT
import gc
import tracemalloc

import numpy as np
import pytest
from conftest import NAMES, OFFSETS, PARENTS, RATE, world

import mocapress


def test_a_motion_of_arrays_gives_them_back(arrays, wave):
    rotations, root = arrays
    found = wave.local_rotations()
    assert np.abs(np.abs((found * rotations).sum(-1)) - 1).max() < 1e-12
    places = wave.local_translations()
    assert np.abs(places[:, 0] - root).max() < 1e-9
    assert np.abs(places[:, 1:] - OFFSETS[1:]).max() < 1e-9
    assert (wave.names, wave.parents.tolist(), wave.rate) == (NAMES, PARENTS, RATE)
    assert (wave.frames, wave.seconds) == (90, 3.0)


def test_positions_are_where_kinematics_put_joints(wave, walk):
    for motion in (wave, walk):
        expected = world(motion.local_rotations(), motion.local_translations(),
                         motion.parents.tolist())
        assert np.abs(motion.world_positions() - expected).max() < 1e-9


def test_rotations_do_not_jump_in_sign(walk):
    rotations = walk.local_rotations()
    assert ((rotations[1:] * rotations[:-1]).sum(-1) > 0).all()


def test_a_joint_that_moves_in_its_parent_is_kept(arrays):
    rotations, root = arrays
    places = np.repeat(OFFSETS[None], len(root), axis=0)
    places[:, 0] = root
    places[:, 4, 1] += np.linspace(0, 10, len(root))
    motion = mocapress.Motion.from_numpy(NAMES, PARENTS, OFFSETS, rotations, places, rate=RATE)
    assert np.abs(motion.local_translations() - places).max() < 1e-9


def test_channels_are_a_view_that_outlives_its_motion():
    rotations = np.tile([1.0, 0, 0, 0], (20000, 5, 1))
    motion = mocapress.Motion.from_numpy(NAMES, PARENTS, OFFSETS, rotations, rate=RATE)
    tracemalloc.start()
    views = [motion.channels for _ in range(100)]
    copied = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert copied < 100_000 < views[0].nbytes
    assert views[0].ctypes.data == views[1].ctypes.data
    with pytest.raises(ValueError):
        views[0][0, 0] = 1
    del motion, views[1:]
    gc.collect()
    assert np.isfinite(views[0]).all()


def test_joints_that_only_the_rounding_of_floats_moves_stand_still(walk):
    def with_places(places):
        return mocapress.Motion.from_numpy(walk.names, walk.parents, walk.offsets, walk.local_rotations(), places,
                                           rate=walk.rate)

    places = walk.local_translations() + np.random.default_rng(1).uniform(-4e-5, 4e-5, (walk.frames, 1, 3))
    still = with_places(places)
    assert still.channels.shape[1] == 3 * len(walk.names) + 3
    places[:, 1, 0] += np.linspace(0, 0.001, walk.frames)
    assert with_places(places).channels.shape[1] == still.channels.shape[1] + 3


def test_channels_make_a_motion_of_the_same_skeleton(walk):
    half = walk.with_channels(walk.channels[::2], rate=walk.rate / 2)
    assert half.names == walk.names and half.rate == walk.rate / 2
    assert np.array_equal(half.world_positions(), walk.world_positions()[::2])
    assert np.array_equal(walk.with_channels(walk.channels.astype("f4")).channels,
                          walk.channels.astype("f4").astype("f8"))


@pytest.mark.parametrize("changed, why", [
    ({"parents": [-1, 2, 1, 0, 3]}, "the parent of joint 1 does not come before it"),
    ({"parents": [-1]}, "rotations are not frames x joints x 4"),
    ({"names": NAMES[:4]}, "parents are not one for each of 4 names"),
    ({"offsets": OFFSETS[:3]}, "offsets are not joints x 3"),
    ({"offsets": 3}, "offsets are not joints x 3"),
    ({"rotations": np.zeros((0, 5, 4))}, "rotations are not frames x joints x 4"),
    ({"rotations": np.zeros((90, 5, 4))}, "a quaternion of length 0"),
    ({"rotations": np.full((90, 5, 4), np.nan)}, "a value is not finite"),
    ({"translations": np.zeros((7, 3))}, "another number of frames"),
    ({"translations": np.zeros((90, 4))}, "neither frames x 3 nor"),
    ({"rate": 0.0}, "the rate is not above 0"),
    ({"end_sites": {9: (0, 1, 0)}}, "an end site is not of a joint"),
])
def test_arrays_that_are_no_motion_are_refused(arrays, changed, why):
    given = {"names": NAMES, "parents": PARENTS, "offsets": OFFSETS, "rotations": arrays[0],
             "translations": arrays[1], "rate": RATE, **changed}
    with pytest.raises(ValueError, match=why):
        mocapress.Motion.from_numpy(**given)


def test_warnings_that_are_given_are_kept_as_they_are():
    motion = mocapress.Motion.from_numpy(["a"], [-1], [[0, 0, 0]], [[[1, 0, 0, 0]]], rate=30,
                                         warnings=["a.npz: has no offsets"])
    assert motion.warnings == ["a.npz: has no offsets"]


def test_channels_of_another_shape_are_refused(walk):
    for channels in (np.zeros((4, 3)), np.zeros(3), np.full(walk.channels.shape, np.inf)):
        with pytest.raises(ValueError):
            walk.with_channels(channels)


@pytest.mark.parametrize("extension", ["bvh", "glb"])
def test_a_written_motion_is_read_again(walk, tmp_path, extension):
    path = tmp_path / f"Läufer.{extension}"
    mocapress.write(walk, path)
    again = mocapress.read(path, cm_per_unit=1) if extension == "bvh" else mocapress.read(path)
    assert again.frames == walk.frames
    joints = [again.names.index(name) for name in ("lhand", "rfoot")]
    own = [walk.names.index(name) for name in ("lhand", "rfoot")]
    assert np.abs(again.world_positions()[:, joints] - walk.world_positions()[:, own]).max() < 1e-2


def test_tracks_come_with_a_clip(walk, tmp_path):
    mocapress.write(walk, tmp_path / "walk.bvh")
    values = np.linspace(0, 1, walk.frames, dtype="f4")
    (tmp_path / "walk.tracks.csv").write_text("smile\n" + "\n".join(map(str, values)) + "\n")
    motion = mocapress.read(tmp_path / "walk.bvh")
    track, = motion.tracks
    assert (track.label, track.kind, track.steps) == ("smile", "property", False)
    del motion
    gc.collect()
    assert np.abs(track.values - values).max() < 1e-6 and not track.values.flags.writeable
    kept, = mocapress.encode(mocapress.read(tmp_path / "walk.bvh"), error=1).decode().tracks
    assert np.abs(kept.values - values).max() <= 0.002


def test_contacts_name_a_foot_and_its_frames(walk):
    contacts = walk.contacts()
    assert contacts and all(set(one) == {"joint", "first_frame", "last_frame"} for one in contacts)
    assert {one["joint"][0] for one in contacts} == {"l", "r"}
    mocapress.encode(walk, error=1, contacts=contacts)


def test_names_in_a_bvh_are_words_of_which_no_two_are_alike(tmp_path):
    motion = mocapress.Motion.from_numpy(["l leg", "toe", "toe"], [-1, 0, 1], np.zeros((3, 3)),
                                         np.tile([1.0, 0, 0, 0], (2, 3, 1)), rate=30)
    mocapress.write(motion, tmp_path / "a.bvh")
    assert motion.bvh_names == mocapress.read(tmp_path / "a.bvh").names
    assert len(set(motion.bvh_names)) == 3 and not any(" " in word for word in motion.bvh_names)


def test_names_of_other_bytes_than_utf8_come_back(tmp_path, arrays):
    names = ["H\udcffps", *NAMES[1:]]
    motion = mocapress.Motion.from_numpy(names, PARENTS, OFFSETS, arrays[0], rate=RATE)
    assert motion.names == names


def test_a_file_that_cannot_be_read_is_an_input_error_with_its_place(tmp_path):
    path = tmp_path / "a.bvh"
    path.write_text("HIERARCHY\nROOT a\n{\nOFFSET x\n")
    with pytest.raises(mocapress.InputError) as caught:
        mocapress.read(path)
    assert str(caught.value).startswith(f"{path}:4:") and caught.value.line == 4
    with pytest.raises(mocapress.InputError, match="none.bvh"):
        mocapress.read(tmp_path / "none.bvh")
    with pytest.raises(ValueError, match="up is none of y, z: x"):
        mocapress.read(path, up="x")
    with pytest.raises(mocapress.WriteError):
        mocapress.write(mocapress.Motion.from_numpy(["a"], [-1], [[0, 0, 0]], [[[1, 0, 0, 0]]],
                                                    rate=30), tmp_path / "no" / "a.bvh")
