# SPDX-License-Identifier: GPL-3.0-or-later
"""Light that the sun bounces around the hall, wherever it stands: python3 assets/models/hall_transfer.py

Radiosity (Goral et al. 1984, "Modeling the Interaction of Light Between Diffuse Surfaces") on patches, its form factors
counted by rays. Where the sun can shine, patches are joined to sources; of each it is found what it sends to the six
sides of small cubes at points in the air (McTaggart 2004, "Half-Life 2 / Valve Source Shading"), and for a grid of the
sun's directions, how bright each source is. Surfaces take their light from the air around them, times what the sum of
all suns really is there over what the air says: the crevices. assets/SOURCES.md says what is written.
"""
import json
import os
import time

import hall_filter
import hall_plan as P
import numpy as np
import scipy.sparse as sparse
from hall_rays import Atlas, Rays, Triangles, around, over_sphere
from PIL import Image
from png_file import save_png

HERE = os.path.dirname(os.path.abspath(__file__))
SIZE = 512
CELL, SOURCE = 0.4, 1.2         # width of a patch and of a source, meters
FACTOR_RAYS, TEXEL_RAYS, AIR_RAYS, SOURCE_RAYS, BOUNCES = 384, 96, 3072, 24, 8
STEP = 5                        # degrees of azimuth
ELEVATIONS = (0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 23, 26, 29, 32, 36, 40, 45, 50, 56, 63, 71, 80, 90)
# Less than this mean light (irradiance over pi, of a sun of irradiance 1) is left out: under one level of 255.
LEAST = 2.2e-4
AIR_LOW, AIR_HIGH, AIR_SIZE = (-5.7, 0.06, -11.8), (5.7, 8.75, 11.8), (11, 8, 19)
AXES = np.array([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)], float)


def towards(azimuth, elevation):
    """Unit vector to the sun: azimuth from -z towards +x; both in degrees."""
    a, e = np.radians(azimuth), np.radians(elevation)
    return np.array((np.sin(a) * np.cos(e), np.sin(e), -np.cos(a) * np.cos(e)))


class Patches:
    """Texels joined by place, side and material: their number for each texel, areas and albedos."""

    def __init__(self, atlas):
        self.atlas = atlas
        side = np.abs(atlas.away).argmax(axis=1)
        side = 2 * side + (np.take_along_axis(atlas.away, side[:, None], 1)[:, 0] > 0)
        key = np.column_stack((np.floor(atlas.place / CELL).astype(int), side, atlas.kind))
        _, self.of_texel = np.unique(key, axis=0, return_inverse=True)
        self.of_texel = self.of_texel.ravel()
        self.count = self.of_texel.max() + 1
        self.area = np.bincount(self.of_texel, atlas.area)
        self.albedo = np.stack([self.mean(atlas.albedo[:, c]) for c in range(3)], axis=1)
        place = np.stack([self.mean(atlas.place[:, c]) for c in range(3)], axis=1)
        self.inside = is_inside(place)
        self.image = atlas.number_image(self.of_texel)

    def mean(self, values):
        return np.bincount(self.of_texel, values * self.atlas.area) / self.area

    def under(self, coordinates):
        """The patches at these atlas coordinates, -1 where there is none."""
        at = np.clip((coordinates * SIZE).astype(int), 0, SIZE - 1)
        return self.image[at[:, 1], at[:, 0]]


def is_inside(place):
    """The outer skin must set no scale."""
    return (np.abs(place[:, 0]) < P.X + 0.5) & (np.abs(place[:, 2]) < P.Z + 0.5) & \
        (place[:, 1] > -0.5) & (place[:, 1] < P.SPRING + P.RISE + 0.3)


def gather(rays, patches, place, away, ways):
    """Matrix (points, patches) of the mean over `ways` (points, count, 3)."""
    n, count = ways.shape[:2]
    start = (place + 2e-3 * away)[:, None] + np.zeros_like(ways)
    _, at, front = rays.cast(start.reshape(-1, 3), ways.reshape(-1, 3))
    seen = np.where(front, patches.under(at), -1)
    row = np.repeat(np.arange(n), count)
    ok = seen >= 0
    return sparse.csr_matrix((np.full(ok.sum(), 1 / count, np.float32), (row[ok], seen[ok])), (n, patches.count))


