# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures of the hall (meters) and the frames of its four walls. Everything else asks here."""
import math

X, Z = 6.0, 12.0              # back plane of the arched recesses; end walls
PIER, PILASTER = 5.88, 5.76   # |x| of the pier face and of the pilaster face
END_PILASTER = 11.88
SPRING, RISE = 7.0, 2.2       # barrel vault
R = (X * X + RISE * RISE) / (2 * RISE)
YC = SPRING + RISE - R
S = R * math.asin(X / R)      # half of the arc
OUT_X, OUT_Z, OUT_LOW, OUT_HIGH = 7.0, 12.9, -0.9, 10.05
OCULUS, CURB, CURB_TOP = 1.4, 1.75, 10.4

ARCHES = (-7.0, 0.0, 7.0)     # centers of the wall arches along z
ARCH_HALF, ARCH_SPRING = 2.6, 3.55
SIDE_PILASTERS = (-10.5, -3.5, 3.5, 10.5)
END_PILASTERS = (-2.95, 2.95)
PILASTER_HALF = 0.45
DADO = 0.68                   # the portal frames stand on its rail

NICHE_W, NICHE_H, NICHE_Y, NICHE_DEPTH, FRAME = 2.4, 1.6, 1.65, 0.5, 0.17
NICHES = {5: ("left", -7.0), 6: ("left", 0.0), 7: ("left", 7.0),
          8: ("right", -7.0), 9: ("right", 7.0)}

WINDOW_HALF, WINDOW_SILL, WINDOW_SPRING = 1.2, 1.4, 5.2
DOOR_HALF, DOOR_H = 1.3, 4.2
PIT, PIT_R, PIT_DEPTH = (3.3, 3.0), 1.6, 0.35


def wall(side, d=None):
    """Right-handed frame (a, b, h): b up, h out of the wall into the room, h = 0 at distance d."""
    if side == "left":
        d = X if d is None else d
        return lambda a, b, h=0.0: (-d + h, b, -a)
    if side == "right":
        d = X if d is None else d
        return lambda a, b, h=0.0: (d - h, b, a)
    d = Z if d is None else d
    if side == "far":
        return lambda a, b, h=0.0: (a, b, -d + h)
    return lambda a, b, h=0.0: (-a, b, d - h)


def along(side, z):
    """Coordinate a of wall(side) at the hall's z (side walls)."""
    return -z if side == "left" else z


def floor(a, b, h=0.0):
    return (a, h, -b)


def vault(s, z, depth=0.0):
    """Point on the vault; depth is measured outward, away from the room."""
    return ((R + depth) * math.sin(s / R), YC + (R + depth) * math.cos(s / R), z)


def room_path(recess, door=False):
    """Plan of the room's wall, inside to the left: with the arched recesses or along the piers.

    With door, it starts and ends at the door's jambs instead of closing."""
    w = PILASTER_HALF
    marks = []
    for z in SIDE_PILASTERS:
        marks += [(z + w, PIER, PILASTER), (z - w, PILASTER, PIER)]
    if recess:
        for z in ARCHES:
            marks += [(z + ARCH_HALF, PIER, X), (z - ARCH_HALF, X, PIER)]
    marks.sort(reverse=True)
    left = [(-PIER, Z)]
    for z, a, b in marks:
        left += [(-a, z), (-b, z)]
    left.append((-PIER, -Z))
    far = []
    for x in END_PILASTERS:
        far += [(x - w, -Z), (x - w, -END_PILASTER), (x + w, -END_PILASTER), (x + w, -Z)]
    half = left + far
    other = [(-x, -z) for x, z in half]
    path = half + other
    if door:
        cut = DOOR_HALF + 0.28
        k = len(half) + len(left) + 4           # between the two pilasters of the entrance wall
        path = [(-cut, Z)] + path[k:] + path[:k] + [(cut, Z)]
    return path
