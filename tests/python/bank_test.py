# SPDX-License-Identifier: MIT
import numpy as np
import pytest

import mocapress


@pytest.fixture(scope="module")
def files(walk, clip, tmp_path_factory):
    folder = tmp_path_factory.mktemp("clips")
    clip.save(folder / "fine.mcpr")
    mocapress.encode(walk, error=1).save(folder / "coarse.mcpr")
    return {"walk/fine": folder / "fine.mcpr", "walk/coarse": folder / "coarse.mcpr"}


def test_a_packed_bank_gives_each_clip_back(files, tmp_path):
    path = tmp_path / "b.mcpk"
    mocapress.Bank.make(path, files, tags=["gait"], texts={"made by": "a test"})
    bank = mocapress.Bank(path)
    assert sorted(bank) == bank.names == sorted(files) and len(bank) == 2 and not bank.is_cooked
    for name, file in files.items():
        assert name in bank and bytes(bank[name]) == file.read_bytes()
    assert bank.tags("walk/fine") == ["gait"] and bank.texts == {"made by": "a test"}
    assert "none" not in bank and 3 not in bank
    with pytest.raises(KeyError, match="none"):
        bank["none"]
    with pytest.raises(mocapress.Error, match="packed"):
        bank.sample("walk/fine", 0)


def test_a_cooked_bank_is_sampled_as_its_clips_are(files, clip, tmp_path):
    path = tmp_path / "b.mcpk"
    mocapress.Bank.make(path, files, cooked=True)
    bank = mocapress.Bank(path)
    instants = [0.0, 0.51, 2.0]
    found, expected = bank.sample("walk/fine", instants), clip.sample(instants)
    assert bank.is_cooked and found.shape == expected.shape
    assert np.abs(np.abs((found[..., :4] * expected[..., :4]).sum(-1)) - 1).max() < 1e-5
    assert np.abs(found[..., 4:] - expected[..., 4:]).max() < 1e-2
    assert bank.sample("walk/fine", 0.51).shape == found[1].shape
    with pytest.raises(mocapress.InputError, match="cooked"):
        bank["walk/fine"]
    with pytest.raises(mocapress.Error, match="the clip is no loop, and stands after its last frame"):
        bank.sample("walk/fine", 0.5, loop=True)
    assert repr(bank) == f"<mocapress.Bank: cooked, {len(files)} clips>"


def test_files_that_are_no_bank_are_refused(files, tmp_path):
    with pytest.raises(mocapress.InputError, match="fine.mcpr"):
        mocapress.Bank(files["walk/fine"])
    with pytest.raises(mocapress.InputError):
        mocapress.Bank.make(tmp_path / "b.mcpk", {"a": tmp_path / "none.mcpr"})
    assert not (tmp_path / "b.mcpk").exists()