def form_factors(rays, patches, rng):
    """Row i: shares of what patch i sees, over its texels."""
    atlas = patches.atlas
    order = np.argsort(patches.of_texel, kind="stable")
    cumulated = np.cumsum(atlas.area[order])
    ends = cumulated[np.searchsorted(patches.of_texel[order], np.arange(patches.count), "right") - 1]
    starts = ends - patches.area
    blocks = []
    for first in range(0, patches.count, 4000):
        numbers = np.arange(first, min(first + 4000, patches.count))
        at = starts[numbers, None] + patches.area[numbers, None] * rng.random((len(numbers), FACTOR_RAYS))
        texel = order[np.minimum(np.searchsorted(cumulated, at), len(order) - 1)]
        ways = around(atlas.normal[texel.ravel()], 1, rng).reshape(len(numbers), FACTOR_RAYS, 3)
        place, away = atlas.place[texel].reshape(-1, 3), atlas.away[texel].reshape(-1, 3)
        matrix = gather(rays, patches, place, away, ways.reshape(-1, 1, 3))
        join = sparse.csr_matrix((np.full(texel.size, 1 / FACTOR_RAYS, np.float32),
                                  (np.repeat(np.arange(len(numbers)), FACTOR_RAYS), np.arange(texel.size))))
        blocks.append(join @ matrix)
    return sparse.vstack(blocks).tocsr()


def sunlight(rays, patches, sun, rng):
    """Irradiance over pi of each patch, of a sun of irradiance 1, by rays that come in through window and oculus."""
    light = np.zeros(patches.count)
    sheets = ((-1.5, P.WINDOW_SILL - 0.3, 1.5, 6.7, 64, 112, -sun[2],
               lambda a, b: np.stack((a, b, np.full_like(a, -P.OUT_Z - 0.15)), axis=1)),
              (-1.85, -1.85, 1.85, 1.85, 72, 72, sun[1],
               lambda a, b: np.stack((a, np.full_like(a, P.CURB_TOP + 0.05), b), axis=1)))
    for a0, b0, a1, b1, columns, rows, cosine, place in sheets:
        if cosine <= 1e-6:
            continue
        a, b = np.meshgrid(np.arange(columns), np.arange(rows))
        a = a0 + (a1 - a0) * (a.ravel() + rng.random(a.size)) / columns
        b = b0 + (b1 - b0) * (b.ravel() + rng.random(b.size)) / rows
        _, at, front = rays.cast(place(a, b), np.broadcast_to(-sun, (len(a), 3)))
        seen = np.where(front, patches.under(at), -1)
        each = (a1 - a0) * (b1 - b0) * cosine / len(a)
        light += np.bincount(seen[seen >= 0], minlength=patches.count) * each
    return light / patches.area / np.pi


