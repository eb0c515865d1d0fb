# SPDX-License-Identifier: GPL-3.0-or-later
"""Plinths, pit, benches, desk, plaques and buttons, and the empty nodes that name the places."""
import math

import hall_plan as P
from hall_mesh import box, circle, fillet, grid, lathe, planar, prism, weld_tail
from mathutils import Matrix, Vector

T = Matrix.Translation


def turn(deg, axis="Y"):
    return Matrix.Rotation(math.radians(deg), 4, axis)


class Nodes:
    """Empty nodes: name -> 4x4 matrix in hall coordinates."""
    def __init__(self):
        self.items = []

    def add(self, name, matrix):
        self.items.append((name, matrix))

    def solid_box(self, name, center, half, yaw=0.0):
        s = Matrix.Diagonal((half[0], half[1], half[2], 1))
        self.add("collider_box_" + name, T(center) @ turn(yaw) @ s)

    def cylinder(self, name, x, z, radius, height, base=0.0):
        s = Matrix.Diagonal((radius, height / 2, radius, 1))
        self.add("collider_cylinder_" + name, T((x, base + height / 2, z)) @ s)


def build(m, nodes):
    _center(m, nodes)
    _card(m, nodes)
    _pit(m, nodes)
    _desk(m, nodes)
    _niches(m, nodes)
    _free(m, nodes)
    for k, (x, z, yaw, length) in enumerate(((2.6, -5.0, 90, 1.8), (-2.6, -5.0, 90, 1.8), (0.0, 8.5, 0, 1.8))):
        _bench(m, nodes, k, x, z, yaw, length)


# Pieces ---------------------------------------------------------------------------------------------

def _plinth(m, x, z, side, height):
    h = side / 2
    box(m, (x - h + 0.03, -0.01, z - h + 0.03), (x + h - 0.03, 0.05, z + h - 0.03), "dark", bevel=0.0,
        skip=("-y", "+y"), density=0.6)
    box(m, (x - h, 0.04, z - h), (x + h, height, z + h), "travertine", bevel=0.012, segments=3, density=1.2,
        shift=(x + 0.17, 0.0))


def _plate(m, nodes, name, matrix):
    """Bronze plate, back at the matrix' origin, front along its +z."""
    box(m, (-0.21, -0.13, 0.0), (0.21, 0.13, 0.018), "bronze", bevel=0.005, segments=1, matrix=matrix,
        density=1.2)
    nodes.add("plaque_" + name, matrix @ T((0, 0, 0.018)))


def _foot(m, x, z, r=0.11):
    lathe(m, fillet([(r, -0.005), (r, 0.012, 0.006), (r - 0.02, 0.02, 0.008), (0.03, 0.032), (0.016, 0.06)], 1),
          "bronze", center=(x, 0, z), segments=16, density=0.6)


def _plaque_post(m, nodes, name, x, z, yaw):
    """Plate at lectern height on a slender post, leaning back."""
    _foot(m, x, z)
    lathe(m, [(0.016, 0.05), (0.013, 1.0)], "bronze", center=(x, 0, z), segments=10, density=0.5)
    tilt = T((x, 1.02, z)) @ turn(yaw) @ turn(-38, "X")
    box(m, (-0.05, -0.05, -0.03), (0.05, 0.05, 0.002), "bronze", bevel=0.006, segments=1, matrix=tilt, density=0.5)
    _plate(m, nodes, name, tilt)
    nodes.cylinder("plaque_post_" + name, x, z, 0.16, 1.2)


def _button_top(m, matrix):
    """Base of the press button: a dished bronze rose on the matrix' +y."""
    lathe(m, fillet([(0.03, -0.06), (0.05, -0.03, 0.012), (0.058, -0.012, 0.006), (0.058, 0.004, 0.005),
                     (0.042, 0.004, 0.003), (0.040, -0.002), (0.0, -0.002)], 1), "bronze",
          segments=16, matrix=matrix, density=0.8)


def _button_post(m, nodes, name, x, z):
    _foot(m, x, z, 0.12)
    lathe(m, [(0.018, 0.05), (0.018, 0.84), (0.03, 0.89)], "bronze",
          center=(x, 0, z), segments=10, density=0.5)
    top = T((x, 0.946, z))
    _button_top(m, top)
    nodes.add("button_" + name, top)
    nodes.cylinder("button_post_" + name, x, z, 0.10, 1.0)


# Places ---------------------------------------------------------------------------------------------

def _center(m, nodes):
    _plinth(m, 0, 0, 0.8, 0.9)
    nodes.add("place_1", T((0, 1.45, 0)))
    _plate(m, nodes, "1", T((0, 0.66, 0.403)) @ turn(-7, "X") @ T((0, 0, 0.014)))
    box(m, (-0.15, 0.56, 0.39), (0.15, 0.75, 0.412), "bronze", bevel=0.004, segments=1, density=0.5)
    _button_post(m, nodes, "1", 0.72, 0.62)
    nodes.solid_box("plinth_1", (0, 0.45, 0), (0.4, 0.45, 0.4))


