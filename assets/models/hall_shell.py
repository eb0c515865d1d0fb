# SPDX-License-Identifier: GPL-3.0-or-later
"""Floor, walls, moldings and the outer, light-tight skin of the hall."""
import math

import hall_plan as P
from hall_mesh import arch, box, circle, fillet, grid, lathe, plan, planar, sweep


def rect(a0, b0, a1, b1):
    return [(a0, b0), (a1, b0), (a1, b1), (a0, b1)]


def inside(p, loop):
    a, b = p
    hit = False
    for k in range(len(loop)):
        (x0, y0), (x1, y1) = loop[k - 1][:2], loop[k][:2]
        if (y0 > b) != (y1 > b) and a < (x1 - x0) * (b - y0) / (y1 - y0) + x0:
            hit = not hit
    return hit


def region(keep, holes, mat):
    return lambda a, b: mat if inside((a, b), keep) and not any(inside((a, b), h) for h in holes) else None


def build(m):
    _floor(m)
    for side in ("left", "right"):
        _side_wall(m, side)
    _end_wall(m, "far")
    _end_wall(m, "near")
    _moldings(m)
    _pilasters(m)
    _outside(m)


def _floor(m):
    hole = circle(P.PIT[0], -P.PIT[1], P.PIT_R + 0.1, 72)
    line, ring, thin, inset = 0.03, 1.15, 0.0125, 0.95
    outer, inner = circle(0, 0, ring + line, 72), circle(0, 0, ring - line, 72)
    bx, bz = P.PIER - inset, P.Z - inset
    frame_out, frame_in = rect(-bx - thin, -bz - thin, bx + thin, bz + thin), \
        rect(-bx + thin, -bz + thin, bx - thin, bz - thin)
    edge = math.sqrt(ring * ring - line * line)
    lines = [rect(-line, edge, line, bz - thin), rect(-line, -P.Z - 0.05, line, -edge)]
    room = rect(-P.X - 0.05, -P.Z - 0.3, P.X + 0.05, P.Z + 0.05)

    def classify(a, b):
        if inside((a, b), hole) or not inside((a, b), room):
            return None
        r = math.hypot(a, b)
        metal = ring - line < r < ring + line or (abs(a) < line and r > ring and b < bz)
        metal = metal or (inside((a, b), frame_out) and not inside((a, b), frame_in))
        return "bronze" if metal else "terrazzo"

    planar(m, [room, hole, outer, inner, frame_out, frame_in] + lines, P.floor, classify, density=1.2)


def _side_wall(m, side):
    pier, back = P.wall(side, P.PIER), P.wall(side)
    face = rect(-P.Z, -0.03, P.Z, P.SPRING + 0.03)
    e = 0.03
    holes = [[(x + P.along(side, z), y) for x, y in arch(P.ARCH_HALF + e, -0.02, P.ARCH_SPRING, 22)]
             for z in P.ARCHES]
    chart = planar(m, [face] + holes, pier, region(face, holes, "plaster"))
    for z in P.ARCHES:
        a = P.along(side, z)
        true = [(x + a, y) for x, y in arch(P.ARCH_HALF, -0.02, P.ARCH_SPRING, 22)]
        depth = P.X - P.PIER
        prof = [(-e, 0), (-e * 0.3, -e * 0.3), (0, -e), (0, -depth)]
        sweep(m, true, prof, pier, "plaster", density=0.9)
        _arch_back(m, side, back, a, z, chart)
        prof = fillet([(-0.30, 0), (-0.30, 0.035, 0.012), (-0.22, 0.035), (-0.20, 0.05, 0.01),
                       (-0.10, 0.05), (-0.085, 0.07, 0.012), (-0.045, 0.07, 0.012),
                       (-0.035, 0.0)], 1)
        ring = [(x + a, y) for x, y in arch(P.ARCH_HALF, 0, P.ARCH_SPRING, 22, top_only=True)]
        sweep(m, ring, prof, pier, "plaster", density=0.8)


