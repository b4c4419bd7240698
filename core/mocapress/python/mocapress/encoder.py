# SPDX-License-Identifier: MIT
"""Settings by keywords, and the encoder that takes them."""
from __future__ import annotations

import json
import os
from typing import Any, Callable

from . import _core

TARGETS = ("error", "max_error", "not_visible", "ratio", "size", "coefficient_ratio")


def _plain(value: Any) -> Any:
    """A number or an array of NumPy as JSON has it."""
    try:
        return value.tolist()
    except AttributeError:
        raise TypeError(f"a setting is a {type(value).__name__}, which JSON has not") from None


def settings_json(preset: str | os.PathLike[str] | None, settings: dict[str, Any]) -> str:
    chosen: dict[str, Any] = json.loads(_core.preset_json(os.fspath(preset))) if preset else {}
    targets = [name for name in TARGETS if settings.get(name) is not None]
    if len(targets) > 1 or (targets and "target" in settings):
        raise ValueError("more than one target: " + ", ".join(
            targets + ["target"] * ("target" in settings)))
    if targets or "target" in settings:
        chosen.pop("promises", None)  # they belong to the preset's own target
    for name in targets:
        chosen["target"] = {"kind": name.replace("_", "-"), "value": settings[name]}
    chosen.update((name, value) for name, value in settings.items() if name not in TARGETS)
    try:
        return json.dumps(chosen, allow_nan=False, default=_plain)
    except ValueError:
        raise ValueError("a setting is not finite") from None


class Encoder:
    """Encodes one motion any number of times, and computes once what all encodings share.

    It keeps a copy of the motion's channels.
    """

    def __init__(self, motion: _core.Motion) -> None:
        self._encoder = _core.Encoder(motion)

    def encode(self, *, preset: str | os.PathLike[str] | None = None,
               progress: Callable[[_core.Progress], object] | None = None,
               **settings: Any) -> _core.Clip:
        """The smallest Clip that meets a target. Other threads run meanwhile.

        One target: error (the mean, cm), max_error (cm), not_visible (times what is noticed; 1:
        not visible), ratio, size (bytes) or coefficient_ratio. Left out: the preset's, else an
        error of 0.5 cm. It takes the place of the preset's target and of its promises.
        preset: "gameplay", "hero-close-up", "planted-feet", "crowd", "archive", or a file of one.
        Other settings have the names and values of the library's JSON: method, coding, weighting,
        seed, effort, importance, promises, limits, ends, loop, track_error, ik, contacts,
        importance_ranges. Frames in these count from 0, in sentences from 1.
        progress: called now and then with a Progress. An exception from it stops the encoding, and comes
        out of encode(), as does KeyboardInterrupt.

        Raises InputError for settings that do not exist, Error for those that this motion cannot
        have, TargetMissed where nothing meets the target, ValueError for several targets and for
        numbers that are not finite.
        """
        return self._encoder.encode(settings_json(preset, settings), progress)


def encode(motion: _core.Motion, **settings: Any) -> _core.Clip:
    """Encodes a motion once, by the settings of Encoder.encode(). Copies the channels meanwhile."""
    return Encoder(motion).encode(**settings)
