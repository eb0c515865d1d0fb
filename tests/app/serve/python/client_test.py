"""The Python package against a service that misbehaves. Needs no built program."""

import inspect
import pathlib
import re
import struct
import unittest

import fake_service
import numpy
import vitrine
from fake_service import FakeService, line, result


def picture_answer(request, numbers, count=None, shape=(1, 2, 2), channels=("R", "depth.Z")):
    data = struct.pack(f"<{len(numbers)}f", *numbers)
    binary = {"bytes": len(data) if count is None else count, "type": "float32", "shape": shape, "channels": channels}
    return result(request, {"binary": binary, "notes": []}) + data


class ClientTest(unittest.TestCase):
    def ask(self, answer, **params):
        """What a call of `render` gives if the service answers so."""
        with FakeService(answer) as service, vitrine.Session(socket=service.path, timeout=20) as v:
            return v.render("fur", **params)

    def test_numbers_of_a_picture_arrive_in_order(self):
        picture = self.ask(lambda request: picture_answer(request, [0.5, 7, -0.25, float("inf")]))
        numpy.testing.assert_array_equal(picture.array, numpy.array([[[0.5, 7], [-0.25, numpy.inf]]], "float32"))
        numpy.testing.assert_array_equal(picture["depth.Z"], [[7, numpy.inf]])
        numpy.testing.assert_array_equal(numpy.asarray(picture), picture.array)
        self.assertEqual(picture.array.dtype, numpy.float32)
        self.assertTrue(picture.array.flags.writeable)
        with self.assertRaisesRegex(KeyError, "normal.X.*depth.Z"):
            picture["normal.X"]

    def test_bytes_that_look_like_lines_are_no_lines(self):
        newlines = struct.unpack("<f", b"\n{}\n")[0]
        with FakeService(lambda request: picture_answer(request, [newlines] * 4)) as service:
            with vitrine.Session(socket=service.path, timeout=20) as v:
                for _ in range(3):
                    self.assertEqual(v.render("fur").array.tobytes(), b"\n{}\n" * 4)

    def test_truncated_bytes_raise(self):
        said = []

        def answer(request):
            if said:
                return None
            said.append(True)
            return picture_answer(request, [1, 2, 3], count=16)

        with FakeService(answer) as service, vitrine.Session(socket=service.path, timeout=20) as v:
            request = v._request("render", {"exhibit": "fur"}, False)
            v._connection.send("render", {}, 99)  # The service closes the connection.
            with self.assertRaisesRegex(vitrine.ConnectionLost, "within the bytes of an answer"):
                request.result()

    def test_a_truncated_line_raises(self):
        said = []

        def answer(request):
            said.append(True)
            return b'{"jsonrpc": ' if len(said) == 1 else None

        with FakeService(answer) as service, vitrine.Session(socket=service.path, timeout=20) as v:
            request = v._request("render", {"exhibit": "fur"}, False)
            v._connection.send("render", {}, 99)
            with self.assertRaisesRegex(vitrine.ConnectionLost, "within a line"):
                request.result()

    def test_a_picture_that_is_not_what_it_says_raises(self):
        for wrong in ({"shape": (1, 2, 3)}, {"shape": (2, 2)}, {"shape": (1, 1, 2)}, {"channels": ("R",)}):
            with self.subTest(wrong), self.assertRaisesRegex(vitrine.ConnectionLost, "not what it says"):
                self.ask(lambda request: picture_answer(request, [1, 2, 3, 4], **wrong))

    def test_absurd_sizes_are_refused_before_they_are_read(self):
        for count in (-1, 1 << 40, "16", 1.5):
            with self.subTest(count), self.assertRaisesRegex(vitrine.ConnectionLost, "announced"):
                self.ask(lambda request: picture_answer(request, [], count=count))

    def test_what_is_no_message_raises(self):
        for text in (b"hello\n", b"[]\n", b"\xff\xfe\n"):
            with self.subTest(text), self.assertRaises(vitrine.ConnectionLost):
                self.ask(lambda _: text)

    def test_a_closed_connection_raises(self):
        with self.assertRaisesRegex(vitrine.ConnectionLost, "closed the connection"):
            self.ask(lambda _: None)

    def test_a_refusal_raises_with_its_message_code_and_data(self):
        error = {"code": -32005, "message": "Cannot write x.", "data": {"kind": "file", "exitCode": 5}}
        with self.assertRaises(vitrine.RequestError) as caught:
            self.ask(lambda request: line({"id": request["id"], "error": error}))
        self.assertEqual(str(caught.exception), "Cannot write x.")
        self.assertEqual((caught.exception.code, caught.exception.data["exitCode"]), (-32005, 5))

    def test_a_dropped_connection_raises_its_reason(self):
        error = {"code": -32011, "message": "There are 16 connections already."}
        with self.assertRaisesRegex(vitrine.ConnectionLost, "16 connections"):
            self.ask(lambda _: line({"id": None, "error": error}))

    def test_answers_of_earlier_calls_and_events_are_passed_over(self):
        def answer(request):
            event = line({"method": "changed", "params": {"exhibit": "fur"}})
            late = result({"id": 777}, {"late": True})
            return event + late + result(request, {"notes": []})

        self.assertEqual(self.ask(answer), {"notes": []})

    def test_events_of_a_request_come_before_its_result(self):
        def answer(request):
            if request["method"] != "render":
                return b""
            told = b""
            for id, part in ((request["id"], 0.25), (None, 0.5), (request["id"], 0.75)):
                told += line({"method": "progress", "params": {"id": id, "part": part}})
            return told + result(request, {"done": True})

        with FakeService(answer) as service, vitrine.Session(socket=service.path, timeout=20) as v:
            request = v.start("render", exhibit="fur")
            self.assertEqual([event.params["part"] for event in request], [0.25, 0.75])
            self.assertEqual(request.result(), {"done": True})
            v.render("fur")
            sent = [(each["method"], each["params"]) for each in service.requests]
        fur = ("render", {"exhibit": "fur"})
        self.assertEqual(sent, [("events", {}), fur, ("events", {"off": True}), fur])

    def test_methods_have_the_signature_and_help_of_the_service(self):
        with FakeService(lambda request: result(request, request["params"])) as service:
            with vitrine.Session(socket=service.path, timeout=20) as v:
                signature = inspect.signature(v.render)
                self.assertEqual(list(signature.parameters), ["exhibit", "alone"])
                self.assertIs(signature.parameters["alone"].annotation, bool)
                self.assertIn("exhibit: A name (TEXT)", v.render.__doc__)
                self.assertIn("render", dir(v))
                sent = v.render("fur", alone=True, size=(4, 2), values=numpy.float32([0.5]), out=None)
                self.assertEqual(sent, {"exhibit": "fur", "alone": True, "size": [4, 2], "values": [0.5]})
                with self.assertRaises(TypeError):
                    v.render("fur", True)
                with self.assertRaises(TypeError):
                    v.render("fur", exhibit="noise")
                with self.assertRaisesRegex(AttributeError, "rendr.*render"):
                    v.rendr
                with self.assertRaises(TypeError):
                    v.render("fur", alone=object())

    def test_silence_ends_with_the_timeout_and_loses_nothing(self):
        held = []

        def answer(request):
            held.append(request)
            return b"" if len(held) == 1 else result(held[0], {"first": True}) + result(request, {"second": True})

        with FakeService(answer) as service, vitrine.Session(socket=service.path, timeout=0.2) as v:
            with self.assertRaises(TimeoutError):
                v.render("fur")
            self.assertEqual(v.render("fur"), {"second": True})

    def test_a_closed_session_says_so(self):
        with FakeService(lambda request: result(request, {})) as service:
            v = vitrine.Session(socket=service.path, timeout=20)
            v.close()
            v.close()
            with self.assertRaisesRegex(vitrine.ConnectionLost, "closed"):
                v.render("fur")

    def test_no_service_and_no_program_are_errors(self):
        with self.assertRaisesRegex(vitrine.ConnectionLost, "/nowhere/socket"):
            vitrine.Session(socket="/nowhere/socket")
        with self.assertRaisesRegex(vitrine.Error, "/nowhere/vitrine"):
            vitrine.open(program="/nowhere/vitrine")
        with self.assertRaisesRegex(vitrine.Error, "exit code 1"):
            vitrine.open(program="/bin/false")