class Sources:
    """Patches that the sun can reach, joined by place, side and paint. `share` (patches, sources) is how much brighter a
    patch is than the mean of its source, `light` (sources, suns) that mean: irradiance over pi, of a sun of irradiance 1."""

    def __init__(self, patches, direct):
        atlas = patches.atlas
        place = np.stack([patches.mean(atlas.place[:, c]) for c in range(3)], axis=1)
        away = np.stack([patches.mean(atlas.away[:, c]) for c in range(3)], axis=1)
        side = np.abs(away).argmax(axis=1)
        side = 2 * side + (np.take_along_axis(away, side[:, None], 1)[:, 0] > 0)
        usual = direct.mean(axis=1)
        # Not the outer skin: its light leaves.
        near = (np.abs(place[:, 0]) < P.X + 0.3) & (place[:, 1] > -0.5) & (place[:, 2] > 0.02 - P.OUT_Z) & (
            (place[:, 1] < P.OUT_HIGH - 0.05) | (np.hypot(place[:, 0], place[:, 2]) < P.OCULUS + 0.05))
        lit = np.flatnonzero((usual > 0) & near)
        dark = patches.albedo.mean(axis=1) < 0.3        # Dado, wood and leather next to plaster.
        # The reveal of the window and the drum of the oculus get finer cells: the depth that the sun reaches matters there.
        fine = (place[:, 2] < -P.Z) | (place[:, 1] > P.SPRING + P.RISE)
        cell = np.floor(place[lit] * np.where(fine[lit], 3, 1)[:, None] / SOURCE + 0.25).astype(int)
        key = np.column_stack((cell, side[lit], dark[lit], fine[lit]))
        cells, of = np.unique(key, axis=0, return_inverse=True)
        of = of.ravel()
        flux = np.bincount(of, usual[lit] * patches.area[lit])
        keep = flux > 3e-4 * flux.sum()
        # Cells with little light join the nearest cell of their kind.
        far = np.abs(cells[:, None, :3] - cells[None, keep, :3]).sum(axis=2) + 1e3 * (
            cells[:, None, 3:] != cells[None, keep, 3:]).sum(axis=2)
        number = far.argmin(axis=1)[of]
        self.count = keep.sum()
        print(f"{self.count} sources of {len(cells)}; {flux[~keep].sum() / flux.sum():.1e} of the light has joined others")
        self.of_patch = np.full(patches.count, -1)
        self.of_patch[lit] = number
        self.area = np.bincount(number, patches.area[lit])
        collect = sparse.csr_matrix((patches.area[lit] / self.area[number], (number, lit)),
                                    (self.count, patches.count))
        self.light = collect @ direct
        self.share = sparse.csr_matrix((usual[lit] / (collect @ usual)[number], (lit, number)),
                                       (patches.count, self.count))
        self.center = np.stack([collect @ place[:, c] for c in range(3)], axis=1)

    def points(self, patches, rng):
        """(sources, SOURCE_RAYS) texels, as often as they are bright."""
        atlas = patches.atlas
        of_texel = self.of_patch[patches.of_texel]
        bright = atlas.area * np.asarray(self.share.sum(axis=1)).ravel()[patches.of_texel]
        out = np.empty((self.count, SOURCE_RAYS), int)
        for j in range(self.count):
            texels = np.flatnonzero(of_texel == j)
            sums = np.cumsum(bright[texels])
            at = (np.arange(SOURCE_RAYS) + rng.random(SOURCE_RAYS)) / SOURCE_RAYS * sums[-1]
            out[j] = texels[np.minimum(np.searchsorted(sums, at), len(texels) - 1)]
        return out


def after_bounces(factors, albedo, sent):
    """Light on patches (patches, n) of direct radiance `sent`, after all bounces."""
    part = factors @ sent
    total = part.copy()
    for _ in range(BOUNCES):
        part = factors @ (albedo[:, None] * part)
        total += part
    return total


def share_of_room(factors, gray, room):
    """What light on each patch adds to the mean over the room after all bounces: the solution of the adjoint."""
    part = factors.T @ room
    total = part.copy()
    for _ in range(BOUNCES):
        part = factors.T @ (gray * part)
        total += part
    return gray * total


def air_points():
    x, y, z = (np.linspace(lo, hi, n) for lo, hi, n in zip(AIR_LOW, AIR_HIGH, AIR_SIZE))
    z, y, x = np.meshgrid(z, y, x, indexing="ij")
    return np.column_stack((x.ravel(), y.ravel(), z.ravel()))


def air_gather(rays, patches):
    """Matrix (6 points, patches) of what the sides of all points see of patches, (6 points,) of the sky's light, and
    which points are in the room."""
    ways = over_sphere(AIR_RAYS)
    lobes = 4 * np.maximum(ways @ AXES.T, 0) / AIR_RAYS
    way, side = np.nonzero(lobes)
    blocks, sky, free = [], [], []
    for p in air_points():
        triangle, at, front = rays.cast(np.broadcast_to(p, ways.shape), ways)
        seen = np.where(front, patches.under(at), -1)
        ok = seen[way] >= 0
        blocks.append(sparse.csr_matrix((lobes[way, side][ok], (side[ok], seen[way][ok])), (6, patches.count)))
        sky.append(lobes.T @ (np.where(ways[:, 1] > 0, 1.0, 0.2) * (triangle < 0)))
        free.append(((triangle >= 0) & ~front).mean() < 0.02 and (triangle < 0).mean() < 0.25)
    return sparse.vstack(blocks).tocsr(), np.concatenate(sky), np.array(free)


