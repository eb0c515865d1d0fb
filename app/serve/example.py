#!/usr/bin/env python3
"""example.py SOCKET FOLDER: three pictures of a mug that melts, and what the accuracy of its surface costs."""
import base64, json, pathlib, socket, sys

stream = socket.socket(socket.AF_UNIX)
stream.connect(sys.argv[1])  # Socket on which `vitrine serve --socket SOCKET` listens.
lines = stream.makefile("rw", encoding="utf-8", newline="\n")
folder = pathlib.Path(sys.argv[2])


def call(method, **params):
    """The result of a method; events that come before it are shown."""
    print(json.dumps({"jsonrpc": "2.0", "id": 1, "method": method, "params": params}), file=lines, flush=True)
    for answer in map(json.loads, lines):
        if "result" in answer:
            return answer["result"]
        if "error" in answer:
            sys.exit(answer["error"]["message"])
        print(answer["method"], answer["params"])


for morph in (0, 0.5, 1):
    call("set", exhibit="sdf_morph", values={"morph": morph})
    picture = call("render", exhibit="sdf_morph", alone=True, size=[32, 18], samples=1)
    (folder / f"mug-{morph}.png").write_bytes(base64.b64decode(picture["png"]))
call("events")  # From here on, progress is told.
study = call("study", exhibit="sdf_morph", parameters=["hitTolerance"], values=[0.25, 1, 4], alone=True,
             size=[32, 18], views=1, runs=1, no_model_error=True)
for point in study["points"]:
    print(point["values"], "error", point["error"], study["cost"], point["cost"])
