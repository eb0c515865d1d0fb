# SPDX-License-Identifier: GPL-3.0-or-later
"""Window bars and the entrance door."""
import math

import hall_plan as P
from hall_mesh import arch, box, fillet, lathe, plan, prism, sweep
from mathutils import Matrix


def build(m):
    _bars(m)
    _door(m)


def _bars(m):
    zc, half, spring = -P.Z - 0.56, P.WINDOW_HALF, P.WINDOW_SPRING
    to3 = lambda a, b, h=0.0: (a, b, zc + h)
    # Frame against the reveal.
    path = arch(half + 0.01, P.WINDOW_SILL - 0.02, spring, 26)
    prof = fillet([(0, -0.035), (0.055, -0.035, 0.008), (0.055, 0.035, 0.008), (0, 0.035)], 1)[::-1]
    sweep(m, path, prof, to3, "bronze", density=0.5)

    def bar(a0, b0, a1, b1, w=0.034, depth=0.05):
        length = math.hypot(a1 - a0, b1 - b0)
        turn = Matrix.Translation((a0, b0, zc)) @ Matrix.Rotation(math.atan2(b1 - b0, a1 - a0), 4, "Z")
        box(m, (0, -w / 2, -depth / 2), (length, w / 2, depth / 2), "bronze", bevel=0.007, segments=1,
            matrix=turn, density=0.4)

    low = P.WINDOW_SILL
    for x in (-0.6, 0.0, 0.6):
        bar(x, low, x, spring - 0.02)
    rows = 5
    for k in range(1, rows):
        y = low + (spring - low) * k / rows
        bar(-half, y, half, y, w=0.028, depth=0.042)
    bar(-half, low + 0.025, half, low + 0.025, w=0.06, depth=0.07)
    bar(-half, spring, half, spring, w=0.06, depth=0.065)
    for r in (0.42,):
        ring = [(r * math.cos(math.pi * k / 20), spring + r * math.sin(math.pi * k / 20)) for k in range(21)]
        prof = [(-0.017, -0.025), (-0.017, 0.025), (0.017, 0.025), (0.017, -0.025), (-0.017, -0.025)]
        sweep(m, ring, prof, to3, "bronze", density=0.4)
    for k in range(1, 6):
        t = math.pi * k / 6
        c, s = math.cos(t), math.sin(t)
        bar(0.42 * c, spring + 0.42 * s, half * c, spring + half * s)
    # A turning handle that tells the size, on the lower middle pane.
    box(m, (-0.014, 1.62, zc + 0.02), (0.014, 1.76, zc + 0.05), "bronze", bevel=0.006, density=0.4)


def _door(m):
    to3 = P.wall("near")
    half, height, deep = P.DOOR_HALF, P.DOOR_H, 0.22
    path = [(half, 0.0), (half, height), (-half, height), (-half, 0.0)]
    prof = [(-0.02, 0), (-0.006, -0.006), (0, -0.02), (0, -deep)]
    sweep(m, path, prof, to3, "travertine", density=0.8)
    frame = fillet([(-0.28, -0.02), (-0.28, 0.06, 0.012), (-0.23, 0.06, 0.006), (-0.22, 0.08, 0.01),
                    (-0.10, 0.09, 0.008), (-0.09, 0.105, 0.012), (-0.045, 0.105, 0.012), (-0.03, 0.06, 0.01),
                    (-0.012, 0.05, 0.01), (-0.012, -0.004)], 1)
    sweep(m, [(half, -0.0), (half, height), (-half, height), (-half, -0.0)], frame, to3, "travertine", density=0.8)
    # Frieze and cornice over the door.
    x = half + 0.28
    box(m, (-x, height + 0.28, P.Z - 0.07), (x, height + 0.55, P.Z + 0.05), "plaster", bevel=0.012)
    y = height + 0.55
    prof = fillet([(-0.02, y - 0.01), (0.09, y, 0.006), (0.10, y + 0.05, 0.012), (0.16, y + 0.06, 0.006),
                   (0.28, y + 0.07, 0.008), (0.28, y + 0.12, 0.006), (0.31, y + 0.17, 0.015),
                   (0.31, y + 0.19, 0.006), (-0.02, y + 0.23)], 1)
    edge = [(x, P.Z), (x, P.Z - 0.001), (-x, P.Z - 0.001), (-x, P.Z)]
    sweep(m, edge, prof, plan, "travertine", density=0.8)
    for s in (-1, 1):   # consoles carrying it
        outline = [(P.Z + 0.02, height + 0.16), (P.Z - 0.10, height + 0.18), (P.Z - 0.13, height + 0.30),
                   (P.Z - 0.22, height + 0.42), (P.Z - 0.24, height + 0.552), (P.Z + 0.02, height + 0.552)]
        c = s * (half + 0.14)
        prism(m, outline, c - 0.09, c + 0.09, "travertine", bevel=0.012)
    for s in (-1, 1):
        _leaf(m, s, half, height, deep)
    box(m, (-0.035, 0.03, P.Z + deep - 0.082), (0.035, height, P.Z + deep - 0.03), "oak", bevel=0.012, shift=(0.77, 0.2))
    # Threshold.
    box(m, (-half - 0.02, -0.02, P.Z - 0.04), (half + 0.02, 0.018, P.Z + 0.5), "bronze", bevel=0.006, grain="x")