def _arch_back(m, side, back, a, z, chart):
    """Wall inside an arch; on the lightmap it lies in the hole of the pier's chart, a little smaller."""
    whole = [(x + a, y) for x, y in arch(P.ARCH_HALF + 0.02, -0.02, P.ARCH_SPRING, 22)]
    holes = []
    if (side, z) in P.NICHES.values():
        w, h = P.NICHE_W / 2, P.NICHE_H / 2
        hole = rect(a - w - 0.1, P.NICHE_Y - h - 0.1, a + w + 0.1, P.NICHE_Y + h + 0.1)
        holes.append(hole)
        loop = rect(a - w, P.NICHE_Y - h, a + w, P.NICHE_Y + h)
        f = P.FRAME
        prof = fillet([(-f, -0.01), (-f, 0.045, 0.012), (-0.135, 0.045, 0.006), (-0.125, 0.06, 0.008),
                       (-0.065, 0.072, 0.01), (-0.055, 0.085, 0.008), (-0.028, 0.085, 0.008),
                       (-0.028, 0.055)], 1)
        sweep(m, loop, prof, back, "travertine", closed=True, density=0.9)
        prof = fillet([(-0.028, 0.055), (-0.024, 0.07, 0.006), (0, 0.07, 0.008), (0, 0.0)], 1)
        sweep(m, loop, prof, back, "bronze", closed=True, density=0.8)
        sweep(m, loop, [(0, 0), (0, -P.NICHE_DEPTH)], back, "travertine", closed=True, density=0.7)
        planar(m, [loop], lambda u, v: back(u, v, -P.NICHE_DEPTH), lambda u, v: "dark", density=0.4)
    small = 0.915
    planar(m, [whole] + holes, back, region(whole, holes, "plaster"), chart=chart,
           unfold=lambda u, v: (a + (u - a) * small, 0.05 + v * small))


def _end_wall(m, side):
    to3 = P.wall(side)
    n = 32
    top = [(P.R * math.sin(t), P.YC + P.R * math.cos(t))
           for t in [(P.S + 0.02) / P.R * (1 - 2 * k / n) for k in range(n + 1)]]
    face = [(-P.X, -0.03), (P.X, -0.03)] + top
    if side == "far":
        splay, e = 0.10, 0.025
        hole = arch(P.WINDOW_HALF + splay + e, P.WINDOW_SILL - 0.06, P.WINDOW_SPRING, 26)
        _reveal(m, to3, splay, e)
    else:
        e = 0.02
        hole = [(P.DOOR_HALF + e, -0.02), (P.DOOR_HALF + e, P.DOOR_H + e),
                (-P.DOOR_HALF - e, P.DOOR_H + e), (-P.DOOR_HALF - e, -0.02)]
    planar(m, [face, hole], to3, region(face, [hole], "plaster"))


def _reveal(m, to3, splay, e):
    """Window jambs and arch from the room to the outer face, splayed towards the room."""
    low = P.WINDOW_SILL - 0.06
    steps = [(splay + e, 0.0), (splay + 0.3 * e, -0.3 * e), (splay, -e), (0.004, -0.47), (0.0, -0.475),
             (0.0, -0.66), (0.02, -0.665), (0.05, -(P.OUT_Z - P.Z))]
    loops = [[to3(a, b, h) for a, b in arch(P.WINDOW_HALF + w, low, P.WINDOW_SPRING, 26)] for w, h in steps]
    rows = list(zip(*loops))
    grid(m, rows, "plaster", density=0.9)
    box(m, (-P.WINDOW_HALF - 0.28, P.WINDOW_SILL - 0.10, -P.OUT_Z - 0.04),
        (P.WINDOW_HALF + 0.28, P.WINDOW_SILL, -P.Z + 0.09), "travertine", bevel=0.012, grain="x")
    prof = fillet([(-0.085, 0), (-0.085, 0.04, 0.02), (-0.015, 0.04, 0.02), (-0.015, -0.002)], 2)
    path = arch(P.WINDOW_HALF + splay, P.WINDOW_SILL, P.WINDOW_SPRING, 26)
    sweep(m, path, prof, to3, "plaster", density=0.8)


