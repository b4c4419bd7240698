# SPDX-License-Identifier: MIT
import gc
import pathlib
import re
import signal
import subprocess
import threading
import time

import numpy as np
import pytest
from conftest import PROGRAM, SAMPLES, needs_program

import mocapress


class Enough(Exception):
    pass


def test_a_clip_meets_its_target(walk, clip):
    measured = clip.measurement
    assert 0 < measured["eps_x_cm"] <= 0.25
    assert measured["file_bytes"] == clip.nbytes == len(bytes(clip)) == memoryview(clip).nbytes
    again = clip.measure(walk)
    assert abs(again["eps_x_cm"] - measured["eps_x_cm"]) < 1e-6
    assert again["motion_bytes"] == measured["motion_bytes"]


@needs_program
@pytest.mark.parametrize("words, settings", [
    (["--target-error", "0.25"], {"error": 0.25}),
    (["--ratio", "30", "--weighting", "bone-ends", "--ik", "auto"],
     {"ratio": 30, "weighting": "bone-ends", "ik": {"ratio": "auto"}}),
])
def test_the_bytes_are_those_of_the_program(walk, tmp_path, words, settings):
    out = tmp_path / "walk.mcpr"
    subprocess.run([PROGRAM, "compress", SAMPLES / "human_walk.amc", "-o", out, *words], check=True,
                   capture_output=True)
    assert out.read_bytes() == bytes(mocapress.encode(walk, **settings))


@needs_program
def test_presets_are_those_of_the_program(walk, tmp_path):
    for words, settings in ((["--preset", "crowd"], {"preset": "crowd"}),
                            (["--preset", "crowd", "--target-error", "1"],
                             {"preset": "crowd", "error": 1})):
        folder = tmp_path / str(len(words))
        subprocess.run([PROGRAM, "batch", SAMPLES / "human_walk.amc", "-o", folder, *words],
                       check=True, capture_output=True)
        made, = folder.glob("*.mcpr")
        assert made.read_bytes() == bytes(mocapress.encode(walk, **settings))


def test_a_saved_clip_opens_and_plays_as_it_decodes(walk, clip, tmp_path):
    clip.save(tmp_path / "ü.mcpr")
    opened = mocapress.open(tmp_path / "ü.mcpr")
    assert bytes(opened) == bytes(clip)
    with pytest.raises(mocapress.Error, match="was not encoded here"):
        opened.measurement
    assert (opened.names, opened.frames, opened.rate) == (walk.names, walk.frames, walk.rate)
    decoded = opened.decode()
    frames = [0, 17, walk.frames - 1]
    poses = opened.sample(np.array(frames) / opened.rate)
    assert poses.shape == (3, len(walk.names), 7) and poses.dtype == np.float32
    alike = (poses[..., :4] * decoded.local_rotations()[frames]).sum(-1)
    assert np.abs(np.abs(alike) - 1).max() < 1e-5
    assert np.abs(poses[..., 4:] - decoded.local_translations()[frames]).max() < 1e-3
    places = opened.positions(17 / opened.rate)
    assert np.abs(places - decoded.world_positions()[17]).max() < 1e-2
    assert np.array_equal(opened.sample(-1), poses[0])
    assert np.array_equal(mocapress.Clip(memoryview(clip)).positions(17 / opened.rate), places)


def test_a_clip_is_read_only_and_lives_as_long_as_its_view(walk):
    view = memoryview(mocapress.encode(walk, error=1))
    gc.collect()
    assert view.readonly and bytes(view[:4]) == bytes(view)[:4]


def test_settings_are_those_of_the_library(walk):
    small = mocapress.encode(walk, error=1.0)
    preset = mocapress.encode(walk, preset="gameplay")
    assert small.nbytes < preset.nbytes
    assert mocapress.encode(walk, target={"kind": "error", "value": 1.0}).nbytes == small.nbytes
    assert mocapress.encode(walk, max_error=0.5).measurement["surface_max_cm"] <= 0.5
    assert mocapress.encode(walk, ratio=20, method="standard").method == "standard"
    assert mocapress.encode(walk, size=2000).measurement["motion_bytes"] <= 2000


def test_settings_are_numbers_of_numpy_too_and_presets_are_paths_too(walk):
    assert (bytes(mocapress.encode(walk, error=np.float32(1), seed=np.int64(1)))
            == bytes(mocapress.encode(walk, error=1.0, seed=1)))
    assert (mocapress.encode(walk, preset=pathlib.PurePath("crowd")).nbytes
            == mocapress.encode(walk, preset="crowd").nbytes)


@pytest.mark.parametrize("settings, failure, why", [
    ({"eror": 1}, mocapress.InputError, '"eror" is unknown'),
    ({"error": 0}, mocapress.InputError, "target that is not above 0"),
    ({"weighting": "skin"}, mocapress.Error, "needs a clip with a mesh"),
    ({"importance": {"tail": 3}}, mocapress.Error, "tail"),
    ({"preset": "none"}, mocapress.InputError, "neither a file nor a preset"),
    ({"error": 1, "size": 3}, ValueError, "more than one target: error, size"),
    ({"error": float("nan")}, ValueError, "a setting is not finite"),
    ({"ik": {"ratio": object()}}, TypeError, "a setting is a object"),
    ({"size": 1}, mocapress.TargetMissed, ""),
])
def test_settings_that_cannot_be_met_say_why(walk, settings, failure, why):
    with pytest.raises(failure, match=why):
        mocapress.encode(walk, **settings)


