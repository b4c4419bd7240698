# SPDX-License-Identifier: MIT
import subprocess

import pytest
from conftest import PROGRAM, SAMPLES, needs_program

import mocapress

WALK = SAMPLES / "human_walk.amc"


def encode_walk(**settings):
    return mocapress.encode(mocapress.read(WALK), **settings)


@needs_program
@pytest.mark.parametrize("words, call, failure", [
    (["compress", "bad.bvh", "-o", "a.mcpr"], lambda: mocapress.read("bad.bvh"), mocapress.InputError),
    (["compress", "no.bvh", "-o", "a.mcpr"], lambda: mocapress.read("no.bvh"), mocapress.InputError),
    (["compress", "a.xyz", "-o", "a.mcpr"], lambda: mocapress.read("a.xyz"), mocapress.InputError),
    (["info", "bad.mcpr"], lambda: mocapress.open("bad.mcpr"), mocapress.InputError),
    (["decompress", "no.mcpr", "-o", "a.bvh"], lambda: mocapress.open("no.mcpr"), mocapress.InputError),
    (["bank", "list", "bad.mcpk"], lambda: mocapress.Bank("bad.mcpk"), mocapress.InputError),
    (["batch", WALK, "-o", "out", "--preset", "none"], lambda: encode_walk(preset="none"),
     mocapress.InputError),
    (["compress", WALK, "-o", "a.mcpr", "--target-size", "1"], lambda: encode_walk(size=1),
     mocapress.TargetMissed),
    (["compress", WALK, "-o", "no/a.mcpr", "--target-error", "1"],
     lambda: encode_walk(error=1).save("no/a.mcpr"), mocapress.WriteError),
])
def test_failures_have_the_sentences_of_the_program(tmp_path, monkeypatch, words, call, failure):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bad.bvh").write_text("HIERARCHY\nROOT a\n{\nOFFSET x\n")
    (tmp_path / "bad.mcpr").write_bytes(b"MCPR" + 40 * b"x")
    (tmp_path / "bad.mcpk").write_bytes(b"MCPK" + 40 * b"x")
    program = subprocess.run([PROGRAM, *words], capture_output=True, text=True)
    assert program.returncode != 0
    with pytest.raises(failure) as caught:
        call()
    assert f"mocapress: {caught.value}" in program.stderr.splitlines()
