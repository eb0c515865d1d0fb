# SPDX-License-Identifier: GPL-3.0-or-later
"""Paints the hall's tileable textures and writes materials.json: python3 textures.py [NAME ...]

<name>_color.png is sRGB. <name>_surface.png holds what a shader looks up at once: x and y of the normal (OpenGL style, +Y
up), roughness and, as alpha, occlusion. Every color map averages to the albedo that hall_materials.py states."""
import json
import os
import sys

import numpy as np
from PIL import Image
from scipy import ndimage
from scipy.spatial import cKDTree

sys.dont_write_bytecode = True
from hall_materials import MATERIALS  # noqa: E402
from png_file import save_png  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))


def noise(n, cells, seed, octaves=1, stretch=(1, 1), gain=0.5):
    """Periodic smooth noise in about [-1, 1]; cells across the tile (x, y scaled by stretch)."""
    rng = np.random.default_rng(seed)
    out, total, amp = np.zeros((n, n)), 0.0, 1.0
    for o in range(octaves):
        cx, cy = (max(1, int(round(cells * s * 2 ** o))) for s in stretch)
        grid = rng.standard_normal((cy, cx))
        big = np.pad(grid, 3, mode="wrap")
        ys = (np.arange(n) + 0.5) * cy / n + 2.5
        xs = (np.arange(n) + 0.5) * cx / n + 2.5
        out += amp * ndimage.map_coordinates(big, np.meshgrid(ys, xs, indexing="ij"), order=3)
        total += amp * amp
        amp *= gain
    return out / np.sqrt(total) / 0.75


def blur(a, sigma):
    return ndimage.gaussian_filter(a, sigma, mode="wrap")


def normals(height, tile):
    """height in meters over a tile of that many meters."""
    n = height.shape[0]
    k = n / tile / 2
    dx = (np.roll(height, -1, 1) - np.roll(height, 1, 1)) * k
    dy = (np.roll(height, 1, 0) - np.roll(height, -1, 0)) * k      # rows run down, +Y up
    v = np.stack([-dx, -dy, np.ones_like(dx)], -1)
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def to_srgb(c):
    c = np.clip(c, 0, 1)
    return np.where(c <= 0.0031308, 12.92 * c, 1.055 * c ** (1 / 2.4) - 0.055)


def codes(data, size=None):
    """data from 0 to 1 in 8 bits; one channel can be reduced to size x size."""
    whole = (np.clip(data, 0, 1) * 255 + 0.5).astype(np.uint8)
    return np.asarray(Image.fromarray(whole).resize((size, size), Image.BOX)) if size else whole


def save(name, color, height, occlusion, roughness, surface_size=None):
    """height in meters; surface_size in texels, if the surface map is smaller than the color map."""
    spec = MATERIALS[name]
    color = np.maximum(color, 0)
    for _ in range(4):
        color = np.clip(color * (np.array(spec["color"]) / color.mean((0, 1))), 0, 0.98)
    folder = os.path.join(HERE, "textures")
    os.makedirs(folder, exist_ok=True)
    nrm = normals(height, spec["tile"]) * 0.5 + 0.5
    # Each channel is resized alone: a picture with alpha would be weighted by it.
    surface = [codes(channel, surface_size) for channel in (nrm[..., 0], nrm[..., 1],
                                                            np.broadcast_to(roughness, height.shape),
                                                            np.broadcast_to(occlusion, height.shape))]
    for kind, data in (("color", codes(to_srgb(color))), ("surface", np.stack(surface, -1))):
        path = os.path.join(folder, f"{name}_{kind}.png")
        save_png(path, data)
        print(f"{path}: {len(data)} px, {os.path.getsize(path) // 1024} KiB")


def mix(a, b, t):
    return np.asarray(a) * (1 - t[..., None]) + np.asarray(b) * t[..., None]