class CommandTest(unittest.TestCase):
    def test_options_become_words(self):
        with FakeService(lambda request: result(request, {})) as service:
            with vitrine.Session(socket=service.path, program="/bin/echo", timeout=20) as v:
                options = {"views": ["a b", "c"], "size": (4, 2), "eye": [1, 0.5, 2], "set": {"morph": 0.3}}
                said = v.command("print", **options, alone=True, sixteen_bit=False, out=None)
                self.assertEqual(said, "print --views a b c --size 4x2 --eye 1,0.5,2 --set morph=0.3 --alone\n")
            with vitrine.Session(socket=service.path, program="/bin/false", timeout=20) as v:
                with self.assertRaises(vitrine.RequestError) as caught:
                    v.command("print")
                self.assertEqual(caught.exception.data, {"exitCode": 1})


class VersionTest(unittest.TestCase):
    def test_the_package_has_the_version_of_the_program(self):
        package = pathlib.Path(vitrine.__file__).parents[1]
        said = re.search(r'^version = "(.*)"$', (package / "pyproject.toml").read_text(), re.M)[1]
        self.assertRegex((package.parents[2] / "CMakeLists.txt").read_text(), rf"project\(\S+ VERSION {re.escape(said)}\b")


class TableTest(unittest.TestCase):
    def test_answers_become_rows(self):
        self.assertEqual(
            vitrine.table({"distances": {"rmse": 0.5, "psnr": None}, "notes": []}),
            [{"metric": "rmse", "distance": 0.5}, {"metric": "psnr", "distance": None}],
        )
        facts = [{"label": "Frames", "value": 12}, {"label": "Size", "value": 2.5, "unit": "MB"}]
        self.assertEqual(
            vitrine.table({"files": [], "facts": facts}),
            [{"label": "Frames", "value": 12, "unit": ""}, {"label": "Size", "value": 2.5, "unit": "MB"}],
        )
        fact = {"label": "Pixels per lens", "value": 4.5}
        self.assertEqual(vitrine.table({"facts": [fact], "notes": []}), [{**fact, "unit": ""}])
        with self.assertRaisesRegex(ValueError, "no rows"):
            vitrine.table({"values": {}})


if __name__ == "__main__":
    unittest.main()