def air_from_sources(rays, patches, sources, rng):
    """What the sources send straight to the sides of all points, (6 points, sources), by rays to the sources."""
    atlas, texels = patches.atlas, sources.points(patches, rng)
    flat = texels.ravel()
    owner = np.repeat(np.arange(sources.count), SOURCE_RAYS)
    sends = atlas.albedo[flat].mean(axis=1) * sources.area[owner] / SOURCE_RAYS / np.pi
    out = []
    for p in air_points():
        way = atlas.place[flat] - p
        distance = np.linalg.norm(way, axis=1)
        way /= distance[:, None]
        _, at, front = rays.cast(np.broadcast_to(p, way.shape), way)
        seen = front & (sources.of_patch[patches.under(at)] == owner)
        amount = seen * sends * np.maximum(-(way * atlas.normal[flat]).sum(axis=1), 0) / distance ** 2
        sides = np.maximum(way @ AXES.T, 0) * amount[:, None]
        out.append(sides.reshape(sources.count, SOURCE_RAYS, 6).sum(axis=1).T)
    return np.concatenate(out)


def fill_air(values, free):
    """Points in solids (6 points, n) take what the nearest ones in the room have."""
    places = air_points()
    for i in np.flatnonzero(~free):
        nearest = np.flatnonzero(free)[((places[free] - places[i]) ** 2).sum(axis=1).argmin()]
        values[6 * i:6 * i + 6] = values[6 * nearest:6 * nearest + 6]
    return values


def of_air(values, place, normal):
    """Light of the air (6 points,) on surfaces, as lib/light.glsl finds it."""
    low, high, size = np.array(AIR_LOW), np.array(AIR_HIGH), np.array(AIR_SIZE)
    at = np.clip((place - low) / (high - low), 0, 1) * (size - 1)
    base = np.minimum(at.astype(int), size - 2)
    t = at - base
    grid = values.reshape(AIR_SIZE[2], AIR_SIZE[1], AIR_SIZE[0], 6)
    total = 0
    for corner in range(8):
        step = np.array((corner & 1, corner >> 1 & 1, corner >> 2))
        weight = np.prod(np.where(step, t, 1 - t), axis=1)
        cube = grid[tuple((base + step).T[::-1])]
        for axis in range(3):
            side = 2 * axis + (normal[:, axis] < 0)
            total = total + weight * normal[:, axis] ** 2 * np.take_along_axis(cube, side[:, None], 1)[:, 0]
    return total


def sky_on(patches):
    """The sky's light (hall_light_sky.png) on each patch, (patches, 3)."""
    with open(os.path.join(HERE, "hall_light.json")) as f:
        about = json.load(f)["sky"]
    image = Image.open(os.path.join(HERE, about["file"])).convert("RGB").resize((SIZE, SIZE), Image.BOX)
    value = (np.asarray(image) / 255.0) ** 2 * about["scale"]
    atlas = patches.atlas
    return np.stack([patches.mean(value[atlas.row, atlas.column, c]) for c in range(3)], axis=1)


def on_texels(rays, patches, sent, rng):
    """Light of what the patches send (patches, 3) on each texel."""
    atlas, parts = patches.atlas, []
    for first in range(0, len(atlas.row), 16000):
        some = slice(first, first + 16000)
        ways = around(atlas.normal[some], TEXEL_RAYS, rng)
        parts.append(gather(rays, patches, atlas.place[some], atlas.away[some], ways) @ sent)
    return np.concatenate(parts)


def write(name, rows, scales):
    """8-bit PNG of the square roots of rows over their scales, dithered."""
    code = np.sqrt(np.clip(rows / np.maximum(scales, 1e-12), 0, 1)) * 255
    dither = 0.2 + 0.6 * np.random.default_rng(1).random(code.shape)
    code = np.where(rows > 0, np.clip(np.floor(code + dither), 0, 255), 0).astype(np.uint8)
    save_png(os.path.join(HERE, name), code)


def rounded(values):
    return [float(f"{x:.4g}") for x in np.asarray(values).ravel()]


