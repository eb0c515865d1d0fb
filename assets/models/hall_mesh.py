# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh accumulator and primitives in hall coordinates (meters, Y up, right-handed).

Every face carries a material, a metric texture coordinate (1 unit = 1 m) and a place on a
lightmap chart, also in meters; hall_atlas.py packs the charts.
"""
import math

import bmesh
import numpy as np
from mathutils import Matrix, Vector
from mathutils.geometry import delaunay_2d_cdt

AXIS = {"x": 0, "y": 1, "z": 2}


class Mesh:
    def __init__(self):
        self.verts = []   # (x, y, z)
        self.faces = []   # (indices, material, uv0 list, chart, uv1 list)
        self.charts = []  # texel density factor of each chart

    def chart(self, density):
        self.charts.append(density)
        return len(self.charts) - 1

    def face(self, idx, mat, uv0, chart, uv1):
        keep = [k for k in range(len(idx)) if idx[k] not in idx[:k]]
        if len(keep) > 2:
            self.faces.append(([idx[k] for k in keep], mat, [uv0[k] for k in keep], chart,
                               [uv1[k] for k in keep]))

    def add(self, points):
        start = len(self.verts)
        self.verts.extend(tuple(float(c) for c in p) for p in points)
        return start


def fillet(points, segments=2, closed=False):
    """2-D polyline of (x, y[, radius]) with its corners rounded."""
    out = []
    n = len(points)
    for k, p in enumerate(points):
        r = p[2] if len(p) > 2 else 0.0
        here = np.array(p[:2], float)
        if r <= 0 or (not closed and k in (0, n - 1)):
            out.append(tuple(here))
            continue
        a = np.array(points[k - 1][:2], float) - here
        b = np.array(points[(k + 1) % n][:2], float) - here
        la, lb = np.linalg.norm(a), np.linalg.norm(b)
        a, b = a / la, b / lb
        half = math.acos(max(-1, min(1, float(a @ b)))) / 2
        d = min(r / math.tan(half), la * 0.499, lb * 0.499)
        for s in range(segments + 1):
            t = s / segments
            q0, q1 = here + a * d * (1 - t), here + b * d * t
            out.append(tuple(q0 * (1 - t) + q1 * t))
    return out


def grid(m, pts, mats, close_i=False, density=1.0, flip=False, swap=False, max_len=13.0,
         uv_shift=(0.0, 0.0)):
    """Quads over pts[i][j]; i runs along the path, j across; normal = d_i x d_j."""
    pts = np.asarray(pts, float)
    ni, nj = pts.shape[:2]
    base = np.zeros((ni, nj), int)
    for i in range(ni):
        for j in range(nj):
            if j and np.linalg.norm(pts[i, j] - pts[i, j - 1]) < 1e-7:
                base[i, j] = base[i, j - 1]
            elif i and np.linalg.norm(pts[i, j] - pts[i - 1, j]) < 1e-7:
                base[i, j] = base[i - 1, j]
            else:
                base[i, j] = m.add([pts[i, j]])
    rows = ni if close_i else ni - 1
    nxt = lambda i: (i + 1) % ni
    du = [float(np.mean([np.linalg.norm(pts[nxt(i), j] - pts[i, j]) for j in range(nj)]))
          for i in range(rows)]
    dv = [float(np.mean(np.linalg.norm(pts[:, j + 1] - pts[:, j], axis=1))) for j in range(nj - 1)]
    u = np.concatenate([[0], np.cumsum(du)])
    v = np.concatenate([[0], np.cumsum(dv)])
    chart, start = m.chart(density), 0.0
    for i in range(rows):
        if u[i + 1] - start > max_len and u[i] > start:
            chart, start = m.chart(density), u[i]
        for j in range(nj - 1):
            idx = [base[i, j], base[nxt(i), j], base[nxt(i), j + 1], base[i, j + 1]]
            uv = [(u[i], v[j]), (u[i + 1], v[j]), (u[i + 1], v[j + 1]), (u[i], v[j + 1])]
            uv0 = [((b, a) if swap else (a, b)) for a, b in uv]
            uv0 = [(a + uv_shift[0], b + uv_shift[1]) for a, b in uv0]
            if flip:
                idx, uv, uv0 = idx[::-1], uv[::-1], uv0[::-1]
            m.face(idx, mats if isinstance(mats, str) else mats[j], uv0, chart, uv)


def sweep(m, path, profile, to3, mats, closed=False, **kw):
    """Profile (offset to the left of the path, height) along a 2-D path with mitred corners."""
    path = np.asarray(path, float)
    n = len(path)
    rows = []
    for k in range(n):
        dirs = []
        if closed or k > 0:
            dirs.append(path[k] - path[k - 1])
        if closed or k < n - 1:
            dirs.append(path[(k + 1) % n] - path[k])
        nrm = [np.array([-d[1], d[0]]) / np.linalg.norm(d) for d in dirs]
        mit = nrm[0] if len(nrm) == 1 else (nrm[0] + nrm[1]) / max(0.2, 1 + float(nrm[0] @ nrm[1]))
        rows.append([to3(path[k][0] + mit[0] * o, path[k][1] + mit[1] * o, h) for o, h in profile])
    grid(m, rows, mats, close_i=closed, **kw)


def plan(x, z, y):
    """sweep() mapping for paths in the ground plane; inside is to the left."""
    return (x, y, z)


def lathe(m, profile, mats, center=(0, 0, 0), segments=24, matrix=None, **kw):
    """(radius, height) profile turned round +y; bottom to top gives outward normals."""
    rows = []
    for k in range(segments + 1):
        a = -2 * math.pi * k / segments
        rows.append([(r * math.cos(a), h, r * math.sin(a)) for r, h in profile])
    rows = np.array(rows)
    rows[-1] = rows[0]
    if matrix is not None:
        rows = np.array([[matrix @ Vector(p) for p in row] for row in rows])
    rows = rows + np.array(center, float)
    before = len(m.verts)
    grid(m, rows, mats, **kw)
    weld_tail(m, before)


def weld_tail(m, start):
    """Make coincident vertices of the newest part one, so that shading is smooth over the seam."""
    first = {}
    remap = {}
    for k in range(start, len(m.verts)):
        key = tuple(round(c, 6) for c in m.verts[k])
        remap[k] = first.setdefault(key, k)
    for f, face in enumerate(m.faces):
        if max(face[0]) >= start:
            m.faces[f] = ([remap.get(i, i) for i in face[0]],) + face[1:]


def planar(m, loops, to3, classify, density=1.0, flip=False, points=(), swap=False, chart=None,
           unfold=lambda a, b: (a, b)):
    """Triangulated flat region: loops are constraints, classify(a, b) gives a material or None."""
    coords, edges = [], []
    for loop in loops:
        s = len(coords)
        coords += [Vector(p[:2]) for p in loop]
        edges += [(s + k, s + (k + 1) % len(loop)) for k in range(len(loop))]
    coords += [Vector(p) for p in points]
    v, _, tris, *_ = delaunay_2d_cdt(coords, edges, [], 0, 1e-5)
    base = m.add([to3(p.x, p.y) for p in v])
    chart = m.chart(density) if chart is None else chart
    for t in tris:
        c = sum((v[i] for i in t), Vector((0, 0))) / len(t)
        mat = classify(c.x, c.y)
        if mat is None:
            continue
        t = list(t)[::-1] if flip else list(t)
        uv = [(v[i].x, v[i].y) for i in t]
        m.face([base + i for i in t], mat, [(b, a) for a, b in uv] if swap else uv, chart,
               [unfold(a, b) for a, b in uv])
    return chart


def solid(m, bm, mat, matrix=None, density=1.0, grain="y", shift=(0.0, 0.0), skip=()):
    """Take a bmesh over; charts by dominant axis. skip: sides left out, such as "-y"."""
    bm.normal_update()
    bm.faces.ensure_lookup_table()
    matrix = matrix or Matrix()
    base = m.add([matrix @ v.co for v in bm.verts])
    bm.verts.index_update()
    kind = {}
    for f in bm.faces:
        a = max(range(3), key=lambda k: abs(f.normal[k]) + 1e-4 * k)
        kind[f] = (a, f.normal[a] > 0)
    drop = {(AXIS[s[1]], s[0] == "+") for s in skip}
    seen = set()
    for seed in bm.faces:
        if seed in seen:
            continue
        chart, stack = m.chart(density), [seed]
        seen.add(seed)
        while stack:
            f = stack.pop()
            for e in f.edges:
                for g in e.link_faces:
                    if g not in seen and kind[g] == kind[seed]:
                        seen.add(g)
                        stack.append(g)
            axis = kind[f]
            if axis in drop and f.normal[axis[0]] * (1 if axis[1] else -1) > 0.99:
                continue
            other = [k for k in (0, 2, 1) if k != axis[0]]      # u, v
            if AXIS[grain] == other[0]:
                other = other[::-1]
            uv = [(l.vert.co[other[0]], l.vert.co[other[1]]) for l in f.loops]
            m.face([base + l.vert.index for l in f.loops], mat,
                   [(a + shift[0], b + shift[1]) for a, b in uv], chart, uv)
    bm.free()


def box(m, lo, hi, mat, bevel=0.01, segments=2, matrix=None, **kw):
    """Box from corner to corner with rounded edges."""
    bm = bmesh.new()
    bmesh.ops.create_cube(bm, size=1)
    lo, hi = Vector(lo), Vector(hi)
    for v in bm.verts:
        v.co = Vector((lo[k] + (hi[k] - lo[k]) * (v.co[k] + 0.5) for k in range(3)))
    _bevel(bm, bevel, segments)
    solid(m, bm, mat, matrix, **kw)


def prism(m, outline, x0, x1, mat, bevel=0.01, segments=2, matrix=None, **kw):
    """Outline in (z, y) extruded along x."""
    bm = bmesh.new()
    a = [bm.verts.new((x0, y, z)) for z, y in outline]
    b = [bm.verts.new((x1, y, z)) for z, y in outline]
    n = len(outline)
    bm.faces.new(a)
    bm.faces.new(b[::-1])
    for k in range(n):
        bm.faces.new((a[k], b[k], b[(k + 1) % n], a[(k + 1) % n]))
    bmesh.ops.recalc_face_normals(bm, faces=bm.faces)
    _bevel(bm, bevel, segments)
    solid(m, bm, mat, matrix, **kw)


def _bevel(bm, offset, segments):
    if offset > 0:
        bmesh.ops.bevel(bm, geom=list(bm.edges), offset=offset, offset_type="OFFSET",
                        segments=segments, profile=0.5, affect="EDGES", clamp_overlap=True)


def arch(half, bottom, spring, segments=24, top_only=False):
    """Round-headed opening, from the lower right corner over the arch to the lower left (CCW)."""
    pts = [] if top_only else [(half, bottom)]
    pts += [(half * math.cos(math.pi * k / segments), spring + half * math.sin(math.pi * k / segments))
            for k in range(segments + 1)]
    return pts if top_only else pts + [(-half, bottom)]


def circle(cx, cy, r, n):
    return [(cx + r * math.cos(2 * math.pi * k / n), cy + r * math.sin(2 * math.pi * k / n))
            for k in range(n)]