def cells(n, count, seed):
    """Periodic Voronoi: index of the nearest point, distances to the two nearest."""
    rng = np.random.default_rng(seed)
    p = rng.random((count, 2))
    all_p = np.concatenate([p + (i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)])
    y, x = np.mgrid[0:n, 0:n]
    d, k = cKDTree(all_p).query(np.stack([(y + 0.5) / n, (x + 0.5) / n], -1), k=2)
    return k[..., 0] % count, d[..., 0], d[..., 1]


def terrazzo(n=1024):
    rng = np.random.default_rng(7)
    cloud = noise(n, 3, 1, 4)
    color = mix((0.50, 0.465, 0.415), (0.545, 0.51, 0.465), np.clip(0.5 + 0.4 * cloud, 0, 1))
    color *= (1 + 0.02 * noise(n, 180, 2, 2))[..., None]
    hard = np.zeros((n, n))
    palette = np.array([(0.66, 0.62, 0.55), (0.40, 0.36, 0.31), (0.58, 0.50, 0.40), (0.27, 0.245, 0.22),
                        (0.50, 0.40, 0.31), (0.70, 0.675, 0.63), (0.44, 0.42, 0.39), (0.36, 0.22, 0.155)])
    share = np.array([0.22, 0.17, 0.18, 0.08, 0.13, 0.12, 0.08, 0.02])
    # Chips: Voronoi cells shrunk to angular crumbs of three sizes (tile 2 m: 5 to 25 mm).
    for count, keep, seed in ((5200, 0.34, 3), (17000, 0.40, 4), (52000, 0.34, 5)):
        k, d0, d1 = cells(n, count, seed)
        pick = rng.random(count) < keep
        gap = (d1 - d0) * np.sqrt(count)
        size = rng.uniform(0.10, 0.34, count)
        mask = np.clip((gap - size[k]) * 7, 0, 1) * pick[k]
        tint = palette[rng.choice(len(palette), count, p=share)] * rng.uniform(0.9, 1.1, (count, 1))
        strength = mask * 0.85
        color = color * (1 - strength[..., None]) + tint[k] * strength[..., None]
        hard = np.maximum(hard, mask)
    # Ground and polished flat: the chips take it best, the cement between them less; nothing varies over more than chips.
    rough = np.clip(0.155 + 0.012 * noise(n, 60, 12, 2) - 0.03 * hard, 0.12, 0.22)
    save("terrazzo", color, np.zeros((n, n)), 1.0, rough, 512)


def plaster(n=1024):
    # Trowel: overlapping arcs, each a faint ridge and a change of sheen.
    rng = np.random.default_rng(21)
    y, x = np.mgrid[0:n, 0:n] / n
    height, sheen = np.zeros((n, n)), np.zeros((n, n))
    for _ in range(240):
        cx, cy, a = rng.random(), rng.random(), rng.uniform(0, np.pi)
        length, width, bow = rng.uniform(0.10, 0.24), rng.uniform(0.02, 0.05), rng.uniform(-0.5, 0.5)
        dx, dy = (x - cx + 0.5) % 1 - 0.5, (y - cy + 0.5) % 1 - 0.5
        u, v = dx * np.cos(a) + dy * np.sin(a), -dx * np.sin(a) + dy * np.cos(a)
        v = v - bow * u * u / length
        inside = np.exp(-(u / length) ** 4) / (1 + np.exp((np.abs(v) - width) * 260))
        ridge = np.exp(-((np.abs(v) - width) * 150) ** 2) * np.exp(-(u / length) ** 4)
        s = rng.uniform(-1, 1)
        height = height * (1 - 0.6 * inside) + 0.00085 * inside * (s + v / width * 0.5) + 0.00045 * ridge
        sheen = sheen * (1 - 0.6 * inside) + inside * s
    # Baked light does not see the normals, so the color carries edges of strokes: light on ridges, dark in grooves.
    edges = np.clip((height - blur(height, 3 * n / 512)) / 0.0002, -2, 2)
    sand = noise(n, 340, 28, 2)
    height += 0.0016 * noise(n, 3, 22, 3) + 0.00012 * noise(n, 90, 23, 2)
    tone = 1 + 0.022 * sheen + 0.02 * noise(n, 2, 24, 5) + 0.03 * edges + 0.012 * noise(n, 100, 25, 2) + 0.03 * sand
    color = np.array(MATERIALS["plaster"]["color"]) * tone[..., None]
    color[..., 2] *= 1 - 0.012 * noise(n, 3, 26, 3)
    save("plaster", color, height, 1.0, np.clip(0.86 - 0.05 * sheen + 0.02 * noise(n, 40, 27, 2), 0.7, 0.97), 512)


