# SPDX-License-Identifier: GPL-3.0-or-later
"""Path-traced light to hold hall_transfer.py against:
blender -b --factory-startup -noaudio -P assets/models/hall_reference.py -- [SAMPLES]

Cycles, which shares nothing with the radiosity but the triangles of hall.glb, finds the bounced light of a sun of
irradiance 1 on eight small squares for twelve positions of the sun. Writes
tests/exhibits/hall/bounced_light_reference.json: irradiance over pi, the mean of each square, and where the hall's surface
lies under each.
"""
import json
import os
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
sys.dont_write_bytecode = True

import bpy                      # noqa: E402
import hall_plan as P           # noqa: E402
import numpy as np              # noqa: E402
from hall_bake import cycles, sun_light, to_blender  # noqa: E402
from hall_rays import Rays, Triangles  # noqa: E402

OUT = os.path.join(HERE, "..", "..", "tests", "exhibits", "hall", "bounced_light_reference.json")
SUNS = ((14, 12), (-14, 12), (10, 20), (-6, 34), (-3, 19), (0, 8), (30, 25), (-45, 30), (60, 20), (20, 50), (150, 60),
        (-90, 45))
CELLS = 8                       # texels along the side of a square
# Name, middle, half of two sides; their cross product is the way into the room.
SQUARES = (("floor near the door", (-2.5, 0, 8), (0, 0, 0.5), (0.5, 0, 0)),
           ("floor near the window", (-3.5, 0, -9), (0, 0, 0.5), (0.5, 0, 0)),
           ("left wall", (-P.X, 4.2, 0), (0, 0.4, 0), (0, 0, 0.4)),
           ("right wall", (P.X, 1.8, 0), (0, 0, 0.4), (0, 0.4, 0)),
           ("wall of the door", (4.6, 3, P.Z), (0, 0.4, 0), (0.4, 0, 0)),
           ("wall of the window", (-4.6, 3, -P.Z), (0.4, 0, 0), (0, 0.4, 0)),
           ("vault", P.vault(2.5, 3.5, -0.085), tuple(
               (np.array(P.vault(2.9, 0, -0.085)) - P.vault(2.1, 0, -0.085)) / 2), (0, 0, 0.14)),
           ("wall over a niche", (P.X, 3.6, -7), (0, 0, 0.4), (0, 0.4, 0)))
LIFT = 0.012


def squares():
    """Corners (squares, 4, 3) a little off the surface, and the ways into the room."""
    corners, ways = [], []
    for _, middle, a, b in SQUARES:
        middle, a, b = (np.array(v, float) for v in (middle, a, b))
        way = np.cross(a, b)
        way /= np.linalg.norm(way)
        lifted = middle + LIFT * way
        corners.append([lifted - a - b, lifted + a - b, lifted + a + b, lifted - a + b])
        ways.append(way)
    return np.array(corners), np.array(ways)


def mesh(name, corners, color):
    """An object of these faces (n, 3 or 4, 3) in plain diffuse paint."""
    data = bpy.data.meshes.new(name)
    flat = corners.reshape(-1, 3)
    data.from_pydata([(v[0], -v[2], v[1]) for v in flat.tolist()], [],
                     np.arange(len(flat)).reshape(corners.shape[:2]).tolist())
    paint = bpy.data.materials.new(name)
    paint.use_nodes = True
    tree = paint.node_tree
    tree.nodes.clear()
    out, bsdf = tree.nodes.new("ShaderNodeOutputMaterial"), tree.nodes.new("ShaderNodeBsdfDiffuse")
    bsdf.inputs["Color"].default_value = (*color, 1)
    tree.links.new(bsdf.outputs[0], out.inputs[0])
    data.materials.append(paint)
    obj = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(obj)
    return obj


def build(triangles, corners):
    """The hall, and the squares, which nothing sees."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    for color in np.unique(triangles.albedo, axis=0):
        mesh("hall", triangles.corners[(triangles.albedo == color).all(axis=1)], color.tolist())
    obj = mesh("squares", corners, (0.5, 0.5, 0.5))
    uv = obj.data.uv_layers.new(name="UVMap")
    for k in range(len(corners)):
        for i, (u, v) in enumerate(((0, 0), (1, 0), (1, 1), (0, 1))):
            uv.data[4 * k + i].uv = ((k + u) / len(corners), v)
    for ray in ("diffuse", "glossy", "transmission", "volume_scatter", "shadow"):      # camera: it is there at all
        setattr(obj, "visible_" + ray, False)
    image = bpy.data.images.new("squares", CELLS * len(corners), CELLS, float_buffer=True)
    image.colorspace_settings.name = "Linear"
    node = obj.data.materials[0].node_tree.nodes.new("ShaderNodeTexImage")
    node.image = image
    obj.data.materials[0].node_tree.nodes.active = node
    return obj, image


def baked(obj, image, **options):
    bpy.ops.object.select_all(action="DESELECT")
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj
    bpy.ops.object.bake(margin=0, use_clear=True, target="IMAGE_TEXTURES", **options)
    raw = np.empty(len(image.pixels), np.float32)
    image.pixels.foreach_get(raw)
    return raw.reshape(CELLS, -1, CELLS, 4)[..., :3].mean(axis=(0, 2))


def on_atlas(triangles, corners, ways):
    """Of each square: 16 points of the hall's surface under it, where they lie on the atlas, and the way off it."""
    out = []
    for square, way in zip(corners, ways):
        s = (np.arange(4) + 0.5) / 4
        s, t = (x.ravel()[:, None] for x in np.meshgrid(s, s))
        points = square[0] + s * (square[1] - square[0]) + t * (square[3] - square[0]) + 0.01 * way
        hit, at, front = Rays(triangles).cast(points, np.broadcast_to(-way, points.shape))
        if not front.all():
            raise RuntimeError("a square does not lie on the hall's surface")
        out.append({"normal": [round(float(c), 5) for c in way],
                    "places": np.round(points - (LIFT + 0.01) * way, 4).tolist(),
                    "atlas": np.round(at.astype(float), 5).tolist()})
    return out


def main():
    samples = int(sys.argv[sys.argv.index("--") + 1]) if "--" in sys.argv else 4096
    triangles = Triangles(os.path.join(HERE, "hall.glb"))
    corners, ways = squares()
    regions = [{"name": name, **points}
               for (name, *_), points in zip(SQUARES, on_atlas(triangles, corners, ways))]
    obj, image = build(triangles, corners)
    cycles(samples, 12)
    suns = []
    for sun in SUNS:
        start = time.time()
        lamp = sun_light(*sun, 1.0)
        light = baked(obj, image, type="DIFFUSE", pass_filter={"DIRECT", "INDIRECT"})
        light -= baked(obj, image, type="DIFFUSE", pass_filter={"DIRECT"})
        bpy.data.objects.remove(lamp)
        suns.append({"azimuth": sun[0], "elevation": sun[1],
                     "light": [[float(f"{c:.4g}") for c in color] for color in light]})
        print(f"{sun}: {light.mean(axis=1)} in {time.time() - start:.0f} s", flush=True)
        with open(OUT, "w") as f:
            f.write('{"regions": [\n' + ",\n".join(json.dumps(r) for r in regions) + '\n],\n"suns": [\n'
                    + ",\n".join(json.dumps(s) for s in suns) + "\n]}\n")


main()