def test_an_encoder_gives_the_bytes_of_a_single_encoding(walk, clip):
    encoder = mocapress.Encoder(walk)
    encoder.encode(error=1.0)
    assert bytes(encoder.encode(error=0.25)) == bytes(clip)


def test_progress_is_told_and_what_it_raises_stops_the_work(walk, clip):
    told = []
    seen = mocapress.encode(walk, error=0.25,
                            progress=lambda p: told.append((p.trial, p.iteration, p.error_cm)))
    assert told and all(trial >= 0 for trial, _, _ in told) and bytes(seen) == bytes(clip)
    calls = []

    def stop(progress):
        assert re.fullmatch(r"<mocapress.Progress: trial \d+, iteration \d+, [\d.]+ cm>", repr(progress))
        calls.append(progress)
        raise Enough("by the user")

    with pytest.raises(Enough, match="by the user"):
        mocapress.encode(walk, error=0.25, progress=stop)
    assert len(calls) == 1


def test_ctrl_c_stops_an_encoding(walk):
    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # shells start jobs in the background without one
    try:
        with pytest.raises(KeyboardInterrupt):
            mocapress.encode(walk, progress=lambda _: signal.raise_signal(signal.SIGINT))
    finally:
        signal.signal(signal.SIGINT, before)


def test_other_threads_run_while_a_clip_is_encoded(walk):
    done = threading.Event()
    turns = []

    def count():
        while not done.is_set():
            turns.append(time.perf_counter())
            done.wait(0.001)

    other = threading.Thread(target=count)
    encoder = mocapress.Encoder(walk)
    reports = []
    other.start()
    try:
        encoder.encode(error=0.1, progress=lambda _: reports.append(time.perf_counter()))
    finally:
        done.set()
        other.join()
    assert any(reports[0] < turn < reports[-1] for turn in turns)


def test_threads_share_a_clip_and_an_encoder(walk, clip):
    encoder = mocapress.Encoder(walk)
    expected = clip.positions([0.5])
    failures = []

    def work():
        try:
            assert bytes(encoder.encode(error=0.25)) == bytes(clip)
            assert np.array_equal(mocapress.Clip(clip).positions([0.5]), expected)
            assert np.array_equal(clip.positions([0.5]), expected)
        except BaseException as failure:  # told by the test
            failures.append(failure)

    threads = [threading.Thread(target=work) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures


def test_bytes_that_are_no_clip_are_refused(clip, tmp_path):
    whole = bytes(clip)
    for damaged in (b"", b"no", whole[:-1], whole[:200] + b"\xff" * 20 + whole[220:]):
        with pytest.raises(mocapress.FormatError) as caught:
            mocapress.Clip(damaged)
        assert caught.value.byte_offset >= 0
        (tmp_path / "bad.mcpr").write_bytes(damaged)
        with pytest.raises(mocapress.InputError, match="bad.mcpr"):
            mocapress.open(tmp_path / "bad.mcpr")
    with pytest.raises(mocapress.Error, match="not finite"):
        clip.sample(float("nan"))
    with pytest.raises(mocapress.Error, match="the clip is no loop, and stands after its last frame"):
        clip.sample(0.5, loop=True)
    with pytest.raises(ValueError, match="instants"):
        clip.sample([[0.5]])
    assert issubclass(mocapress.InputError, mocapress.Error)


def test_measuring_another_motion_is_refused(wave, clip):
    with pytest.raises(mocapress.Error):
        clip.measure(wave)


def test_a_coarse_clip_is_seen_and_a_fine_one_is_not(walk):
    coarse = mocapress.visibility(walk, mocapress.encode(walk, error=3).decode())
    fine = mocapress.visibility(walk, mocapress.encode(walk, error=0.05).decode())
    assert (coarse.verdict, fine.verdict) == ("visible", "not-visible")
    assert coarse.times_noticed == pytest.approx(float(coarse.table.max()), rel=1e-5)
    assert coarse.reason and 0 < coarse.visible_share <= 1
    assert coarse.distance_m == 5
    assert coarse.table.shape[1] == len(walk.names) and not coarse.table.flags.writeable
    assert abs(coarse.table.shape[0] * coarse.window_frames - walk.frames) < 2 * coarse.window_frames


def test_viewers_who_are_further_away_notice_less(walk):
    clip = mocapress.encode(walk, error=0.5)
    far = mocapress.visibility(walk, clip.decode(), limits={"distance_m": 40})
    near = mocapress.visibility(walk, clip.decode())
    assert far.distance_m == 40 and far.times_noticed < near.times_noticed
    assert far.unnoticed_from_m == pytest.approx(near.unnoticed_from_m)
    measured = clip.measure(walk, limits={"distance_m": 40, "head": {"least": 1}})
    assert (measured["distance_m"], measured["own_limits"]) == (40, {"head": {"least": 1}})
    with pytest.raises(mocapress.InputError, match="hands"):
        mocapress.visibility(walk, clip.decode(), limits={"hands": {"least": 1}})
