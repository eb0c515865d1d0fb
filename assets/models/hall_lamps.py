# SPDX-License-Identifier: GPL-3.0-or-later
"""Light of the lamps in the vault's coffers: python3 assets/models/hall_lamps.py

The rosettes (material brass) shine with radiance 1, evenly to all sides. What comes from them straight is found by rays to
points of their triangles, the rest by hall_transfer's radiosity, without color. It goes into the alpha of
hall_light_sky.png, and for the air into hall_lamps_air.png; hall_lamps.json has the scales. For tests a path tracer that
knows nothing of patches, and meets lamps by chance alone, writes tests/exhibits/hall/lamp_light_reference.json.
"""
import json
import os
import time

import hall_filter
import numpy as np
from hall_materials import MATERIALS
from hall_rays import Atlas, Rays, Triangles, around
from hall_transfer import (AXES, HERE, SIZE, Patches, after_bounces, air_gather, air_points, fill_air, form_factors,
                           is_inside, on_texels, rounded, write)
from PIL import Image
from png_file import save_png

TESTS = os.path.join(HERE, "..", "..", "tests", "exhibits", "hall")
SAMPLES, AIR_SAMPLES, PATHS, BOUNCES = 32, 12, 24576, 12
FACES = 60                      # triangles of a rosette


class Lamps:
    """The rosettes: middles, areas, ways of their axes, and their triangles (lamps, FACES)."""

    def __init__(self, triangles):
        faces = np.flatnonzero(triangles.kind == list(MATERIALS).index("brass"))
        self.triangles, self.faces = triangles, faces.reshape(-1, FACES)
        area = triangles.area[self.faces]
        self.area = area.sum(axis=1)
        self.middle = (triangles.corners[self.faces].mean(axis=2) * area[..., None]).sum(axis=1) / self.area[:, None]
        axis = (triangles.facing[self.faces] * area[..., None]).sum(axis=1)
        self.axis = axis / np.linalg.norm(axis, axis=1)[:, None]
        if np.linalg.norm(triangles.corners[self.faces] - self.middle[:, None, None], axis=3).max() > 0.2:
            raise RuntimeError("the triangles of a rosette do not follow each other")
        self.shares = np.cumsum(area / self.area[:, None], axis=1)
        self.of_triangle = np.full(len(triangles.corners), -1)
        self.of_triangle[self.faces] = np.arange(len(self.faces))[:, None]

    def likely(self, place, normal):
        """About how bright each lamp is from each place (places, lamps), nowhere 0; no `normal`: from all sides."""
        way = self.middle[None] - place[:, None]
        square = (way * way).sum(axis=2) + 1e-4
        length = np.sqrt(square)
        sent = np.maximum(-(way * self.axis).sum(axis=2) / length, 0)
        taken = 1.0 if normal is None else np.maximum((way * normal[:, None]).sum(axis=2) / length, 0) + 0.02
        return taken * (0.2 + sent) / square

    def arriving(self, rays, place, away, chosen, rng):
        """Ways to a point of each chosen lamp (n, 3), and what comes from there, over its chance among all points of
        the lamp: radiance times solid angle over pi."""
        face = (self.shares[chosen] < rng.random((len(chosen), 1))).sum(axis=1)
        face = self.faces[chosen, np.minimum(face, FACES - 1)]
        s, t = rng.random((2, len(chosen), 1))
        s, t = np.where(s + t > 1, 1 - s, s), np.where(s + t > 1, 1 - t, t)
        corner = self.triangles.corners[face]
        start = place + 2e-3 * away
        way = corner[:, 0] + s * (corner[:, 1] - corner[:, 0]) + t * (corner[:, 2] - corner[:, 0]) - start
        square = (way * way).sum(axis=1)
        way /= np.sqrt(square)[:, None]
        hit, _, front = rays.cast(start, way)
        seen = front & (self.of_triangle[hit] == chosen)
        sent = np.maximum(-(way * self.triangles.facing[face]).sum(axis=1), 0)
        return way, seen * sent * self.area[chosen] / np.maximum(square, 1e-6) / np.pi

    def chosen(self, place, normal, count, rng):
        """`count` lamps for each place by their likely light, and one over `count` times their chance."""
        weight = self.likely(place, normal)
        sums = np.cumsum(weight, axis=1)
        at = (np.arange(count) + rng.random((len(place), 1))) / count * sums[:, -1:]
        numbers = np.stack([np.minimum((sums < at[:, k:k + 1]).sum(axis=1), len(self.area) - 1)
                            for k in range(count)], axis=1)
        return numbers, sums[:, -1:] / np.take_along_axis(weight, numbers, 1) / count


