# SPDX-License-Identifier: GPL-3.0-or-later
"""Coffered barrel vault with its oculus."""
import math

import hall_plan as P
from hall_mesh import circle, fillet, grid, lathe, planar
from mathutils import Vector

COLS, MARGIN = 9, 0.36
LAMP_SIDES = 20               # round enough that no corner shows from the floor through a narrow lens
# As large as the heptagons of radius 0.12 m with which the light of the lamps was baked.
LAMP = 0.12 * math.sqrt(7 * math.sin(2 * math.pi / 7) / (LAMP_SIDES * math.sin(2 * math.pi / LAMP_SIDES)))
BAYS = ((-12.0, -10.75, 1), (-10.25, -3.75, 5), (-3.25, 3.25, 5), (3.75, 10.25, 5), (10.75, 12.0, 1))
RIBS = (-10.5, -3.5, 3.5, 10.5)
# inset in the vault's surface, depth behind it, inset on the unfolded lightmap chart
STEPS = ((0.0, 0.0, 0.0), (0.105, 0.0, 0.105), (0.118, 0.015, 0.12), (0.13, 0.12, 0.19),
         (0.205, 0.135, 0.26), (0.222, 0.235, 0.335))


def build(m):
    width = 2 * (P.S - MARGIN) / COLS
    for z0, z1, rows in BAYS:
        chart = m.chart(0.78)
        step = (z1 - z0) / rows
        middle = z0 < 0 < z1
        for r in range(rows):
            lo, hi = z0 + r * step, z0 + (r + 1) * step
            for sign in (-1, 1):
                s0, s1 = sorted((sign * P.S, sign * (P.S - MARGIN)))
                _quad(m, chart, [(s0, lo), (s1, lo), (s1, hi), (s0, hi)])
            for c in range(COLS):
                if middle and 1 <= r <= 3 and 3 <= c <= 5:
                    continue
                s0 = -P.S + MARGIN + c * width
                _coffer(m, chart, s0, s0 + width, lo, hi)
    for z in RIBS:
        _rib(m, z)
    step = 6.5 / 5
    _oculus(m, 1.5 * width, 1.5 * step)


def _quad(m, chart, corners, mat="coffer", depth=(0, 0, 0, 0), uv=None):
    """Corners (s, z), counter-clockwise in (s, z), seen from the room."""
    base = m.add([P.vault(s, z, d) for (s, z), d in zip(corners, depth)])
    uv = uv or corners
    order = [0, 1, 2, 3]
    m.face([base + k for k in order], mat, [uv[k] for k in order], chart, [uv[k] for k in order])


def _coffer(m, chart, s0, s1, z0, z1):
    def ring(inset):
        return [(s0 + inset, z0 + inset), (s1 - inset, z0 + inset), (s1 - inset, z1 - inset),
                (s0 + inset, z1 - inset)]
    for (i0, d0, u0), (i1, d1, u1) in zip(STEPS, STEPS[1:]):
        a, b, ua, ub = ring(i0), ring(i1), ring(u0), ring(u1)
        for k in range(4):
            n = (k + 1) % 4
            _quad(m, chart, [a[k], a[n], b[n], b[k]], depth=(d0, d0, d1, d1), uv=[ua[k], ua[n], ub[n], ub[k]])
    inset, depth, u = STEPS[-1]
    _quad(m, chart, ring(inset), depth=(depth,) * 4, uv=ring(u))
    s, z = (s0 + s1) / 2, (z0 + z1) / 2
    up = Vector(P.vault(s, z, depth + 0.01))
    down = (Vector(P.vault(s, z)) - up).normalized()
    frame = down.to_track_quat("Y", "Z").to_matrix().to_4x4()
    lathe(m, [(LAMP, 0.0), (0.7 * LAMP, 0.035), (0.0, 0.055)], "brass",
          center=up, segments=LAMP_SIDES, matrix=frame, density=0.25)


def _rib(m, z):
    prof = fillet([(z + 0.25, 0), (z + 0.25, -0.05, 0.012), (z + 0.19, -0.05), (z + 0.18, -0.085, 0.012),
                   (z - 0.18, -0.085, 0.012), (z - 0.19, -0.05), (z - 0.25, -0.05, 0.012), (z - 0.25, 0)], 1)
    n = 27
    rows = [[P.vault(P.S * (2 * k / n - 1), zz, d) for zz, d in prof] for k in range(n + 1)]
    grid(m, rows, "coffer", density=0.8, flip=True)


def _oculus(m, half_s, half_z):
    hole = circle(0, 0, P.OCULUS + 0.02, 48)
    frame = [(-half_s, -half_z), (half_s, -half_z), (half_s, half_z), (-half_s, half_z)]
    edge = []
    for k in range(4):
        (a, b), (c, d) = frame[k], frame[(k + 1) % 4]
        edge += [(a + (c - a) * t / 3, b + (d - b) * t / 3) for t in range(3)]    # the coffers' corners
    pts = [(half_s * (i / 7 - 1), half_z * (j / 7 - 1)) for i in range(1, 14) for j in range(1, 14)]
    pts = [p for p in pts if math.hypot(*p) > P.OCULUS + 0.12]

    def keep(s, z):
        return "coffer" if math.hypot(s, z) > P.OCULUS + 0.015 else None
    planar(m, [edge, hole], lambda s, z: P.vault(s, z), keep, density=0.78, points=pts)
    # Stone ring and bronze lip below, drum above (facing the axis, hence top to bottom).
    apex = P.SPRING + P.RISE
    ring = fillet([(P.OCULUS + 0.36, apex + 0.02), (P.OCULUS + 0.36, apex - 0.16, 0.02),
                   (P.OCULUS + 0.27, apex - 0.17, 0.01), (P.OCULUS + 0.25, apex - 0.22, 0.02),
                   (P.OCULUS + 0.07, apex - 0.23, 0.02), (P.OCULUS + 0.06, apex - 0.19)], 1)
    lathe(m, ring[::-1], "travertine", segments=48, density=0.8)
    lip = fillet([(P.OCULUS + 0.065, apex - 0.19), (P.OCULUS + 0.06, apex - 0.245, 0.01),
                  (P.OCULUS, apex - 0.245, 0.012), (P.OCULUS, apex - 0.17)], 2)
    lathe(m, lip[::-1], "bronze", segments=48, density=0.6)
    drum = [(P.OCULUS + 0.02, P.CURB_TOP), (P.OCULUS + 0.02, apex - 0.05), (P.OCULUS, apex - 0.05),
            (P.OCULUS, apex - 0.17)]
    lathe(m, drum, "plaster", segments=48, density=0.6)
