"""Reads the program as a screen reader does, through AT-SPI: every page, every tab.

usage: walk.py PROGRAM      (in a D-Bus session of its own, with a display: see run.sh)

What can have the focus has a name; a field, a slider and a plot have a description; values can be
read; a plot says its numbers in a sentence. Prints what is wrong and ends with 1 where something is.
"""

import subprocess
import sys
import time
import warnings

import gi

gi.require_version("Atspi", "2.0")
from gi.repository import Atspi, GLib  # noqa: E402

warnings.simplefilter("ignore", DeprecationWarning)  # names that older releases have alone
Role, State = Atspi.Role, Atspi.StateType
FIELDS = {Role.ENTRY, Role.TEXT, Role.SPIN_BUTTON, Role.SLIDER, Role.COMBO_BOX}
PATIENCE = 60.0  # seconds until the program has said something


def rest(seconds):
    """Waits, and meanwhile hears what the program tells about itself."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        while GLib.MainContext.default().iteration(False):
            pass
        time.sleep(0.02)


def children(node):
    for index in range(node.get_child_count()):
        child = node.get_child_at_index(index)
        if child is not None:
            yield child


def everything(node):
    """What is on the screen below a node."""
    if not has(node, State.SHOWING):
        return
    yield node
    # Of a table and of an open list only the whole counts, not each of a thousand cells.
    if node.get_role() in (Role.TABLE, Role.LIST, Role.COMBO_BOX, Role.SPIN_BUTTON, Role.TREE_TABLE):
        return
    for child in children(node):
        yield from everything(child)


def has(node, state):
    return node.get_state_set().contains(state)


def place(node):
    words = []
    while node is not None and node.get_role() != Role.APPLICATION:
        words.append(f"{node.get_role_name()} “{node.get_name()}”")
        node = node.get_parent()
    return " in ".join(words[:4])


def wait_for(find, what):
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        found = find()
        if found:
            return found
        rest(0.2)
    sys.exit(f"not found within {PATIENCE:.0f} s: {what}")


def application(process):
    desktop = Atspi.get_desktop(0)
    for app in children(desktop):
        if app.get_process_id() == process.pid:
            return app
    return None


def press(node):
    names = [Atspi.Action.get_action_name(node, i) for i in range(Atspi.Action.get_n_actions(node))]
    wanted = next(name for name in ("Press", "Toggle") if name in names)
    Atspi.Action.do_action(node, names.index(wanted))
    rest(0.3)


def is_navigation(node):
    """The buttons of the pages say their keys: "(Ctrl+1)"."""
    return node.get_role() == Role.CHECK_BOX and "(Ctrl+" in node.get_description()


def is_focus_stop(node):
    """Tabs have the focus on the bar; a pane that holds them passes it on."""
    return has(node, State.FOCUSABLE) and node.get_role() != Role.FRAME and not any(
        child.get_role() == Role.PAGE_TAB_LIST for child in children(node))


class Walk:
    def __init__(self):
        self.troubles = []
        self.checked = set()
        self.seen = {"focus stops": 0, "fields": 0, "values": 0, "plots": 0}

    def wrong(self, page, node, what):
        self.troubles.append(f"{page}: {what}: {place(node)}")

    def check(self, page, node):
        role = node.get_role()
        if is_focus_stop(node):
            self.seen["focus stops"] += 1
            if not node.get_name().strip():
                self.wrong(page, node, "no name")
        if role in FIELDS and has(node, State.FOCUSABLE):
            self.seen["fields"] += 1
            if not node.get_description().strip():
                self.wrong(page, node, "no description")
        if role in (Role.SLIDER, Role.SPIN_BUTTON):
            self.seen["values"] += 1
            if not isinstance(Atspi.Value.get_current_value(node), float):
                self.wrong(page, node, "no value")
        if role in (Role.ENTRY, Role.TEXT):
            self.seen["values"] += 1
            Atspi.Text.get_text(node, 0, Atspi.Text.get_character_count(node))
        if role == Role.CHART:
            self.seen["plots"] += 1
            sentence = node.get_description()
            if not any(letter.isdigit() for letter in sentence):
                self.wrong(page, node, f"no sentence (“{sentence}”)")

    def check_all(self, page, window):
        """@return the tabs that are on the screen"""
        tabs = []
        for node in everything(window):
            if node.get_role() == Role.PAGE_TAB:
                tabs.append(node)
            if node not in self.checked:
                self.checked.add(node)
                self.check(page, node)
        return tabs

    def page(self, name, window):
        pressed = set()
        while True:  # tabs that lie within tabs come up by and by
            fresh = [tab for tab in self.check_all(name, window) if tab not in pressed]
            if not fresh:
                return
            pressed.add(fresh[0])
            press(fresh[0])


def main(program):
    process = subprocess.Popen([program], stderr=subprocess.DEVNULL)
    walk = Walk()
    try:
        app = wait_for(lambda: application(process), "the program on the bus")
        window = wait_for(lambda: next(iter(children(app)), None), "its window")
        pages = wait_for(lambda: [n for n in everything(window) if is_navigation(n)], "its pages")
        for button in pages:
            name = button.get_name().replace("\n", " ")
            press(button)
            wait_for(lambda: name in window.get_name(), f"the page {name}")
            walk.page(name, window)
    finally:
        process.terminate()
        process.wait()
    print(", ".join(f"{count} {what}" for what, count in walk.seen.items()))
    for trouble in walk.troubles:
        print(trouble)
    return 1 if walk.troubles or 0 in walk.seen.values() else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
