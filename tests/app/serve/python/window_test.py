"""The service of an open window, used by the Python package: VITRINE_PROGRAM names the program. Needs a display."""

import os
import pathlib
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy
import vitrine

SMALL = {"alone": True, "size": (32, 18), "samples": 1}
PATIENCE = 60


def xdotool(*words):
    done = subprocess.run(["xdotool", *map(str, words)], capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(f"xdotool {words}: {done.stderr}")
    return done.stdout


def until(found, what):
    """Waits until `found()` is true, and returns it."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        if value := found():
            return value
        time.sleep(0.05)
    raise AssertionError(what)


class WindowTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.socket = self.folder / "window.socket"
        for name in ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME"):
            os.environ[name] = str(self.folder / name)
        os.environ["LC_ALL"] = "C.UTF-8"
        self.program = self.open()
        self.code = None  # With which the window ends by itself.
        until(self.socket.exists, "the window serves")
        self.window = until(self.find, "there is a window").split()[0]
        self.v = vitrine.Session(socket=str(self.socket), timeout=240)

    def tearDown(self):
        self.v.close()
        ended = self.program.poll()
        self.program.terminate()
        self.program.wait()
        self.temporary.cleanup()
        self.assertEqual(ended, self.code, "the code with which the window ended during the test")

    def open(self):
        return subprocess.Popen([os.environ["VITRINE_PROGRAM"], "--serve", str(self.socket)])

    def find(self):
        if self.program.poll() is not None:
            raise AssertionError(f"the program ended with {self.program.returncode}")
        words = ["xdotool", "search", "--onlyvisible", "--pid", str(self.program.pid), "--name", "Vitrine"]
        found = subprocess.run(words, capture_output=True, text=True)
        return found.stdout.strip() if found.returncode == 0 else ""

    def morph(self):
        return self.v.get("sdf_morph", names=["morph"])["values"]["morph"]

    def test_what_is_set_is_the_windows_and_can_be_undone_there(self):
        initial = self.morph()
        for value in (0.9, 0.8, 0.2):  # A sweep is one step of the window.
            self.assertEqual(self.v.set("sdf_morph", values={"morph": value})["values"]["morph"], value)
        self.assertEqual(self.morph(), 0.2)
        heard, ready = [], threading.Event()

        def listen():
            try:
                for event in other.events(timeout=PATIENCE):
                    heard.append(event)
                    ready.set()
            except vitrine.ConnectionLost:
                pass  # The window is closed at the end of the test.

        with vitrine.Session(socket=str(self.socket), timeout=240) as other:
            listener = threading.Thread(target=listen, daemon=True)
            listener.start()
            time.sleep(0.5)
            xdotool("windowfocus", "--sync", self.window)
            xdotool("key", "--window", self.window, "ctrl+z")
            until(lambda: self.morph() == initial, "Ctrl+Z takes back what the service set")
            self.assertTrue(ready.wait(PATIENCE), "a change by the visitor is an event")
            changed = [event.params for event in heard if event.kind == "changed"]
            self.assertEqual(changed[0]["exhibit"], "sdf_morph")
            self.assertEqual(changed[0]["values"], {"morph": initial})
            xdotool("key", "--window", self.window, "ctrl+shift+z")
            until(lambda: self.morph() == 0.2, "it can be done again")

    def test_a_visitor_goes_to_an_exhibit(self):
        camera = self.v.visit("fur")["camera"]
        self.assertEqual(len(camera["eye"]), 3)
        until(lambda: "Fur with Physics" in xdotool("getwindowname", self.window), "the window shows the exhibit")
        self.assertIn("hall", self.v.visit("hall")["exhibit"])
        until(lambda: "Fur" not in xdotool("getwindowname", self.window), "the window shows the hall")
        with self.assertRaises(vitrine.Error):
            self.v.visit("nobody")

    def test_pictures_are_drawn_beside_it(self):
        self.v.set("sdf_morph", values={"morph": 0.25})
        picture = self.v.picture("sdf_morph", display=True, **SMALL)
        out = self.folder / "alone.png"
        words = ["render", "sdf_morph", "--alone", "--size", "32x18", "--samples", "1", "--set", "morph=0.25"]
        subprocess.run([os.environ["VITRINE_PROGRAM"], *words, "--out", str(out)], check=True, capture_output=True)
        with vitrine.open(timeout=240) as own:
            own.set("sdf_morph", values={"morph": 0.25})
            numpy.testing.assert_array_equal(picture.array, own.picture("sdf_morph", display=True, **SMALL).array)
        made = self.v.render("sdf_morph", out=str(self.folder / "beside.png"), **SMALL)
        self.assertEqual(pathlib.Path(made["out"]).name, "beside.png")
        distances = self.v.compare(str(out), str(self.folder / "beside.png"))["distances"]
        self.assertEqual(distances["max"], 0)

    def test_the_window_ends_it(self):
        geometry = dict(line.split("=") for line in xdotool("getwindowgeometry", "--shell", self.window).split())
        right = int(geometry["X"]) + int(geometry["WIDTH"])
        bottom = int(geometry["Y"]) + int(geometry["HEIGHT"])
        self.morph()
        xdotool("mousemove", right - 60, bottom - 14)
        time.sleep(0.3)
        xdotool("click", 1)  # Stop serving, at the end of the status line.
        until(lambda: not self.socket.exists(), "the socket is removed")
        with self.assertRaises(vitrine.Error):
            self.morph()
        self.assertIsNone(self.program.poll(), "the window stays open")

    def test_a_window_that_closes_leaves_no_socket(self):
        self.morph()
        xdotool("windowfocus", "--sync", self.window)
        # The command names no window: it would fail where that is gone before the keys are released. They would stay
        # down, and close the window of another test.
        xdotool("key", "ctrl+q")
        self.assertEqual(self.program.wait(PATIENCE), 0)
        self.code = 0
        self.assertFalse(self.socket.exists())
        with self.assertRaises(vitrine.Error):
            self.morph()

    def test_two_windows_cannot_have_one_socket(self):
        words = [os.environ["VITRINE_PROGRAM"], "--serve", str(self.socket)]
        second = subprocess.run(words, capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(second.returncode, 2)
        self.assertIn("another server answers there", second.stderr)
        self.morph()


class DisplayTest(unittest.TestCase):
    def test_who_connects_as_the_last_client_goes_is_answered(self):
        number = os.environ["DISPLAY"].partition(":")[2].partition(".")[0]
        with socket.socket(socket.AF_UNIX) as first:
            first.settimeout(PATIENCE)
            first.connect(f"/tmp/.X11-unix/X{number}")
            time.sleep(0.2)
            xdotool("getmouselocation")  # Another client connects and goes.
            time.sleep(0.2)
            first.send(struct.pack("<BxHHHHxx", ord("l"), 11, 0, 0, 0))  # Version 11 of the protocol, without authorization.
            self.assertNotEqual(first.recv(8), b"")


if __name__ == "__main__":
    if not shutil.which("xdotool") or "DISPLAY" not in os.environ:
        print("xdotool or a display is not here")
        sys.exit(77)
    unittest.main()