def _card(m, nodes):
    frame = T((-3.2, 0, 3.0)) @ turn(60)
    nodes.add("place_2", frame @ T((0, 1.2, 0)))
    p = frame @ Vector((-0.72, 0, 0.30))
    _plaque_post(m, nodes, "2", p.x, p.z, 60)
    p = frame @ Vector((-0.42, 0, 0.42))
    _button_post(m, nodes, "2", p.x, p.z)
    nodes.cylinder("stand_2", -3.2, 3.0, 0.3, 1.6)
    return frame


def _pit(m, nodes):
    (x, z), r, d = P.PIT, P.PIT_R, P.PIT_DEPTH
    base = [(r, -d), (r, 0.02)]
    cushion = [(r - 0.015, 0.05), (r + 0.005, 0.12), (r + 0.06, 0.165), (r + 0.14, 0.18), (r + 0.22, 0.165),
               (r + 0.28, 0.12), (r + 0.30, 0.06), (r + 0.285, 0.0)]
    core = (r + 0.14, 0.04)
    pads, inner = 24, (0.0, 0.07, 0.22, 0.78, 0.93)
    squeeze = (0.80, 0.91, 1.0, 1.0, 0.91)
    rows, n = [], pads * len(inner)
    for k in range(n + 1):
        pad, step = divmod(k % n, len(inner))
        a = 2 * math.pi * (pad + inner[step]) / pads
        q = squeeze[step]
        prof = base + [(core[0] + (pr - core[0]) * q, core[1] + (py - core[1]) * q if py > 0.03 else py)
                       for pr, py in cushion]
        rows.append([(x + pr * math.cos(a), py, z + pr * math.sin(a)) for pr, py in prof])
    start = len(m.verts)
    grid(m, rows, "leather", density=0.9, uv_shift=(0, 0))
    # The leather also ends on the bronze ring where pads meet, or the floor would be visible between them. The points are
    # moved after baking, which uses their old places.
    for k in range(start, len(m.verts)):
        px, py, pz = m.verts[k]
        if abs(py) < 1e-9:
            out = (r + 0.285) / math.hypot(px - x, pz - z)
            m.verts[k] = (x + (px - x) * out, py, z + (pz - z) * out)
    weld_tail(m, start)
    planar(m, [circle(x, -z, r + 0.01, 64)], lambda a, b: (a, -d, -b), lambda a, b: "dark", density=0.6)
    lathe(m, fillet([(r + 0.345, -0.004), (r + 0.345, 0.012, 0.006), (r + 0.28, 0.012)], 2), "bronze",
          center=(x, 0, z), segments=72, density=0.5)
    nodes.add("place_3", T((x, -d, z)))
    nodes.add("pit_3", T((x, -d / 2, z)) @ Matrix.Diagonal((r, d / 2, r, 1)))
    for name, a, put in (("plaque", 143, _plaque_post), ("button", 127, _button_post)):
        a = math.radians(a)
        px, pz = x + (r + 0.62) * math.cos(a), z + (r + 0.62) * math.sin(a)
        if name == "plaque":
            put(m, nodes, "3", px, pz, math.degrees(math.atan2(math.cos(a), math.sin(a))))
        else:
            put(m, nodes, "3", px, pz)
    n = 16
    for k in range(n):
        a = 2 * math.pi * (k + 0.5) / n
        rr = r + 0.15
        nodes.solid_box(f"pit_{k}", (x + rr * math.cos(a), 0.1, z + rr * math.sin(a)),
                        (0.15, 0.1, math.pi * rr / n + 0.02), -math.degrees(a))


def _desk(m, nodes):
    z = -8.5
    outline = [(z - 0.20, 0.05), (z + 0.20, 0.05), (z + 0.20, 0.74), (z - 0.20, 0.90)]
    prism(m, outline, -0.46, 0.46, "travertine", bevel=0.014, segments=3, density=1.1)
    box(m, (-0.43, -0.01, z - 0.17), (0.43, 0.06, z + 0.17), "dark", bevel=0.0, skip=("-y", "+y"), density=0.6)
    nodes.add("place_4", T((0, 2.5, z)))
    slope = math.degrees(math.atan2(0.16, 0.40))
    top = T((0, 0.82, z)) @ turn(-(90 - slope), "X")
    _plate(m, nodes, "4", T((-0.12, 0, 0)) @ top)
    out = T((0.26, 0.826, z + 0.0)) @ turn(slope, "X")
    lathe(m, fillet([(0.062, -0.01), (0.058, 0.012, 0.006), (0.042, 0.012, 0.003), (0.04, 0.006), (0.0, 0.006)], 1),
          "bronze", segments=16, matrix=out, density=0.8)
    nodes.add("button_4", out @ T((0, 0.008, 0)))
    nodes.solid_box("desk_4", (0, 0.45, z), (0.46, 0.45, 0.2))


