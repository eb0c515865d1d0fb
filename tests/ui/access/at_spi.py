#!/usr/bin/env python3
"""A screen reader for tests: what AT-SPI tells of one program, asked line by line.

Every line on standard input is a request in JSON, every line on standard output its answer. `pid` of the first request
says whose tree it is. Without the AT-SPI libraries of Python, the first line is {"missing": why}.
"""
import json
import os
import sys

try:
    import gi

    gi.require_version("Atspi", "2.0")
    from gi.repository import Atspi, GLib
except (ImportError, ValueError) as why:
    print(json.dumps({"missing": str(why)}), flush=True)
    sys.exit(0)

NAMED = {
    "push button", "toggle button", "check box", "radio button", "combo box", "slider", "dial", "spin button",
    "text", "page tab", "menu item", "list", "list item", "tree", "tree table", "table", "chart", "image", "animation",
    "color chooser", "progress bar", "dialog", "notification", "alert",
}
# Empty ones have nothing to say.
QUIET = {"filler", "scroll pane", "label", "table cell", "tree item"}
NUMBERS = {"slider", "dial", "spin button"}
heard = []


def application(pid):
    desktop = Atspi.get_desktop(0)
    for i in range(desktop.get_child_count()):
        child = desktop.get_child_at_index(i)
        if child and child.get_process_id() == pid:
            return child
    return None


def parts(node, path=""):
    """All that can be seen, in order, each with the names of those that it lies in."""
    if node is None:
        return
    here = path + "/" + (node.get_name() or node.get_role_name())
    yield node, here
    for i in range(node.get_child_count()):
        child = node.get_child_at_index(i)
        if child and child.get_state_set().contains(Atspi.StateType.VISIBLE):
            yield from parts(child, here)


def number(node):
    value = node.get_value_iface()
    return value and {
        "value": value.get_current_value(),
        "least": value.get_minimum_value(),
        "most": value.get_maximum_value(),
        "step": value.get_minimum_increment(),
    }


def complaints(app):
    told, count = [], {}
    for node, here in parts(app):
        role = node.get_role_name()
        count[role] = count.get(role, 0) + 1
        states = node.get_state_set()
        focusable = states.contains(Atspi.StateType.FOCUSABLE)
        of_line = node.get_parent() is not None and node.get_parent().get_role_name() == "text"  # Qt's own button in it.
        if (role in NAMED or focusable) and role not in QUIET and not of_line and not node.get_name().strip():
            told.append(f"{here}: a {role} without a name")
        if role in NUMBERS:
            it = number(node)
            if it is None:
                told.append(f"{here}: no value")
            elif not it["least"] <= it["value"] <= it["most"] or not it["least"] < it["most"] or not it["step"] > 0:
                told.append(f"{here}: {it}")
    return told, count


def find(app, name, role=None):
    for node, _ in parts(app):
        if node.get_name() == name and (role is None or node.get_role_name() == role):
            return node
    return None


def near(app, name):
    """A window of the program or a panel of one, without asking all that they hold; None where it is not seen."""
    windows = [app.get_child_at_index(i) for i in range(app.get_child_count())]
    panels = [window.get_child_at_index(i) for window in windows for i in range(window.get_child_count())]
    for node in windows + panels:
        if node and node.get_name() == name and node.get_state_set().contains(Atspi.StateType.VISIBLE):
            return node
    return None


def press(node, which):
    action = node.get_action_iface()
    for i in range(action.get_n_actions() if action else 0):
        if Atspi.Action.get_action_name(action, i) == which:
            return action.do_action(i)
    return False


def answer(request):
    app = application(request["pid"])
    if app is None:
        return {"app": False}
    what = request["do"]
    if what == "heard":
        said, heard[:] = list(heard), []
        return {"heard": said}
    part = near(app, request["within"]) if "within" in request else app
    if part is None:
        return {"found": False}
    if what == "tree":
        told, count = complaints(part)
        return {"complaints": told, "roles": count}
    node = find(part, request["name"], request.get("role"))
    if node is None:
        return {"found": False}
    if what == "number":
        return {"found": True, **(number(node) or {})}
    if what == "set":
        return {"found": True, "done": node.get_value_iface().set_current_value(request["value"])}
    if what == "press":
        return {"found": True, "done": press(node, request["action"])}
    if what == "describe":
        return {"found": True, "role": node.get_role_name(), "description": node.get_description(),
                "actions": [Atspi.Action.get_action_name(node.get_action_iface(), i)
                            for i in range(node.get_action_iface().get_n_actions())] if node.get_action_iface() else []}
    if what == "entries":
        return {"found": True, "entries": [child.get_name() for child, _ in parts(node)][1:]}
    return {"unknown": what}


def take(channel, condition):
    line = sys.stdin.readline()
    if not line:
        loop.quit()
        return False
    try:
        told = answer(json.loads(line))
    except GLib.Error as why:
        told = {"failed": str(why)}
    print(json.dumps(told), flush=True)
    return True


def hear(event):
    try:
        if event.source.get_role_name() in ("notification", "alert"):
            heard.append(event.source.get_name())
    except GLib.Error:
        pass


Atspi.init()
loop = GLib.MainLoop()
listener = Atspi.EventListener.new(hear)
listener.register("object:state-changed:showing")
GLib.io_add_watch(sys.stdin.fileno(), GLib.PRIORITY_DEFAULT, GLib.IO_IN | GLib.IO_HUP, take)
print(json.dumps({"ready": os.getpid()}), flush=True)
loop.run()
