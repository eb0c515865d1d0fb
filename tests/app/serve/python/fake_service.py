"""A service that says what a test lets it say, on a Unix socket."""

import json
import os
import socket
import tempfile
import threading

DISCOVERED = {
    "app": "test",
    "methods": [
        {
            "name": "render",
            "summary": "A picture",
            "params": {
                "properties": {
                    "exhibit": {"description": "A name", "type": ["string", "number", "array"], "x-takes": "TEXT"},
                    "alone": {"description": "By itself", "type": "boolean"},
                },
                "required": ["exhibit"],
                "x-positional": ["exhibit"],
            },
        }
    ],
}


class FakeService:
    """Answers each request with `answer(request)`: bytes, or None to close the connection."""

    def __init__(self, answer):
        self._folder = tempfile.TemporaryDirectory()
        self.path = os.path.join(self._folder.name, "socket")
        self.requests = []
        self._answer = answer
        self._listening = socket.socket(socket.AF_UNIX)
        self._listening.bind(self.path)
        self._listening.listen()
        self._thread = threading.Thread(target=self._serve, daemon=True)
        self._thread.start()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._listening.shutdown(socket.SHUT_RDWR)
        self._listening.close()
        self._thread.join(10)
        self._folder.cleanup()

    def _serve(self):
        while True:
            try:
                connection, _ = self._listening.accept()
            except OSError:
                return
            with connection, connection.makefile("rb") as lines:
                for line in lines:
                    request = json.loads(line)
                    if request["method"] == "rpc.discover":
                        connection.sendall(result(request, DISCOVERED))
                        continue
                    self.requests.append(request)
                    said = self._answer(request)
                    if said is None:
                        break
                    connection.sendall(said)


def line(message):
    return json.dumps({"jsonrpc": "2.0", **message}).encode() + b"\n"


def result(request, value):
    return line({"id": request.get("id"), "result": value})
