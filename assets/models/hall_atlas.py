# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs the lightmap charts of a Mesh into one square atlas (maximal rectangles)."""
import math

GAP = 4          # free texels between charts, at SIZE
SIZE = 1024
THIN = 2.2       # no chart is thinner, so that each holds a texel center even at half the size


def pack(mesh):
    """Returns ({chart: (scale, offset_u, offset_v, turned, min_u, min_v)}, texels per meter at density 1)."""
    bounds = {}
    for _, _, _, chart, uv in mesh.faces:
        b = bounds.setdefault(chart, [1e9, 1e9, -1e9, -1e9])
        for u, v in uv:
            b[0], b[1] = min(b[0], u), min(b[1], v)
            b[2], b[3] = max(b[2], u), max(b[3], v)
    lo, hi, best = 16.0, 34.0, None
    for _ in range(9):
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
        w, h = max((u1 - u0) * s, THIN), max((v1 - v0) * s, THIN)
        s = (w / max(u1 - u0, 1e-9), h / max(v1 - v0, 1e-9))
        turned = h > w
        if turned:
            w, h = h, w
        rects.append((math.ceil(h) + 1 + GAP, math.ceil(w) + 1 + GAP, chart, s, turned))
    rects.sort(key=lambda r: (-max(r[0], r[1]), -r[0]))
    limit = SIZE - GAP
    free, out = [(0, 0, limit, limit)], {}
    for h, w, chart, s, turned in rects:
        spot = _best(free, w, h)
        if spot is None:
            return None
        x, y, swap = spot
        if swap:
            turned, w, h = not turned, h, w
        _cut(free, x, y, w, h)
        u0, v0 = bounds[chart][:2]
        out[chart] = (s, x + GAP + 0.5, y + GAP + 0.5, turned, u0, v0)
    return out


def _best(free, w, h):
    """Free rectangle with the least space left over on its shorter side."""
    best = None
    for x, y, fw, fh in free:
        for a, b, swap in ((w, h, False), (h, w, True)):
            if a <= fw and b <= fh:
                left = (min(fw - a, fh - b), max(fw - a, fh - b))
                if best is None or left < best[0]:
                    best = (left, x, y, swap)
    return best and best[1:]


def _cut(free, x, y, w, h):
    """Take a rectangle out of the (overlapping) maximal free rectangles."""
    new, keep = [], []
    for f in free:
        fx, fy, fw, fh = f
        if x >= fx + fw or x + w <= fx or y >= fy + fh or y + h <= fy:
            keep.append(f)
            continue
        if x > fx:
            new.append((fx, fy, x - fx, fh))
        if x + w < fx + fw:
            new.append((x + w, fy, fx + fw - x - w, fh))
        if y > fy:
            new.append((fx, fy, fw, y - fy))
        if y + h < fy + fh:
            new.append((fx, y + h, fw, fy + fh - y - h))
    new = [n for n in new if n[2] > GAP + 2 and n[3] > GAP + 2]
    for n in sorted(set(new), key=lambda r: -r[2] * r[3]):
        if not any(_within(n, k) for k in keep):
            keep.append(n)
    free[:] = keep


def _within(a, b):
    return a[0] >= b[0] and a[1] >= b[1] and a[0] + a[2] <= b[0] + b[2] and a[1] + a[3] <= b[1] + b[3]


def coordinate(place, uv):
    """Atlas coordinate in [0, 1] of a point on a chart."""
    s, x, y, turned, u0, v0 = place
    du, dv = (uv[0] - u0) * s[0], (uv[1] - v0) * s[1]
    if turned:
        du, dv = dv, du
    return ((x + du) / SIZE, (y + dv) / SIZE)
