#!/usr/bin/env python3
"""Makes assets/models/teddy.glb, a bear without fur, of nine balls: python3 assets/models/teddy.py

The exhibit "fur" dresses it. Meters, Y up, facing +Z. The balls overlap; each is a node of its own that scales one mesh.
"""
import json
import math
import os
import struct

ROWS = 14
COLUMNS = 24

# Center and half axes of each ball: trunk, head, ears, snout, arms, legs.
BALLS = [
    ((0.0, 0.0, 0.0), (0.42, 0.48, 0.38)),
    ((0.0, 0.68, 0.06), (0.34, 0.31, 0.31)),
    ((-0.25, 0.93, 0.02), (0.13, 0.13, 0.08)),
    ((0.25, 0.93, 0.02), (0.13, 0.13, 0.08)),
    ((0.0, 0.60, 0.35), (0.15, 0.12, 0.12)),
    ((-0.45, 0.20, 0.10), (0.14, 0.28, 0.14)),
    ((0.45, 0.20, 0.10), (0.14, 0.28, 0.14)),
    ((-0.25, -0.42, 0.30), (0.16, 0.15, 0.30)),
    ((0.25, -0.42, 0.30), (0.16, 0.15, 0.30)),
]


def ball():
    """Corners and triangles of a ball of radius 1, with one corner at each pole."""
    corners = [(0.0, 1.0, 0.0)]
    for row in range(1, ROWS):
        theta = math.pi * row / ROWS
        for column in range(COLUMNS):
            phi = 2 * math.pi * column / COLUMNS
            corners.append((math.sin(theta) * math.cos(phi), math.cos(theta), -math.sin(theta) * math.sin(phi)))
    corners.append((0.0, -1.0, 0.0))
    at = lambda row, column: 1 + (row - 1) * COLUMNS + column % COLUMNS
    last = len(corners) - 1
    triangles = []
    for column in range(COLUMNS):
        triangles += [0, at(1, column), at(1, column + 1)]
        for row in range(1, ROWS - 1):
            a, b = at(row, column), at(row, column + 1)
            c, d = at(row + 1, column), at(row + 1, column + 1)
            triangles += [a, c, d, a, d, b]
        triangles += [at(ROWS - 1, column), last, at(ROWS - 1, column + 1)]
    return corners, triangles


def chunk(kind, data, fill):
    data += fill * (-len(data) % 4)
    return struct.pack("<I", len(data)) + kind + data


def main():
    corners, triangles = ball()
    positions = b"".join(struct.pack("<3f", *corner) for corner in corners)
    indices = struct.pack("<%dH" % len(triangles), *triangles)
    document = {
        "asset": {"version": "2.0", "generator": "assets/models/teddy.py"},
        "scene": 0,
        "scenes": [{"nodes": list(range(len(BALLS)))}],
        "nodes": [{"mesh": 0, "translation": where, "scale": axes} for where, axes in BALLS],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": len(positions) + len(indices)}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": len(positions)},
            {"buffer": 0, "byteOffset": len(positions), "byteLength": len(indices)},
        ],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(corners), "type": "VEC3", "min": [-1, -1, -1], "max": [1, 1, 1]},
            {"bufferView": 1, "componentType": 5123, "count": len(triangles), "type": "SCALAR"},
        ],
    }
    body = chunk(b"JSON", json.dumps(document, separators=(",", ":")).encode(), b" ") + chunk(b"BIN\0", positions + indices, b"\0")
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "teddy.glb"), "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body)


main()