def _niches(m, nodes):
    for n, (side, z) in P.NICHES.items():
        yaw = 90 if side == "left" else -90
        x = -P.X if side == "left" else P.X
        frame = T((x, 0, z)) @ turn(yaw)          # +z into the room, +x to the visitor's right
        nodes.add(f"place_{n}", frame @ T((0, P.NICHE_Y, 0)))
        right = P.NICHE_W / 2 + P.FRAME + 0.42
        box(m, (right - 0.15, 1.32, -0.01), (right + 0.15, 1.48, 0.022), "bronze", bevel=0.004, segments=1, matrix=frame,
            density=0.5)
        _plate(m, nodes, str(n), frame @ T((right, 1.4, 0.024)) @ turn(-5, "X"))
        out = frame @ T((right, 1.06, 0.0)) @ turn(90, "X")
        lathe(m, fillet([(0.075, -0.01), (0.075, 0.012, 0.006), (0.062, 0.02, 0.006), (0.058, 0.05, 0.006),
                         (0.042, 0.05, 0.003), (0.040, 0.044), (0.0, 0.044)], 1), "bronze", segments=16,
              matrix=out, density=0.8)
        nodes.add(f"button_{n}", out @ T((0, 0.046, 0)))


def _free(m, nodes):
    x, z = 3.0, -3.4
    _plinth(m, x, z, 0.9, 0.8)
    nodes.add("place_free", T((x, 0.8, z)))
    _plate(m, nodes, "free", T((x, 0.57, z + 0.453)) @ turn(-7, "X") @ T((0, 0, 0.014)))
    box(m, (x - 0.15, 0.47, z + 0.44), (x + 0.15, 0.66, z + 0.462), "bronze", bevel=0.004, segments=1, density=0.5)
    _button_post(m, nodes, "free", x - 0.78, z + 0.62)
    nodes.solid_box("plinth_free", (x, 0.4, z), (0.45, 0.4, 0.45))


def _bench(m, nodes, index, x, z, yaw, length):
    frame = T((x, 0, z)) @ turn(yaw)
    h, d = length / 2, 0.23
    for k in range(3):
        z0 = -d + k * (2 * d + 0.012) / 3
        box(m, (-h, 0.405, z0), (h, 0.45, z0 + (2 * d - 0.024) / 3), "oak", bevel=0.008, matrix=frame,
            grain="x", shift=(0.13 * k + 0.29 * index, 0.7 * k), density=1.0)
    for s in (-1, 1):
        c = s * (h - 0.28)
        box(m, (c - 0.035, -0.005, -0.19), (c + 0.035, 0.405, 0.19), "oak", bevel=0.008, segments=1, matrix=frame, grain="y",
            shift=(0.4 * s, 0.2 * index), density=0.8)
    box(m, (-h + 0.28, 0.30, -0.025), (h - 0.28, 0.385, 0.025), "oak", bevel=0.006, segments=1, matrix=frame, grain="x",
        density=0.7)
    nodes.solid_box(f"bench_{index}", (x, 0.225, z), (h, 0.225, d), yaw)


LEAN = 18.5                   # degrees by which the card leans back: cardLean in exhibits/lenticular; a test compares both


def stand(m):
    """Brass stand of the lenticular card, in its own frame: the card faces +z and leans back against a bar."""
    lathe(m, fillet([(0.0, 0.0), (0.21, 0.0, 0.004), (0.21, 0.014, 0.006), (0.19, 0.024, 0.008), (0.05, 0.045, 0.03),
                     (0.022, 0.09)], 2), "brass", center=(0, 0, -0.06), segments=22)
    lathe(m, fillet([(0.020, 0.08), (0.020, 0.13), (0.026, 0.14, 0.005), (0.026, 0.155, 0.005), (0.016, 0.17),
                     (0.014, 0.86), (0.021, 0.87, 0.005), (0.021, 0.89, 0.005), (0.012, 0.90), (0.012, 1.075)], 1),
          "brass", center=(0, 0, -0.06), segments=16)
    # Ledge the card stands on, with a lip in front of it.
    outline = [(-0.05, 0.868), (0.035, 0.868), (0.035, 0.905), (0.024, 0.905), (0.024, 0.884), (-0.05, 0.884)]
    prism(m, outline, -0.24, 0.24, "brass", bevel=0.003)
    # Bar behind the card, on top of the post, in the card's frame: the back of the card is at z = -0.005.
    low = math.radians(LEAN)
    foot = 0.884 + 0.005 * math.sin(low)
    card = T((0, foot + 0.2 * math.cos(low), 0.022 - 0.2 * math.sin(low))) @ turn(-LEAN, "X")
    half, y, z = 0.16, 0.01, -0.0055
    box(m, (-half, y - 0.011, z - 0.022), (half, y + 0.011, z), "brass", bevel=0.004, grain="x", matrix=card)
    for s in (-1, 1):
        lathe(m, fillet([(0.0, -0.024), (0.018, -0.022, 0.008), (0.018, -0.002, 0.004), (0.0, 0.0)], 2), "brass",
              segments=16, matrix=card @ T((s * half, y, z)) @ turn(90, "X"))
