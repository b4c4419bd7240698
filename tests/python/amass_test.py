# SPDX-License-Identifier: MIT
import numpy as np
import pytest

import mocapress


def write_npz(path, **changed):
    frames = 40
    poses = 0.3 * np.sin(np.arange(frames)[:, None] / 9 + np.arange(156))
    arrays = {"poses": poses, "trans": np.outer(np.arange(frames), [0.01, 0, 0]) + [0, 0, 0.9],
              "mocap_framerate": 120.0, "betas": np.zeros(16), "gender": "neutral", **changed}
    np.savez(path, **{key: value for key, value in arrays.items() if value is not None})
    return path


def test_an_amass_file_is_read_in_centimetres_with_y_up(tmp_path):
    motion = mocapress.read(write_npz(tmp_path / "a.npz"))
    assert (motion.frames, motion.rate, len(motion.names)) == (40, 120.0, 52)
    assert motion.names[20:23] == ["left_wrist", "right_wrist", "left_index1"]
    assert motion.parents[[22, 23, 37, 38]].tolist() == [20, 22, 21, 37]
    root = motion.world_positions()[:, 0]
    assert np.allclose(root[:, 1], 90) and np.allclose(root[:, 0], np.arange(40))
    assert any("no offsets" in warning for warning in motion.warnings)


def test_joints_of_smplx_have_the_face_between_body_and_fingers(tmp_path):
    frames = 3
    path = write_npz(tmp_path / "a.npz", poses=np.zeros((frames, 165)), trans=np.zeros((frames, 3)),
                     mocap_framerate=None, mocap_frame_rate=60.0)
    motion = mocapress.read(path)
    assert (len(motion.names), motion.rate) == (55, 60.0)
    assert motion.names[21:26] == ["right_wrist", "jaw", "left_eye", "right_eye", "left_index1"]
    assert motion.parents[[22, 24, 25, 26, 40, 54]].tolist() == [15, 15, 20, 25, 21, 53]


def test_the_body_stands_upright_when_its_root_is_turned_up(tmp_path):
    poses = np.zeros((2, 66))
    poses[:, 0] = np.pi / 2  # the body model has y up, the file z
    motion = mocapress.read(write_npz(tmp_path / "a.npz", poses=poses, trans=np.zeros((2, 3))))
    places = motion.world_positions()[0]
    head, foot = motion.names.index("head"), motion.names.index("left_foot")
    assert places[head, 1] > 50 and places[foot, 1] < -80
    assert np.abs(places[head, [0, 2]]).max() < 10


def test_given_offsets_are_taken(tmp_path):
    offsets = np.full((52, 3), 2.0)
    motion = mocapress.read(write_npz(tmp_path / "a.npz"), offsets=offsets)
    assert np.allclose(motion.offsets, offsets) and motion.warnings == []


def test_a_written_motion_comes_back(walk, wave, tmp_path):
    for motion in (walk, wave):
        path = tmp_path / "Ö.npz"
        assert mocapress.write(motion, path) == []
        again = mocapress.read(path)
        assert (again.names, again.rate, again.warnings) == (motion.names, motion.rate, [])
        assert again.parents.tolist() == motion.parents.tolist()
        assert np.abs(again.world_positions() - motion.world_positions()).max() < 1e-8
        with np.load(path) as file:
            assert file["poses"].shape == (motion.frames, 3 * len(motion.names))


def test_joints_that_move_are_named_when_they_cannot_be_kept(tmp_path):
    places = np.zeros((3, 2, 3))
    places[:, 1, 0] = [1, 2, 3]
    motion = mocapress.Motion.from_numpy(["a", "b"], [-1, 0], [[0, 0, 0], [1, 0, 0]],
                                         np.tile([1.0, 0, 0, 0], (3, 2, 1)), places, rate=30)
    assert mocapress.write(motion, tmp_path / "a.npz") == [
        "joints that move in their parents stay at their offsets: b"]
    two = mocapress.Motion.from_numpy(["a", "b"], [-1, -1], np.zeros((2, 3)),
                                      np.tile([1.0, 0, 0, 0], (3, 2, 1)), rate=30)
    with pytest.raises(mocapress.WriteError, match="one root"):
        mocapress.write(two, tmp_path / "b.npz")
    with pytest.raises(mocapress.WriteError):
        mocapress.write(motion, tmp_path / "no" / "a.npz")


@pytest.mark.parametrize("changed, why", [
    ({"poses": None}, "lacks poses"),
    ({"mocap_framerate": None}, "lacks poses"),
    ({"poses": np.zeros((40, 155))}, "poses are not frames x 3"),
    ({"poses": np.zeros((40, 171))}, "has 57 joints"),
    ({"poses": np.full((40, 156), np.nan)}, "a value is not finite"),
    ({"poses": np.full((40, 156), "a")}, "are not numbers"),
    ({"trans": np.zeros((3, 3))}, "trans is not frames x 3"),
    ({"mocap_framerate": -1.0}, "the rate is not above 0"),
    ({"offsets": np.zeros((3, 3))}, "offsets are not joints x 3"),
    ({"offsets": np.array(["a"])}, "offsets are not numbers"),
    ({"poses": np.array([{}], dtype=object)}, "not an .npz archive that can be read"),
    ({"joint_names": ["a"], "parents": [-1]}, "parents are not one|rotations are not"),
    ({"joint_names": ["a"] * 52, "parents": ["x"] * 52}, "parents are not whole numbers"),
])
def test_a_file_that_is_no_motion_is_an_input_error(tmp_path, changed, why):
    path = write_npz(tmp_path / "bad.npz", **changed)
    with pytest.raises(mocapress.InputError, match=f"bad.npz: .*({why})"):
        mocapress.read(path)


def test_other_files_are_input_errors(tmp_path):
    whole = write_npz(tmp_path / "a.npz").read_bytes()
    path = tmp_path / "bad.npz"
    for damaged in (b"", b"PK\3\4", whole[:-200], whole[:3000] + b"\xff" * 400 + whole[3400:]):
        path.write_bytes(damaged)
        with pytest.raises(mocapress.InputError, match="bad.npz"):
            mocapress.read(path)
    np.save(tmp_path / "one.npy", np.zeros(3))
    (tmp_path / "one.npy").rename(path)
    with pytest.raises(mocapress.InputError, match="is not an .npz archive"):
        mocapress.read(path)
    with pytest.raises(mocapress.InputError, match="none.npz"):
        mocapress.read(tmp_path / "none.npz")