def _leaf(m, s, half, height, deep):
    z = P.Z + deep - 0.06          # face of the stiles
    lo, hi = sorted((s * 0.006, s * (half - 0.004)))
    back = z + 0.05
    box(m, (lo, 0.03, back - 0.012), (hi, height, back + 0.05), "oak", bevel=0.0, shift=(0.31 * s, 0))
    stile, rails = 0.15, (0.03, 0.30, 1.02, 1.17, 2.95, 3.09, height)
    def piece(a0, b0, a1, b1, grain, shift):
        box(m, (min(a0, a1), b0, z), (max(a0, a1), b1, back), "oak", bevel=0.008, segments=1, grain=grain, shift=shift)
    piece(lo, 0.03, lo + stile, height, "y", (0.13, 0.0))
    piece(hi - stile, 0.03, hi, height, "y", (0.47, 0.3))
    for k in range(0, 6, 2):
        top = rails[k + 1] if k < 6 else height
        piece(lo + stile - 0.002, rails[k], hi - stile + 0.002, top, "x", (0.2 * k, 0.1 * k))
    piece(lo + stile - 0.002, height - 0.16, hi - stile + 0.002, height, "x", (0.9, 0.4))
    fields = ((0.30, 1.02), (1.17, 2.95), (3.09, height - 0.16))
    for k, (b0, b1) in enumerate(fields):
        a0, a1 = lo + stile, hi - stile
        frame = fillet([(0.0, 0.0), (0.03, -0.012, 0.006), (0.045, -0.04)], 2)
        to3 = lambda a, b, h=0.0: (-a, b, z - h)
        loop = [(-a1, b0), (-a0, b0), (-a0, b1), (-a1, b1)]
        sweep(m, loop, [(o, h + 0.008) for o, h in frame], lambda a, b, h: (-a, b, z - h), "oak", closed=True,
              density=0.8)
        box(m, (a0 + 0.085, b0 + 0.085, z + 0.012), (a1 - 0.085, b1 - 0.085, back), "oak", bevel=0.014, segments=1,
            shift=(0.61 * k + 0.2 * s, 0.37 * k))
    # Kick plate and a long pull.
    box(m, (lo + 0.04, 0.06, z - 0.004), (hi - 0.04, 0.26, z + 0.01), "bronze", bevel=0.003, segments=1, grain="x")
    x = s * 0.115
    for y in (0.98, 1.42):
        turn = Matrix.Translation((x, y, z)) @ Matrix.Rotation(-math.pi / 2, 4, "X")
        lathe(m, fillet([(0.034, 0.0), (0.034, 0.008, 0.004), (0.014, 0.014, 0.004), (0.011, 0.055), (0.0, 0.055)], 2),
              "bronze", segments=16, matrix=turn, density=0.6)
    lathe(m, fillet([(0.0, 0.90), (0.012, 0.90, 0.006), (0.012, 0.93), (0.0155, 0.98, 0.01), (0.0135, 1.2),
                     (0.0155, 1.42, 0.01), (0.012, 1.47), (0.012, 1.50, 0.006), (0.0, 1.50)], 2), "bronze",
          center=(x, 0, z - 0.062), segments=12, density=0.8)
    turn = Matrix.Translation((x, 0.80, z)) @ Matrix.Rotation(-math.pi / 2, 4, "X")
    lathe(m, [(0.022, 0.0), (0.022, 0.004), (0.018, 0.006), (0.008, 0.006), (0.0, 0.002)], "bronze",
          segments=14, matrix=turn, density=0.5)