def main():
    start = time.time()
    say = lambda text: print(f"{time.time() - start:4.0f} s  {text}", flush=True)
    rng = np.random.default_rng(1)
    triangles = Triangles(os.path.join(HERE, "hall.glb"))
    rays, atlas = Rays(triangles), Atlas(triangles, SIZE)
    atlas.drop_buried(rays, rng)
    patches = Patches(atlas)
    say(f"{len(atlas.row)} texels, {patches.count} patches")
    suns = [(-180 + STEP * j, e) for e in ELEVATIONS for j in range(360 // STEP)]
    direct = np.stack([sunlight(rays, patches, towards(*s), rng) for s in suns], axis=1)
    sources = Sources(patches, direct)
    say(f"{len(suns)} suns")
    factors = form_factors(rays, patches, rng)
    say(f"form factors: {factors.nnz / 1e6:.1f} million")
    gray = patches.albedo.mean(axis=1)
    sent = (sources.share.multiply(gray[:, None])).tocsr()
    light = after_bounces(factors, gray.astype(np.float32), sent.toarray().astype(np.float32))
    say("bounces")
    see, sky_in_air, free = air_gather(rays, patches)
    straight = air_from_sources(rays, patches, sources, rng)
    # Rays to a source that is near say little; rays that happen to hit it say much.
    near = np.linalg.norm(air_points()[:, None] - sources.center[None], axis=2) < 2 * SOURCE
    air = np.where(np.repeat(near, 6, axis=0), (see @ sent).toarray(), straight) + see @ (gray[:, None] * light)
    air = fill_air(air, free)
    say(f"air: {free.sum()} of {len(free)} points are in the room")

    room = patches.area * patches.inside / (patches.area * patches.inside).sum()
    mean = share_of_room(factors, gray, room) @ direct
    # Sources are as bright as the parts of them that the sun reaches from there make the room.
    right = mean / np.maximum((room @ light) @ sources.light, 1e-12)
    source_light = np.where(mean > LEAST, sources.light * np.clip(right, 0.7, 1.4), 0)
    say(f"sources against patches: {np.percentile(right[mean > LEAST], 5):.3f} to "
        f"{np.percentile(right[mean > LEAST], 95):.3f} of the light")
    usual = np.where(mean > LEAST, np.maximum(mean, LEAST) ** -0.85, 0)
    usual /= usual.sum()
    # All suns together, in color.
    sun = direct @ usual
    color = np.stack([patches.albedo[:, c] * (sun + after_bounces(
        factors, patches.albedo[:, c], (patches.albedo[:, c] * sun)[:, None])[:, 0]) for c in range(3)], axis=1)
    sky = patches.albedo * sky_on(patches)
    air_mean = air @ (source_light @ usual)
    tint = fill_air(see @ color, free) / np.maximum(air_mean, 1e-9)[:, None]
    air_sky = fill_air(see @ sky + sky_in_air[:, None], free)
    texels = on_texels(rays, patches, color, rng)
    say("texels")
    valid = atlas.image(np.ones(len(atlas.row), bool), False)
    ratio = texels / np.maximum(of_air(air_mean, atlas.place, atlas.normal), 1e-3 * air_mean.mean())[:, None]
    ratio = hall_filter.clean(atlas.image(ratio.astype(np.float32)), valid, atlas.image(atlas.place),
                              atlas.image(atlas.normal), 1.2)
    say(f"texels against the air: {np.median(ratio):.3f} in the middle, "
        f"{np.percentile(ratio[valid], 5):.3f} to {np.percentile(ratio[valid], 95):.3f}")
    largest = max(float(np.percentile(ratio[valid], 99.5)), 1.0)
    write("hall_light_bounce.png", ratio, largest)
    scales = np.concatenate((air.max(axis=0), air_sky.max(axis=0), tint.max(axis=0)))
    write("hall_bounce_air.png", np.column_stack((air, air_sky, tint)).T, scales[:, None])
    bright = float(source_light.max())
    write("hall_bounce_suns.png", source_light.T, bright)
    with open(os.path.join(HERE, "hall_bounce.json"), "w") as f:
        json.dump({"elevations": ELEVATIONS, "azimuthStep": STEP, "suns": {"file": "hall_bounce_suns.png", "scale": bright},
                   "air": {"file": "hall_bounce_air.png", "low": AIR_LOW, "high": AIR_HIGH, "size": AIR_SIZE,
                           "scales": rounded(scales)},
                   "surfaces": {"file": "hall_light_bounce.png", "scale": largest}}, f, indent=1)
        f.write("\n")
    say("written")


if __name__ == "__main__":
    main()
