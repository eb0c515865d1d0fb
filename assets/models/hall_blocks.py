# SPDX-License-Identifier: GPL-3.0-or-later
"""Colliders of the building, occluder rectangles inside its solid walls, its openings and its air, as empty nodes."""
import math

import hall_plan as P
from mathutils import Matrix

T = Matrix.Translation


def build(nodes):
    mid = P.SPRING / 2
    for s, name in ((-1, "left"), (1, "right")):
        nodes.solid_box("wall_" + name, (s * (P.X + 0.5), mid, 0), (0.5, mid, P.Z + 1))
        for z in P.SIDE_PILASTERS:
            nodes.solid_box(f"pilaster_{name}_{z:g}", (s * (P.PILASTER + 0.2), mid, z), (0.2, mid, P.PILASTER_HALF))
        edges = [-P.Z] + [e for c in P.ARCHES for e in (c - P.ARCH_HALF, c + P.ARCH_HALF)] + [P.Z]
        for k in range(0, len(edges), 2):
            a, b = edges[k], edges[k + 1]
            nodes.solid_box(f"pier_{name}_{k // 2}", (s * (P.PIER + 0.2), mid, (a + b) / 2), (0.2, mid, (b - a) / 2))
    for s, name in ((-1, "far"), (1, "near")):
        nodes.solid_box("wall_" + name, (0, mid, s * (P.Z + 0.5)), (P.X + 1, mid, 0.5))
        for x in P.END_PILASTERS:
            nodes.solid_box(f"pilaster_{name}_{x:g}", (x, mid, s * (P.END_PILASTER + 0.2)), (P.PILASTER_HALF, mid, 0.2))
    _occluders(nodes)
    _air(nodes)


def _air(nodes):
    """Boxes, from -1 to 1 in the space of their nodes: where light comes in, the air, and the mirror image's walls."""
    def box(name, low, high):
        half = [(h - a) / 2 for a, h in zip(low, high)]
        nodes.add(name, T([(h + a) / 2 for a, h in zip(low, high)]) @ Matrix.Diagonal((*half, 1)))

    top = P.WINDOW_SPRING + P.WINDOW_HALF
    box("opening_window", (-P.WINDOW_HALF, P.WINDOW_SILL, -P.Z - 0.5), (P.WINDOW_HALF, top, -P.Z + 0.1))
    box("opening_oculus", (-P.OCULUS, 9.0, -P.OCULUS), (P.OCULUS, 9.8, P.OCULUS))
    box("room", (-P.X, 0, -P.Z), (P.X, 9.0, P.Z))
    # Niches are shallow enough to count as wall, and the vault as a ceiling of its mean height.
    box("probe_room", (-P.X, 0, -P.Z), (P.X, 8.6, P.Z))
    nodes.add("probe", T((0, 1.8, 0)))


def _occluders(nodes):
    count = {"n": 0}

    def rect(center, half_x, half_y, yaw):
        count["n"] += 1
        nodes.add(f"occluder_{count['n']:02d}", T(center) @ Matrix.Rotation(math.radians(yaw), 4, "Y")
                  @ Matrix.Diagonal((half_x, half_y, 1, 1)))

    # Side walls: above and below the niches' band, and between the niches, 0.3 m inside the wall.
    wall_x, top = P.X + 0.25, P.SPRING
    low, high = P.NICHE_Y - P.NICHE_H / 2 - 0.05, P.NICHE_Y + P.NICHE_H / 2 + 0.05
    for s, side in ((-1, "left"), (1, "right")):
        yaw = -s * 90
        rect((s * wall_x, low / 2, 0), P.Z, low / 2, yaw)
        rect((s * wall_x, (high + top) / 2, 0), P.Z, (top - high) / 2, yaw)
        cut = sorted(z for sd, z in P.NICHES.values() if sd == side)
        half = P.NICHE_W / 2 + 0.05
        edges = [-P.Z] + [e for z in cut for e in (z - half, z + half)] + [P.Z]
        for k in range(0, len(edges), 2):
            a, b = edges[k], edges[k + 1]
            rect((s * wall_x, P.NICHE_Y, (a + b) / 2), (b - a) / 2, (high - low) / 2, yaw)
        for z in cut:                                     # behind a niche, and its side walls
            rect((s * (P.X + P.NICHE_DEPTH + 0.1), P.NICHE_Y, z), half, P.NICHE_H / 2 + 0.05, yaw)
            for e in (z - half, z + half):
                rect((s * (P.X + P.NICHE_DEPTH / 2), P.NICHE_Y, e), P.NICHE_DEPTH / 2 - 0.02, P.NICHE_H / 2, 0)
    # Entrance wall, and the far wall round the window.
    rect((0, P.SPRING / 2, P.Z + 0.45), P.X, P.SPRING / 2, 180)
    far, w = -P.Z - 0.3, P.WINDOW_HALF + 0.15
    side = (P.X - w) / 2
    for s in (-1, 1):
        rect((s * (w + side), P.SPRING / 2, far), side, P.SPRING / 2, 0)
    rect((0, P.WINDOW_SILL / 2 - 0.1, far), w, P.WINDOW_SILL / 2 - 0.1, 0)
    top = P.WINDOW_SPRING + P.WINDOW_HALF + 0.15
    rect((0, (top + P.SPRING) / 2, far), w, (P.SPRING - top) / 2, 0)