def travertine(n=512):
    # Cut along the bed ("cross cut"): clouds of calcite without a direction, thin veins between them, and round pits in groups.
    cloud = noise(n, 3, 34, 6, gain=0.62)
    lobes = noise(n, 5, 31, 5, gain=0.6)
    veins = np.exp(-np.square(lobes * 14)) * np.clip(0.6 + noise(n, 2, 30, 2), 0, 1)
    grain = noise(n, 150, 40, 2)
    t = np.clip(0.5 + 0.16 * cloud + 0.1 * np.abs(lobes) - 0.34 * veins + 0.05 * grain, 0, 1)
    color = mix((0.42, 0.36, 0.285), (0.63, 0.575, 0.51), t)
    pits = 0.9 * noise(n, 96, 36, 2) + 0.35 * noise(n, 6, 39, 3)
    holes = np.clip((pits - 1.75 + 1.5 * (0.5 - t)) * 2.6, 0, 1)
    color *= (1 - 0.3 * holes)[..., None]
    height = -0.0007 * blur(holes, 0.5) + 0.00006 * cloud + 0.00003 * grain
    rough = np.clip(0.42 + 0.03 * cloud + 0.35 * holes, 0.3, 0.9)
    save("travertine", color, height, 1 - 0.6 * holes, rough)


def oak(n=512):
    # Grain runs along the image's vertical; six boards, quarter and plain sawn.
    y, x = np.mgrid[0:n, 0:n] / n
    warp = 0.030 * noise(n, 3, 41, 3, stretch=(1, 0.7)) + 0.006 * noise(n, 16, 42, 2, stretch=(1, 0.4))
    u = x + warp
    rings = 0.0
    rng = np.random.default_rng(43)
    for f in (9, 14, 23, 31, 38):
        rings = rings + rng.uniform(0.5, 1) * np.sin(2 * np.pi * (f * u + rng.random()) + 0.8 * noise(n, 2, 44 + f, 2))
    rings = rings / 2.0
    fiber = noise(n, 120, 45, 2, stretch=(1, 0.03))
    pores = np.clip(noise(n, 240, 46, 1, stretch=(1, 0.07)) - 0.9 - 0.35 * rings, 0, 1)
    rays = np.clip(noise(n, 40, 47, 2, stretch=(0.9, 0.35)) - 1.3, 0, 1)
    t = np.clip(0.5 + 0.22 * rings + 0.16 * fiber, 0, 1)
    color = mix((0.205, 0.11, 0.048), (0.345, 0.205, 0.103), t)
    color *= (1 - 0.42 * pores)[..., None]
    color *= (1 + 0.15 * rays)[..., None]
    color *= (1 + 0.05 * noise(n, 2, 48, 3, stretch=(2, 0.6)))[..., None]
    height = -0.00028 * pores + 0.00004 * rings + 0.00003 * fiber
    save("oak", color, height, 1 - 0.3 * pores, np.clip(0.45 + 0.25 * pores - 0.08 * rays + 0.03 * fiber, 0.3, 0.85))