def direct_on_texels(rays, lamps, atlas, rng):
    """Irradiance over pi, straight from the lamps, on each texel."""
    parts = []
    for first in range(0, len(atlas.row), 8000):
        some = slice(first, first + 8000)
        normal = atlas.normal[some]
        numbers, each = lamps.chosen(atlas.place[some], normal, SAMPLES, rng)
        way, light = lamps.arriving(rays, np.repeat(atlas.place[some], SAMPLES, axis=0),
                                    np.repeat(atlas.away[some], SAMPLES, axis=0), numbers.ravel(), rng)
        taken = np.maximum((way * np.repeat(normal, SAMPLES, axis=0)).sum(axis=1), 0)
        parts.append(((taken * light).reshape(-1, SAMPLES) * each).sum(axis=1))
    return np.concatenate(parts)


def direct_in_air(rays, lamps, rng):
    """The same on the six sides of the points in the air: (6 points,)."""
    out = []
    numbers = np.repeat(np.arange(len(lamps.area)), AIR_SAMPLES)
    for p in air_points():
        place = np.broadcast_to(p, (len(numbers), 3))
        way, light = lamps.arriving(rays, place, np.zeros_like(place), numbers, rng)
        out.append((np.maximum(way @ AXES.T, 0) * light[:, None]).sum(axis=0) / AIR_SAMPLES)
    return np.concatenate(out)


def traced(rays, lamps, triangles, place, normal, rng):
    """Irradiance over pi at places (n, 3) that face `normal`, by paths that end where they happen to meet a lamp."""
    gray = triangles.albedo.mean(axis=1)
    start = np.repeat(place + 0.025 * normal, PATHS, axis=0)      # The places of a curved surface are given on a flat square.
    way = around(np.broadcast_to(normal, place.shape), PATHS, rng).reshape(-1, 3)
    through, light = np.ones(len(start)), 0.0
    for _ in range(BOUNCES + 1):
        hit, _, front = rays.cast(start, way)
        light += through[front & (lamps.of_triangle[hit] >= 0)].sum()
        start, way, through, hit = start[front], way[front], through[front], hit[front]
        facing = triangles.facing[hit]
        far = ((triangles.corners[hit, 0] - start) * facing).sum(axis=1) / (way * facing).sum(axis=1)
        start = start + far[:, None] * way + 1e-3 * facing
        way = around(facing, 1, rng)[:, 0]
        through = through * gray[hit]
    return light / (len(place) * PATHS)


def main():
    begin = time.time()
    say = lambda text: print(f"{time.time() - begin:4.0f} s  {text}", flush=True)
    rng = np.random.default_rng(1)
    triangles = Triangles(os.path.join(HERE, "hall.glb"))
    rays, atlas, lamps = Rays(triangles), Atlas(triangles, SIZE), Lamps(triangles)
    with open(os.path.join(TESTS, "bounced_light_reference.json")) as f:
        regions = json.load(f)["regions"]
    light = [traced(rays, lamps, triangles, np.array(r["places"]), np.array(r["normal"]), rng) for r in regions]
    with open(os.path.join(TESTS, "lamp_light_reference.json"), "w") as f:
        json.dump({r["name"]: x for r, x in zip(regions, rounded(light))}, f, indent=1)
        f.write("\n")
    say(f"paths: {rounded(light)}")

    atlas.drop_buried(rays, rng)
    patches = Patches(atlas)
    direct = direct_on_texels(rays, lamps, atlas, rng)
    say(f"{len(lamps.area)} lamps on {len(atlas.row)} texels")
    factors = form_factors(rays, patches, rng)
    gray = patches.albedo.mean(axis=1)
    straight = patches.mean(direct)
    sent = gray * (straight + after_bounces(factors, gray, (gray * straight)[:, None])[:, 0])
    texels = direct + on_texels(rays, patches, sent, rng)
    say("bounces")
    see, _, free = air_gather(rays, patches)
    air = fill_air(direct_in_air(rays, lamps, rng) + see @ sent, free)
    say("air")

    valid = atlas.image(np.ones(len(atlas.row), bool), False)
    image = np.repeat(atlas.image(texels.astype(np.float32))[..., None], 3, axis=2)
    image = hall_filter.clean(image, valid, atlas.image(atlas.place), atlas.image(atlas.normal))[..., 0]
    scale = float(np.percentile(texels[is_inside(atlas.place)], 99.5))
    path = os.path.join(HERE, "hall_light_sky.png")
    sky = Image.open(path).convert("RGB")
    whole = np.asarray(Image.fromarray(image).resize(sky.size, Image.BILINEAR))
    code = np.sqrt(np.clip(whole / scale, 0, 1)) * 255
    code = np.floor(code + 0.2 + 0.6 * rng.random(code.shape))
    sky.putalpha(Image.fromarray(np.clip(code, 0, 255).astype(np.uint8)))
    save_png(path, np.asarray(sky))
    write("hall_lamps_air.png", air[None], np.array([[air.max()]]))
    with open(os.path.join(HERE, "hall_lamps.json"), "w") as f:
        json.dump({"surfaces": rounded([scale])[0], "air": {"file": "hall_lamps_air.png", "scale": rounded([air.max()])[0]}},
                  f, indent=1)
        f.write("\n")
    say("written")


if __name__ == "__main__":
    main()
