# SPDX-License-Identifier: GPL-3.0-or-later
# The studio as a screen reader meets it: from another process, over AT-SPI's bus. Every control in sight has a name, and
# every chooser says what it is for: Qt names choosers by their chosen entry.
# Usage, on a screen: dbus-run-session -- python3 accessibility_bus_test.py STUDIO CLIP
# Exit code 77: Debian's python3-gi and gir1.2-atspi-2.0 are not installed.
import os
import pathlib
import subprocess
import sys
import tempfile
import time

try:
    import gi
    gi.require_version("Atspi", "2.0")
    from gi.repository import Atspi, GLib
except (ImportError, ValueError):
    sys.exit(77)

TEXTS_OF_MODELS = (Atspi.Role.TABLE_CELL, Atspi.Role.LIST_ITEM)  # may be empty
PATIENCE = 120  # seconds
MENU_ITEMS = ["Study…", "Batch Export…", "Blind Test…", "Find a Command…", "Guide", "Keyboard Map…", "Import Options…"]


def children(item):
    return [child for child in map(item.get_child_at_index, range(item.get_child_count())) if child]


def below(item, place=()):
    """This item and all below it, each with the roles and names of those above."""
    place = (*place, f"{item.get_role_name()} {item.get_name()!r}")
    yield item, place
    for child in children(item):
        yield from below(child, place)


def is_operable(item):
    if item.get_role() in (*TEXTS_OF_MODELS, Atspi.Role.SCROLL_BAR):
        return False
    states = item.get_state_set()
    shown = all(map(states.contains, (Atspi.StateType.SHOWING, Atspi.StateType.ENABLED)))
    return shown and (states.contains(Atspi.StateType.FOCUSABLE) or
                      "Action" in item.get_interfaces() and item.get_n_actions() > 0)


def says_its_purpose(chooser):
    return chooser.get_description() or any(
        relation.get_relation_type() == Atspi.RelationType.LABELLED_BY for relation in chooser.get_relation_set())


def windows():
    return [window for program in children(Atspi.get_desktop(0)) for window in children(program)
            if window.get_state_set().contains(Atspi.StateType.SHOWING)]


def wait_for(found):
    """Returns the first result of `found` that is not None. A walk whose item the studio removes meanwhile starts anew."""
    end = time.monotonic() + PATIENCE
    reason = "no such window or menu"
    while time.monotonic() < end:
        try:
            if (result := found()) is not None:
                return result
        except GLib.GError as error:
            reason = error
        Atspi.get_desktop(0).clear_cache()
        time.sleep(0.1)
    sys.exit(f"the studio on AT-SPI's bus: {reason}")


def faults(window):
    for item, place in below(window):
        if not is_operable(item):
            continue
        if not item.get_name().strip():
            yield "without a name: " + " > ".join(place)
        elif item.get_role() == Atspi.Role.COMBO_BOX and not says_its_purpose(item):
            yield "without a purpose: " + " > ".join(place)


def menu_of(window):
    """The menu items by name; None as long as one is missing that the test needs."""
    items = {item.get_name(): item for item, _ in below(window) if item.get_role() == Atspi.Role.MENU_ITEM}
    return items if items.keys() >= set(MENU_ITEMS) else None


def test(clip):
    main = wait_for(lambda: next((window for window in windows() if clip in window.get_name()), None))
    menu = wait_for(lambda: menu_of(main))
    for count, name in enumerate(MENU_ITEMS, start=2):
        menu[name].do_action(0)
        wait_for(lambda count=count: True if len(windows()) == count else None)
    found = wait_for(lambda: [fault for window in windows() for fault in faults(window)])
    sys.exit("\n".join(found) or 0)


with tempfile.TemporaryDirectory() as folder:
    homes = {name: folder for name in ("HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME")}
    with subprocess.Popen(sys.argv[1:], env={**os.environ, **homes, "LC_ALL": "C.UTF-8",
                                             "QT_LINUX_ACCESSIBILITY_ALWAYS_ON": "1"}) as studio:
        try:
            test(pathlib.Path(sys.argv[2]).name)
        finally:
            studio.kill()