def dado(n=512):
    # Limewash over smooth render, waxed: brushed strokes both ways.
    strokes = noise(n, 60, 51, 2, stretch=(1, 0.12)) * 0.6 + noise(n, 60, 52, 2, stretch=(0.12, 1)) * 0.5
    cloud = noise(n, 3, 53, 4)
    tone = 1 + 0.05 * strokes + 0.09 * cloud
    color = np.array(MATERIALS["dado"]["color"]) * tone[..., None]
    color[..., 0] *= 1 + 0.03 * noise(n, 2, 54, 3)
    height = 0.00006 * strokes + 0.0005 * noise(n, 3, 55, 3)
    save("dado", color, height, 1.0, np.clip(0.52 + 0.05 * cloud + 0.05 * strokes, 0.35, 0.75))


def leather(n=512):
    k, d0, d1 = cells(n, 5200, 61)
    gap = (d1 - d0) * np.sqrt(5200)
    pebble = np.clip(gap * 1.5, 0, 1) ** 0.6
    soft = blur(pebble, 1.0)
    cloud = noise(n, 3, 62, 4)
    wrinkle = np.clip(1 - np.abs(noise(n, 7, 63, 3)) * 5, 0, 1)
    color = np.array(MATERIALS["leather"]["color"]) * (0.86 + 0.2 * soft + 0.10 * cloud - 0.12 * wrinkle)[..., None]
    color[..., 1:] *= (1 + 0.05 * cloud)[..., None]
    height = 0.00022 * soft + 0.0006 * noise(n, 5, 64, 2) - 0.00016 * blur(wrinkle, 1.2)
    save("leather", color, height, 0.8 + 0.2 * soft, np.clip(0.50 - 0.10 * soft + 0.05 * cloud + 0.06 * wrinkle, 0.3, 0.8))


def cloth(n=512):
    # Plain weave, 128 threads across the tile of 0.4 m.
    threads = 128
    y, x = np.mgrid[0:n, 0:n] / n
    slub_x, slub_y = noise(n, 40, 71, 2, stretch=(0.1, 1.6)), noise(n, 40, 72, 2, stretch=(1.6, 0.1))
    wx = x * threads + 0.12 * noise(n, 20, 73, 2)
    wy = y * threads + 0.12 * noise(n, 20, 74, 2)
    over = ((np.floor(wx) + np.floor(wy)) % 2) > 0.5
    round_x = np.abs(np.sin(np.pi * wx)) * (0.8 + 0.2 * np.abs(np.sin(np.pi * wy)))
    round_y = np.abs(np.sin(np.pi * wy)) * (0.8 + 0.2 * np.abs(np.sin(np.pi * wx)))
    weave = np.where(over, round_x * (1 + 0.15 * slub_y), round_y * (1 + 0.15 * slub_x))
    tone = 0.84 + 0.2 * weave + 0.045 * np.where(over, slub_y, slub_x) + 0.03 * noise(n, 4, 75, 3)
    color = np.array(MATERIALS["cloth"]["color"]) * tone[..., None]
    save("cloth", color, 0.00022 * blur(weave, 0.6), np.clip(0.7 + 0.3 * weave, 0, 1), 0.95)


def materials_json():
    out = {}
    for name, spec in MATERIALS.items():
        entry = {}
        if "tile" in spec:
            entry = {"tile": spec["tile"], "color": f"textures/{name}_color.png",
                     "surface": f"textures/{name}_surface.png", "hasNormals": not spec.get("polished", False)}
        flat = "tile" not in spec
        entry["baseColor"] = list(spec["color"]) if flat else [1.0, 1.0, 1.0]
        entry["roughness"] = spec["roughness"] if flat else 1.0
        entry["metalness"] = spec["metalness"] if flat else 1.0
        entry["mean"] = {"baseColor": list(spec["color"]), "roughness": spec["roughness"],
                         "metalness": spec["metalness"]}
        out[name] = entry
    with open(os.path.join(HERE, "materials.json"), "w") as f:
        json.dump(out, f, indent=2)
        f.write("\n")


def main():
    painters = (terrazzo, plaster, travertine, oak, dado, leather, cloth)
    for paint in painters:
        if not sys.argv[1:] or paint.__name__ in sys.argv[1:]:
            paint()
    materials_json()


main()