def _moldings(m):
    chamfer = lambda path, r: fillet([(x, z, r) for x, z in path], 1, closed=False)
    # Dado: skirting, field and rail, all round but for the door.
    path = chamfer(P.room_path(recess=True, door=True), 0.012)
    prof = fillet([(0.045, -0.01), (0.045, 0.13, 0.006), (0.03, 0.155), (0.018, 0.155),
                   (0.018, P.DADO - 0.085), (0.03, P.DADO - 0.075, 0.006), (0.035, P.DADO - 0.05),
                   (0.058, P.DADO - 0.035), (0.058, P.DADO, 0.01), (-0.01, P.DADO)], 1)
    mats = []
    for p, q in zip(prof, prof[1:]):
        field = p[1] >= 0.1549 and q[1] <= P.DADO - 0.0849 and abs(p[0] - q[0]) < 0.001
        mats.append("dado" if field else "travertine")
    sweep(m, path, prof, plan, mats, density=0.8)
    # Entablature under the vault.
    path = chamfer(P.room_path(recess=False), 0.012)
    top = P.SPRING
    prof = fillet([(-0.01, top - 0.42), (0.05, top - 0.42, 0.006), (0.05, top - 0.34),
                   (0.075, top - 0.335), (0.075, top - 0.27, 0.012), (0.04, top - 0.255),
                   (0.04, top - 0.17), (0.08, top - 0.15, 0.02), (0.12, top - 0.13),
                   (0.13, top - 0.115), (0.26, top - 0.11, 0.006), (0.26, top - 0.065),
                   (0.285, top - 0.055), (0.32, top - 0.005, 0.02), (0.32, top + 0.02, 0.006),
                   (-0.01, top + 0.04)], 1)
    sweep(m, path, prof, plan, "plaster", closed=True, density=0.8)
    # Imposts of the arches: on the piers between recess and pilaster.
    y = P.ARCH_SPRING
    prof = fillet([(-0.005, y - 0.16), (0.02, y - 0.16, 0.006), (0.025, y - 0.10),
                   (0.055, y - 0.07), (0.075, y - 0.05), (0.075, y, 0.006), (-0.005, y)], 1)
    for z in P.ARCHES:
        ends = (z + P.ARCH_HALF + 0.9 - P.PILASTER_HALF, z + P.ARCH_HALF)
        for flip in (1, -1):
            outer = z + flip * (ends[0] - z)
            if abs(outer) > 10:
                outer = math.copysign(10.05, outer)
            edge = z + flip * P.ARCH_HALF
            if flip > 0:
                p = [(-P.PIER, outer), (-P.PIER, edge, 0.012), (-P.X, edge)]
            else:
                p = [(-P.X, edge), (-P.PIER, edge, 0.012), (-P.PIER, outer)]
            p = fillet(p, 1)
            sweep(m, p, prof, plan, "plaster", density=0.7)
            sweep(m, [(-x, -zz) for x, zz in p], prof, plan, "plaster", density=0.7)


def _pilasters(m):
    w = P.PILASTER_HALF
    paths = []
    for z in P.SIDE_PILASTERS:
        p = [(-P.PIER, z + w), (-P.PILASTER, z + w), (-P.PILASTER, z - w), (-P.PIER, z - w)]
        paths += [p, [(-a, -b) for a, b in p]]
    for x in P.END_PILASTERS:
        p = [(x - w, -P.Z), (x - w, -P.END_PILASTER), (x + w, -P.END_PILASTER), (x + w, -P.Z)]
        paths += [p, [(-a, -b) for a, b in p]]
    d, top = P.DADO, P.SPRING - 0.42
    base = fillet([(0.058, d - 0.01), (0.058, d + 0.07, 0.008), (0.05, d + 0.075), (0.062, d + 0.10, 0.018),
                   (0.05, d + 0.135), (0.025, d + 0.14), (0.02, d + 0.165),
                   (0.0, d + 0.19)], 1)
    head = fillet([(0.0, top - 0.36), (0.018, top - 0.355, 0.006), (0.018, top - 0.335),
                   (0.0, top - 0.325), (0.0, top - 0.17), (0.02, top - 0.165, 0.004), (0.02, top - 0.145),
                   (0.05, top - 0.09, 0.02), (0.065, top - 0.08), (0.065, top - 0.005, 0.006),
                   (0.0, top + 0.005)], 1)
    for p in paths:
        shaft = fillet([(x, z, 0.02) for x, z in p], 2)
        grid(m, [[(x, d + 0.18, z), (x, top - 0.35, z)] for x, z in shaft], "plaster", density=0.8, swap=False)
        edge = fillet([(x, z, 0.012) for x, z in p], 1)
        sweep(m, edge, base, plan, "travertine", density=0.7)
        sweep(m, edge, head, plan, "plaster", density=0.7)


def _outside(m):
    """The skin that keeps the sun out: closed but for window and oculus."""
    x, z, lo, hi = P.OUT_X, P.OUT_Z, P.OUT_LOW, P.OUT_HIGH
    d = 0.03
    hole = arch(P.WINDOW_HALF + 0.05, P.WINDOW_SILL - 0.06, P.WINDOW_SPRING, 26)
    face = rect(-x, lo, x, hi)
    planar(m, [face, hole], lambda a, b: (-a, b, -z), region(face, [hole], "dark"), density=d)
    planar(m, [face], lambda a, b: (a, b, z), lambda a, b: "dark", density=d)
    side = rect(-z, lo, z, hi)
    planar(m, [side], lambda a, b: (x, b, -a), lambda a, b: "dark", density=d)
    planar(m, [side], lambda a, b: (-x, b, a), lambda a, b: "dark", density=d)
    roof = rect(-x, -z, x, z)
    hole = circle(0, 0, P.CURB, 48)
    planar(m, [roof, hole], lambda a, b: (a, hi, -b), region(roof, [hole], "dark"), density=d)
    planar(m, [roof], lambda a, b: (a, lo, b), lambda a, b: "dark", density=d)
    top = P.CURB_TOP
    lathe(m, fillet([(P.CURB, hi), (P.CURB, top, 0.03), (P.OCULUS + 0.02, top)], 2), "travertine",
          segments=48, density=0.2)
