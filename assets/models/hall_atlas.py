# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs the lightmap charts of a Mesh into one square atlas (rectangles, skyline)."""
import math

GAP = 4          # free texels between charts, at SIZE
SIZE = 1024


def pack(mesh):
    """Returns ({chart: (scale, offset_u, offset_v, turned, min_u, min_v)}, texels per metre at density 1)."""
    bounds = {}
    for _, _, _, chart, uv in mesh.faces:
        b = bounds.setdefault(chart, [1e9, 1e9, -1e9, -1e9])
        for u, v in uv:
            b[0], b[1] = min(b[0], u), min(b[1], v)
            b[2], b[3] = max(b[2], u), max(b[3], v)
    lo, hi, best = 8.0, 60.0, None
    for _ in range(12):
        mid = (lo + hi) / 2
        placed = _try(mesh, bounds, mid)
        if placed:
            lo, best = mid, placed
        else:
            hi = mid
    if best is None:
        raise RuntimeError("the lightmap charts do not fit")
    return best, lo


def _try(mesh, bounds, scale):
    rects = []
    for chart, (u0, v0, u1, v1) in bounds.items():
        s = scale * mesh.charts[chart]
        w, h = (u1 - u0) * s, (v1 - v0) * s
        turned = h > w
        if turned:
            w, h = h, w
        rects.append((math.ceil(h) + 1 + GAP, math.ceil(w) + 1 + GAP, chart, s, turned))
    rects.sort(key=lambda r: (-r[0], -r[1]))
    limit = SIZE - GAP
    sky = [(0, 0, limit)]      # x, y, width
    out = {}
    for h, w, chart, s, turned in rects:
        spot = _place(sky, w, h, limit)
        if spot is None:
            if w != h:
                spot = _place(sky, h, w, limit)
                if spot is None:
                    return None
                turned, w, h = not turned, h, w
            else:
                return None
        x, y = spot
        _raise(sky, x, y + h, w)
        u0, v0 = bounds[chart][:2]
        out[chart] = (s, x + GAP + 0.5, y + GAP + 0.5, turned, u0, v0)
    return out


def _place(sky, w, h, limit):
    best = None
    for k, (x, _, _) in enumerate(sky):
        if x + w > limit:
            break
        y, left, n = 0, w, k
        while left > 0:
            y = max(y, sky[n][1])
            left -= sky[n][2]
            n += 1
        if y + h <= limit and (best is None or y < best[1]):
            best = (x, y)
    return best


def _raise(sky, x, top, w):
    out = []
    for sx, sy, sw in sky:
        a, b = max(sx, x), min(sx + sw, x + w)
        if a >= b:
            out.append((sx, sy, sw))
            continue
        if sx < x:
            out.append((sx, sy, x - sx))
        if sx + sw > x + w:
            out.append((x + w, sy, sx + sw - x - w))
    out.append((x, top, w))
    out.sort()
    merged = [out[0]]
    for seg in out[1:]:
        px, py, pw = merged[-1]
        if py == seg[1] and px + pw == seg[0]:
            merged[-1] = (px, py, pw + seg[2])
        else:
            merged.append(seg)
    sky[:] = merged


def coordinate(place, uv):
    """Atlas coordinate in [0, 1] of a point on a chart."""
    s, x, y, turned, u0, v0 = place
    du, dv = (uv[0] - u0) * s, (uv[1] - v0) * s
    if turned:
        du, dv = dv, du
    return ((x + du) / SIZE, (y + dv) / SIZE)
