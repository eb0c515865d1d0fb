# SPDX-License-Identifier: GPL-3.0-or-later
"""The hall's triangles out of hall.glb, rays through them (Embree 3), and what lies under each texel of its atlas."""
import ctypes
import json
import struct

import numpy as np
from hall_materials import MATERIALS

_TYPES = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
_NONE = 0xFFFFFFFF
# RTCRayHit of embree3/rtcore_ray.h.
_RAY = np.dtype({"names": ["org", "near", "dir", "time", "far", "mask", "id", "flags", "normal", "uv", "prim", "geom",
                           "inst"],
                 "formats": ["3f4", "f4", "3f4", "f4", "f4", "u4", "u4", "u4", "3f4", "2f4", "u4", "u4", "u4"],
                 "offsets": [0, 12, 16, 28, 32, 36, 40, 44, 48, 60, 68, 72, 76], "itemsize": 80})


class Triangles:
    """Of the meshes hall_*: corners (n, 3, 3) in meters, their normals, atlas coordinates (n, 3, 2) with row 0 at 0,
    face normals (n, 3), and diffuse albedo (n, 3), as hall_bake has it."""

    def __init__(self, path):
        with open(path, "rb") as f:
            data = f.read()
        length = struct.unpack_from("<I", data, 12)[0]
        self._gltf = json.loads(data[20:20 + length])
        self._bytes = data[28 + length:]
        corners, normals, atlas, albedo, kind = [], [], [], [], []
        for node in self._gltf["nodes"]:
            if "mesh" not in node or not node["name"].startswith("hall_"):
                continue
            if any(k in node for k in ("matrix", "rotation", "translation", "scale")):
                raise RuntimeError(node["name"] + " is not where its vertices are")
            for part in self._gltf["meshes"][node["mesh"]]["primitives"]:
                index = self._read(part["indices"]).reshape(-1, 3).astype(np.int64)
                name = self._gltf["materials"][part["material"]]["name"]
                spec = MATERIALS[name]
                a = part["attributes"]
                corners.append(self._read(a["POSITION"])[index])
                normals.append(self._read(a["NORMAL"])[index])
                atlas.append(self._read(a["TEXCOORD_1"])[index])
                color = np.array(spec["color"]) * (0.6 if spec["metalness"] > 0.5 else 1.0)
                albedo.append(np.broadcast_to(color, (len(index), 3)))
                kind.append(np.full(len(index), list(MATERIALS).index(name)))
        self.corners, self.normals, self.atlas, self.albedo, self.kind = (
            np.concatenate(x) for x in (corners, normals, atlas, albedo, kind))
        across = np.cross(self.corners[:, 1] - self.corners[:, 0], self.corners[:, 2] - self.corners[:, 0])
        self.area = np.linalg.norm(across, axis=1) / 2
        self.facing = across / np.maximum(2 * self.area, 1e-12)[:, None]

    def _read(self, number):
        accessor = self._gltf["accessors"][number]
        view = self._gltf["bufferViews"][accessor["bufferView"]]
        width, kind = _WIDTHS[accessor["type"]], _TYPES[accessor["componentType"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        if view.get("byteStride", 0) not in (0, width * np.dtype(kind).itemsize):
            raise RuntimeError("interleaved buffers are not read here")
        out = np.frombuffer(self._bytes, kind, accessor["count"] * width, start)
        return out.reshape(-1, width) if width > 1 else out


class Rays:
    """First hits in a set of triangles."""

    def __init__(self, triangles):
        self._lib = lib = ctypes.CDLL("libembree3.so.3")
        pointer, size = ctypes.c_void_p, ctypes.c_size_t
        for name, result, arguments in (
                ("rtcNewDevice", pointer, [ctypes.c_char_p]), ("rtcNewScene", pointer, [pointer]),
                ("rtcNewGeometry", pointer, [pointer, ctypes.c_int]),
                ("rtcSetNewGeometryBuffer", pointer, [pointer, ctypes.c_int, ctypes.c_uint, ctypes.c_int, size, size]),
                ("rtcCommitGeometry", None, [pointer]), ("rtcAttachGeometry", ctypes.c_uint, [pointer, pointer]),
                ("rtcCommitScene", None, [pointer]),
                ("rtcIntersect1M", None, [pointer, pointer, pointer, ctypes.c_uint, size])):
            function = getattr(lib, name)
            function.restype, function.argtypes = result, arguments
        device = lib.rtcNewDevice(None)
        self._scene = lib.rtcNewScene(device)
        shape = lib.rtcNewGeometry(device, 0)
        n = len(triangles.corners)
        for kind, form, values in ((1, 0x9003, triangles.corners.reshape(-1, 3).astype(np.float32)),
                                   (0, 0x5003, np.arange(3 * n, dtype=np.uint32).reshape(-1, 3))):
            where = lib.rtcSetNewGeometryBuffer(shape, kind, 0, form, 12, len(values))
            values = np.ascontiguousarray(values)
            ctypes.memmove(where, values.ctypes.data, values.nbytes)
        lib.rtcCommitGeometry(shape)
        lib.rtcAttachGeometry(self._scene, shape)
        lib.rtcCommitScene(self._scene)
        self._triangles = triangles

    def cast(self, origins, directions):
        """(triangle or -1, atlas coordinates (n, 2), whether its front was hit) of rays (n, 3)."""
        ray = np.zeros(len(origins), _RAY)
        ray["org"], ray["dir"] = origins, directions
        ray["far"], ray["mask"], ray["prim"], ray["geom"], ray["inst"] = 1e9, _NONE, _NONE, _NONE, _NONE
        context = np.zeros(16, np.uint32)
        context[4] = _NONE
        self._lib.rtcIntersect1M(self._scene, context.ctypes.data, ray.ctypes.data, len(ray), 80)
        hit = ray["geom"] != _NONE
        prim = np.where(hit, ray["prim"], 0).astype(np.int64)
        u, v = ray["uv"][:, :1], ray["uv"][:, 1:]
        at = self._triangles.atlas[prim]
        coordinates = at[:, 0] * (1 - u - v) + at[:, 1] * u + at[:, 2] * v
        front = hit & ((self._triangles.facing[prim] * directions).sum(axis=1) < 0)
        return np.where(hit, prim, -1), coordinates, front


class Atlas:
    """The texels of an atlas of size x size whose middle lies on a triangle: row, column, triangle, place and normal
    (world space), the way off the surface, and the area (square meters) that each stands for."""

    def __init__(self, triangles, size):
        self.size = size
        rows, columns, owner, weights = [], [], [], []
        for k, uv in enumerate(triangles.atlas * size - 0.5):
            low = np.maximum(np.ceil(uv.min(axis=0) - 1e-3), 0).astype(int)
            high = np.minimum(np.floor(uv.max(axis=0) + 1e-3), size - 1).astype(int)
            if (low > high).any():
                continue
            x, y = np.meshgrid(np.arange(low[0], high[0] + 1), np.arange(low[1], high[1] + 1))
            x, y = x.ravel(), y.ravel()
            (a, b, c) = uv
            whole = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
            if abs(whole) < 1e-12:
                continue
            s = ((x - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (y - a[1])) / whole
            t = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / whole
            inside = (s > -1e-3) & (t > -1e-3) & (s + t < 1 + 1e-3)
            rows.append(y[inside])
            columns.append(x[inside])
            owner.append(np.full(inside.sum(), k))
            weights.append(np.stack((1 - s - t, s, t), axis=1)[inside])
        rows, columns, owner, weights = (np.concatenate(x) for x in (rows, columns, owner, weights))
        _, first = np.unique(rows * size + columns, return_index=True)
        self.row, self.column, self.triangle, weights = rows[first], columns[first], owner[first], weights[first]
        corners, normals = triangles.corners[self.triangle], triangles.normals[self.triangle]
        self.place = (corners * weights[..., None]).sum(axis=1)
        normal = (normals * weights[..., None]).sum(axis=1)
        self.normal = normal / np.linalg.norm(normal, axis=1)[:, None]
        self.away = triangles.facing[self.triangle]
        self.albedo, self.kind = triangles.albedo[self.triangle], triangles.kind[self.triangle]
        uv = triangles.atlas
        flat = np.abs((uv[:, 1, 0] - uv[:, 0, 0]) * (uv[:, 2, 1] - uv[:, 0, 1])
                      - (uv[:, 2, 0] - uv[:, 0, 0]) * (uv[:, 1, 1] - uv[:, 0, 1])) / 2
        self.area = (triangles.area / np.maximum(flat, 1e-12))[self.triangle] / size ** 2

    def drop_buried(self, rays, rng, count=24):
        """Leaves out texels inside other solids, from which rays meet backs."""
        keep = []
        for first in range(0, len(self.row), 40000):
            some = slice(first, first + 40000)
            ways = around(self.normal[some], count, rng).reshape(-1, 3)
            start = np.repeat(self.place[some] + 2e-3 * self.away[some], count, axis=0)
            triangle, _, front = rays.cast(start, ways)
            keep.append(((triangle >= 0) & ~front).reshape(-1, count).mean(axis=1) < 0.25)
        keep = np.concatenate(keep)
        for name in ("row", "column", "triangle", "place", "normal", "away", "albedo", "kind", "area"):
            setattr(self, name, getattr(self, name)[keep])

    def image(self, values, empty=0):
        """(size, size, ...) with the values of the texels, `empty` elsewhere."""
        out = np.full((self.size, self.size) + values.shape[1:], empty, values.dtype)
        out[self.row, self.column] = values
        return out

    def number_image(self, numbers, rounds=2):
        """The same of numbers from 0, spread into what is empty beside them, -1 elsewhere."""
        out = self.image(numbers, -1)
        for _ in range(rounds):
            empty = out < 0
            for axis, step in ((0, 1), (0, -1), (1, 1), (1, -1)):
                near = np.roll(out, step, axis)
                take = empty & (out < 0) & (near >= 0)
                spread = np.where(take, near, out)
                out = spread
        return out


def around(normal, count, rng):
    """`count` unit vectors for each normal, as its cosine has it: (n, count, 3)."""
    n = len(normal)
    k = np.arange(count)
    u = (k + rng.random((n, 1))) / count
    turn = 2 * np.pi * ((k * 0.618033988749895 + rng.random((n, 1))) % 1)
    across = np.sqrt(u)
    up = np.where(np.abs(normal[:, :1]) > 0.9, [[0.0, 1.0, 0.0]], [[1.0, 0.0, 0.0]])
    t = np.cross(normal, up)
    t /= np.linalg.norm(t, axis=1)[:, None]
    b = np.cross(normal, t)
    return (t[:, None] * (across * np.cos(turn))[..., None] + b[:, None] * (across * np.sin(turn))[..., None]
            + normal[:, None] * np.sqrt(1 - u)[..., None])


def over_sphere(count):
    """Unit vectors spread evenly over the sphere."""
    k = np.arange(count) + 0.5
    y, turn = 1 - 2 * k / count, 2.399963229728653 * k
    r = np.sqrt(1 - y * y)
    return np.stack((r * np.cos(turn), y, r * np.sin(turn)), axis=1)
