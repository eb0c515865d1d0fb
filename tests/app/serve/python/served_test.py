"""The Python package with the program: VITRINE_PROGRAM names it."""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy
import vitrine

try:
    import OpenImageIO
except ImportError:
    OpenImageIO = None

SCENE = pathlib.Path(vitrine.__file__).parents[4] / "assets/scenes/still_life.json"
SMALL = {"alone": True, "size": (16, 9), "samples": 1}
STUDY = {"parameters": ["hitTolerance"], "values": [0.25, 4], "alone": True, "size": (16, 9), "views": 1, "runs": 1,
         "no_model_error": True}
COMPARISON = {"size": (16, 9), "samples": 1, "runs": 1}


def outside(path, form):
    """Pixels and channel names of a file, read by OpenImageIO."""
    picture = OpenImageIO.ImageInput.open(str(path))
    names = picture.spec().channelnames
    pixels = picture.read_image(form)
    picture.close()
    return pixels, names


class ServedTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.v = vitrine.open(timeout=240)

    @classmethod
    def tearDownClass(cls):
        cls.v.close()
        cls.temporary.cleanup()

    def setUp(self):
        self.v.reset()

    def command(self, *words):
        done = subprocess.run([os.environ["VITRINE_PROGRAM"], *map(str, words)], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_every_method_of_the_list_is_called(self):
        a, b = self.folder / "every-a.png", self.folder / "every-b.png"
        for path in (a, b):
            self.v.render("noise", out=path, **SMALL)
        job = {"dry_run": True}
        calls = {
            "rpc.discover": {},
            "list": {"exhibit": "fur"},
            "get": {"exhibit": "fur"},
            "set": {"exhibit": "sdf_morph", "values": {"morph": 0.3}},
            "reset": {"exhibit": "fur"},
            "visit": {"exhibit": "fur"},
            "presets": {"exhibit": "fur"},
            "load": {"exhibit": "sdf_morph", "preset": self.v.presets("sdf_morph")[0]["preset"]},
            "plan": {"exhibit": "fur", **SMALL},
            "render": {"exhibit": "noise", **SMALL},
            "compare": {"reference": a, "test": b},
            "study": {"exhibit": "sdf_morph", **STUDY},
            "comparison": {"exhibit": "sdf_morph", "with": "mesh", **COMPARISON},
            "events": {"off": True},
            "cancel": {},
            "record": {"exhibit": "fur", "seconds": 1, "out": self.folder / "a.mp4", **job},
            "sprite": {"out": self.folder / "sprite.png", **job},
            "mesh": {"scene": SCENE, "out": self.folder / "mesh.glb", **job},
            "print": {"views": [a, b], "width_mm": 10, "height_mm": 6, "lpi": 60, "out": self.folder / "p.tif", **job},
            "quilt": {"exhibit": "fur", "columns": 2, "rows": 2, "out": self.folder / "quilt.png", **job},
            "table": {"exhibit": "pixel_art", "out": self.folder / "table.csv", **job},
            "handout": {"exhibit": "sdf_morph", "out": self.folder / "handout", **job},
            "shader": {"exhibit": "your_shader", "out": self.folder / "shader.fs", **job},
            "proof": {"print": self.print_file(), "angle": 0, "out": self.folder / "proof.png", **job},
        }
        self.assertEqual(set(self.v.methods) - set(calls), set(), "give these methods a call here")
        for name, params in calls.items():
            if name not in self.v.methods:
                continue
            with self.subTest(name):
                self.assertIsNotNone(self.v.call(name, **params))
                schema = self.v.methods[name]["params"]
                if "properties" in schema:
                    self.assertEqual(set(params) - set(schema["properties"]), set())
                    self.assertEqual(set(schema["required"]) - set(params), set())
                if name != "events":  # An iterator of the package.
                    self.assertIn(self.v.methods[name]["summary"], getattr(self.v, name).__doc__)

    def print_file(self):
        views = [self.folder / f"view-{i}.png" for i in range(2)]
        for i, view in enumerate(views):
            self.v.render("noise", out=view, time=i, **SMALL)
        out = self.folder / "print.png"
        self.report = self.v.print(views=views, out=out, width_mm=10, height_mm=6, dpi=300, lpi=60)
        return out

    def test_a_print_answers_its_facts_as_rows(self):
        out = self.print_file()
        values = {row["label"]: row["value"] for row in vitrine.table(self.report)}
        self.assertAlmostEqual(values["Pixels per lens"], 5)
        self.assertEqual(self.report["files"], [str(out), str(out) + ".json"])
        with self.assertRaisesRegex(vitrine.RequestError, "nowhere.png"):
            views = ["/nowhere.png", "/nowhere.png"]
            self.v.print(views=views, out=self.folder / "x.png", width_mm=10, height_mm=6, dpi=300, lpi=60)

    def test_the_schema_names_exactly_what_a_method_takes(self):
        for name in ("render", "plan", "study", "comparison", "record"):
            with self.assertRaises(vitrine.RequestError) as caught:
                self.v.call(name, no_such_parameter=1)
            takes = str(caught.exception).split("it takes ")[1].rstrip(".").split(", ")
            self.assertEqual(sorted(takes), sorted(self.v.methods[name]["params"]["properties"]))
        render = self.v.methods["render"]["params"]
        self.assertEqual(render["required"], ["exhibit"])
        self.assertEqual(render["properties"]["alone"]["type"], "boolean")
        self.assertEqual(render["properties"]["samples"]["x-takes"], "1..4096|auto")

    @unittest.skipUnless(OpenImageIO, "needs python3-openimageio")
    def test_arrays_are_the_values_in_the_files_of_the_command(self):
        shot = ["--alone", "--size", "16x9", "--samples", "2", "--set", "morph=0.3"]
        exr, png = self.folder / "a.exr", self.folder / "a.png"
        channels = "color,depth,normal,evaluations,albedo"
        self.command("render", "sdf_morph", *shot, "--channels", channels, "--out", exr)
        self.command("render", "sdf_morph", *shot, "--out", png)
        options = {"alone": True, "size": (16, 9), "samples": 2, "set": {"morph": 0.3}}
        linear = self.v.picture("sdf_morph", channels=channels, **options)
        pixels, names = outside(exr, "float")
        self.assertEqual(set(linear.channels), set(names))
        for i, name in enumerate(names):
            numpy.testing.assert_array_equal(linear[name], pixels[:, :, i], name)
        self.assertTrue(numpy.isfinite(linear["depth.Z"]).any())
        self.assertGreater(linear["evaluations"].max(), 1)
        display = self.v.picture("sdf_morph", display=True, **options)
        codes, _ = outside(png, "uint8")
        numpy.testing.assert_array_equal(numpy.rint(display.array * 255)[:, :, : codes.shape[2]], codes)
        self.assertGreater(codes.std(), 1)

    @unittest.skipUnless(OpenImageIO, "needs python3-openimageio")
    def test_transparent_pictures_have_unmultiplied_color(self):
        exr = self.folder / "t.exr"
        self.command("render", "sdf_morph", "--alone", "--transparent", "--size", "16x9", "--samples", "4", "--out", exr)
        picture = self.v.picture("sdf_morph", alone=True, transparent=True, size=(16, 9), samples=4)
        pixels, _ = outside(exr, "float")
        alpha = picture["A"]
        numpy.testing.assert_array_equal(alpha, pixels[:, :, 3])
        self.assertTrue(((alpha > 0) & (alpha < 1)).any())
        numpy.testing.assert_allclose(picture.rgb * alpha[:, :, None], pixels[:, :, :3], rtol=1e-6)

    def test_raw_pictures_are_refused_where_they_cannot_be(self):
        for more, words in (({"out": self.folder / "x.png"}, "either"), ({"channels": "depth"}, "display")):
            with self.subTest(more), self.assertRaisesRegex(vitrine.RequestError, words):
                self.v.picture("noise", display=True, **more)
        with self.assertRaisesRegex(vitrine.RequestError, "raw"):
            self.v.render("noise", raw="png")

    def test_the_report_has_times_counters_and_memory(self):
        self.v.picture("fur", **SMALL)  # Results that are made once and cached must not be timed: this picture fills the caches.
        report = self.v.picture("fur", frame_report=True, **SMALL).report
        self.assertTrue(report["ran"])
        self.assertTrue(all(entry["ms"] > 0 for entry in report["ran"]), report["ran"])
        self.assertTrue(any(entry["wouldCostMs"] for entry in report["skipped"]))
        self.assertGreater(report["memory"]["ownBytes"], 0)
        self.assertGreater(report["ms"]["median"], 0)
        self.assertLessEqual(report["ms"]["low"], report["ms"]["high"])
        file = self.folder / "report.json"
        self.command("render", "fur", "--alone", "--size", "16x9", "--samples", "1", "--out", self.folder / "r.png",
                     "--report", file)
        command = json.loads(file.read_text())
        self.assertEqual(set(report), set(command))
        timed = {entry["name"] for entry in command["ran"] if entry["ms"] is not None}
        self.assertEqual({entry["name"] for entry in report["ran"]} - {"copy"}, timed - {"tone", "glare", "glare/spread"})
        self.assertEqual(report["counters"]["evaluations"], command["counters"]["evaluations"])
        names = [row["name"] for row in vitrine.table({"frame_report": report})]
        self.assertEqual(names, [e["name"] for e in report["ran"] + report["skipped"]])

    def test_two_settings_differ_by_what_the_command_says(self):
        a, b = self.folder / "a.png", self.folder / "b.png"
        for path, morph in ((a, 0), (b, 1)):
            self.v.render("sdf_morph", out=path, set={"morph": morph}, **SMALL)
        rows = vitrine.table(self.v.compare(a, b))
        said = dict(line.split() for line in self.command("compare", a, b).splitlines())
        self.assertEqual({row["metric"]: row["distance"] for row in rows}, {k: float(x) for k, x in said.items()})
        same = {row["metric"]: row["distance"] for row in vitrine.table(self.v.compare(a, a))}
        self.assertEqual(same["rmse"], 0)
        self.assertIsNone(same["psnr"])

    def test_a_study_is_a_table_and_tells_its_progress(self):
        request = self.v.start("study", exhibit="sdf_morph", **STUDY)
        parts = [event.params["part"] for event in request]
        self.assertTrue(parts)
        self.assertEqual(parts, sorted(parts))
        rows = vitrine.table(request.result())
        self.assertEqual([row["hitTolerance"] for row in rows], [0.25, 4])
        self.assertGreater(rows[1]["error"], 0)
        self.assertGreater(rows[0]["cost"], 0)
        try:
            import pandas
        except ImportError:
            return
        self.assertEqual(list(pandas.DataFrame(rows)["hitTolerance"]), [0.25, 4])

    def test_a_comparison_is_of_the_present_settings(self):
        self.v.set("sdf_morph", values={"morph": 0.3})
        compared = self.v.comparison(exhibit="sdf_morph", b="initial", **COMPARISON)
        self.assertEqual([(row["name"], row["a"]) for row in compared["rows"]], [("morph", 0.3)])
        self.assertGreater(compared["errors"]["flip"], 0)
        self.assertEqual(compared["ms"]["b"]["runs"], 1)
        offered = self.v.comparison(exhibit="sdf_morph", with_="mesh", **COMPARISON)
        self.assertEqual([row["name"] for row in offered["rows"]], ["shownAs"])
        with self.assertRaisesRegex(vitrine.RequestError, "second setting"):
            self.v.comparison(exhibit="sdf_morph", **COMPARISON)

    def test_a_recording_answers_its_facts(self):
        out = self.folder / "out.apng"
        rows = vitrine.table(self.v.record("sdf_morph", out=out, fps=2, seconds=1, **SMALL))
        self.assertIn({"label": "Frames", "value": 2, "unit": ""}, rows)
        self.assertEqual(out.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_a_canceled_request_raises(self):
        request = self.v.start("study", exhibit="sdf_morph", **{**STUDY, "runs": 50})
        request.cancel()
        with self.assertRaises(vitrine.Canceled):
            request.result()
        self.assertTrue(self.v.list("fur"))

    def test_changes_of_others_are_events(self):
        seen = []

        def listen():
            for event in self.v.events(timeout=60):
                if event.kind == "changed":
                    seen.append(event.params)
                    return

        listener = threading.Thread(target=listen)
        listener.start()
        end = time.monotonic() + 60
        while listener.is_alive() and time.monotonic() < end:
            self.v.set("sdf_morph", values={"morph": 0.3 + 0.1 * (time.monotonic() % 1)})
            time.sleep(0.05)
        listener.join()
        self.assertIn("morph", seen[0]["values"])

    def test_an_error_has_the_message_of_the_service(self):
        with self.assertRaisesRegex(vitrine.RequestError, "furr.*fur") as caught:
            self.v.render("furr")
        self.assertEqual(caught.exception.code, -32602)
        with self.assertRaises(vitrine.RequestError) as caught:
            self.v.render("fur", out="/nowhere/x.png", **SMALL)
        self.assertEqual(caught.exception.data["exitCode"], 5)


class ProcessTest(unittest.TestCase):
    def gone(self, path, seconds=30):
        end = time.monotonic() + seconds
        while os.path.exists(path) and time.monotonic() < end:
            time.sleep(0.1)
        return not os.path.exists(path)

    def test_death_of_the_program_raises_and_does_not_hang(self):
        with vitrine.open(timeout=240) as v:
            request = v.start("study", exhibit="sdf_morph", **{**STUDY, "runs": 1000, "size": (64, 36)})
            next(iter(request))
            v._own.process.send_signal(signal.SIGKILL)
            with self.assertRaisesRegex(vitrine.ConnectionLost, "signal 9"):
                request.result()
            with self.assertRaises(vitrine.ConnectionLost):
                v.list()

    def test_the_program_ends_with_the_session(self):
        v = vitrine.open(timeout=240)
        process, path = v._own.process, v._path
        v.close()
        self.assertIsNotNone(process.returncode)
        self.assertFalse(os.path.exists(path))

    def test_the_program_ends_when_python_is_killed(self):
        script = "import time, vitrine; v = vitrine.open(); print(v._path, flush=True); time.sleep(600)"
        with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True) as python:
            path = python.stdout.readline().strip()
            self.assertTrue(os.path.exists(path))
            python.kill()
        self.assertTrue(self.gone(path), "the program still listens")
        shutil.rmtree(os.path.dirname(path))


if __name__ == "__main__":
    unittest.main()
