# SPDX-License-Identifier: GPL-3.0-or-later
"""Lightmaps with Cycles, and the lights they share with the preview."""
import json
import math
import os
import time

import bpy
import hall_filter
import hall_plan as P
import numpy as np
from hall_materials import MATERIALS
from mathutils import Vector
from mathutils.bvhtree import BVHTree
from png_file import save_png

SIZE = 1024


def to_blender(v):
    return Vector((v[0], -v[2], v[1]))


def sun_direction(azimuth, elevation):
    a, e = math.radians(azimuth), math.radians(elevation)
    return (math.sin(a) * math.cos(e), math.sin(e), -math.cos(a) * math.cos(e))


def world(strength):
    """Uniform sky of the given radiance, a fifth of it below the horizon."""
    sky = bpy.data.worlds.new("sky")
    bpy.context.scene.world = sky
    sky.use_nodes = True
    tree = sky.node_tree
    back = tree.nodes["Background"]
    geo = tree.nodes.new("ShaderNodeNewGeometry")
    split = tree.nodes.new("ShaderNodeSeparateXYZ")
    above = tree.nodes.new("ShaderNodeMath")
    above.operation = "LESS_THAN"          # Incoming points towards the viewer
    above.inputs[1].default_value = 0.0
    mix = tree.nodes.new("ShaderNodeMath")
    mix.operation = "MULTIPLY_ADD"
    mix.inputs[1].default_value, mix.inputs[2].default_value = 0.8 * strength, 0.2 * strength
    tree.links.new(geo.outputs["Incoming"], split.inputs[0])
    tree.links.new(split.outputs["Z"], above.inputs[0])
    tree.links.new(above.outputs[0], mix.inputs[0])
    tree.links.new(mix.outputs[0], back.inputs["Strength"])
    back.inputs["Color"].default_value = (1, 1, 1, 1)
    return sky


def portals():
    """Area lights that guide the sampling of the sky to window and oculus."""
    for name, center, size, into in (("window", (0, 3.9, -P.Z - 0.62), (2.5, 5.1), (0, 0, 1)),
                                     ("oculus", (0, P.CURB_TOP - 0.1, 0), (2.9, 2.9), (0, -1, 0))):
        light = bpy.data.lights.new(name, "AREA")
        light.shape, light.size, light.size_y = "RECTANGLE", size[0], size[1]
        light.cycles.is_portal = True
        obj = bpy.data.objects.new(name, light)
        obj.location = to_blender(center)
        obj.rotation_mode = "QUATERNION"
        obj.rotation_quaternion = to_blender(into).to_track_quat("-Z", "Y")
        bpy.context.scene.collection.objects.link(obj)


def sun_light(azimuth, elevation, strength, color=(1, 1, 1)):
    light = bpy.data.lights.new("sun", "SUN")
    light.energy, light.angle, light.color = strength, math.radians(0.53), color
    obj = bpy.data.objects.new("sun", light)
    obj.rotation_mode = "QUATERNION"
    obj.rotation_quaternion = (-to_blender(sun_direction(azimuth, elevation))).to_track_quat("-Z", "Y")
    bpy.context.scene.collection.objects.link(obj)
    return obj


def cycles(samples, bounces):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    c = scene.cycles
    c.device, c.samples, c.use_adaptive_sampling, c.use_denoising = "CPU", samples, False, False
    c.max_bounces, c.diffuse_bounces, c.glossy_bounces = bounces, bounces, 3
    c.transparent_max_bounces = c.transmission_bounces = 0
    c.caustics_reflective = c.caustics_refractive = False
    c.sample_clamp_direct = c.sample_clamp_indirect = 0.0
    scene.view_settings.view_transform = "Standard"


# Baking ------------------------------------------------------------------------------------------------

def bake(static, folder, samples, only=None):
    """The sky's light at SIZE; what the sun bounces is hall_transfer.py's."""
    keep = set(static)
    hidden = [o for o in bpy.data.objects if o.type == "MESH" and o not in keep]
    for o in hidden:
        o.hide_render = True
    path = os.path.join(folder, "hall_light.json")
    about = {"sky": {}}
    if os.path.exists(path):
        with open(path) as f:
            about = json.load(f)
    for name in ("sky",):
        if only and name not in only.split(","):
            continue
        start = time.time()
        lamps = _sky_lamps()
        light, inside = _bake_light(static, SIZE, samples)
        for lamp in lamps:
            bpy.data.objects.remove(lamp)
        about[name] = encode(light, inside, os.path.join(folder, f"hall_light_{name}.png"))
        print(f"{name}: {about[name]} in {time.time() - start:.0f} s", flush=True)
        with open(path, "w") as f:
            json.dump(about, f, indent=2)
            f.write("\n")
    for o in hidden:
        o.hide_render = False


def _sky_lamps():
    world(1.0)
    before = set(bpy.data.objects)
    portals()
    return [o for o in bpy.data.objects if o not in before]


def _bake_light(static, size, samples):
    """RGB of the light, top row first, without noise and with every texel filled."""
    image = bpy.data.images.new("bake", size, size, float_buffer=True)
    image.colorspace_settings.name = "Linear"
    for mat in bpy.data.materials:
        _matte(mat, image)
    cycles(1, 1)
    place, covered = _bake_image(static, image, type="POSITION")
    normal, _ = _bake_image(static, image, type="NORMAL", normal_space="OBJECT")
    cycles(samples, 7)
    light, _ = _bake_image(static, image, type="DIFFUSE", pass_filter={"DIRECT", "INDIRECT"})
    # Blender's coordinates: y is the hall's -z. The outer skin must not set the scale.
    room = covered & (place[..., 1] < P.Z + 0.5) & (place[..., 2] < P.SPRING + P.RISE + 0.3) & (place[..., 2] > -0.5)
    normal = normal * 2 - 1
    covered &= ~_buried(static, covered, place, normal)
    return hall_filter.clean(light, covered, place, normal), room


def _buried(static, covered, place, normal):
    """Texels inside other solids: a ray along their normal meets the back of a face first."""
    verts, faces = [], []
    for o in static:
        base = len(verts)
        verts += [tuple(v.co) for v in o.data.vertices]
        faces += [[base + i for i in p.vertices] for p in o.data.polygons]
    tree = BVHTree.FromPolygons(verts, faces)
    out = np.zeros(covered.shape, bool)
    for y, x in zip(*np.nonzero(covered)):
        way = Vector(normal[y, x])
        hit = tree.ray_cast(Vector(place[y, x]) + way * 0.002, way)
        out[y, x] = hit[1] is not None and hit[1].dot(way) > 0.05
    return out


def _bake_image(static, image, **options):
    bpy.ops.object.select_all(action="DESELECT")
    for o in static:
        o.select_set(True)
        o.data.uv_layers.active = o.data.uv_layers["Lightmap"]
    bpy.context.view_layer.objects.active = static[0]
    size = image.size[0]
    image.pixels.foreach_set(np.zeros(size * size * 4, np.float32))
    bpy.ops.object.bake(margin=0, use_clear=False, target="IMAGE_TEXTURES", **options)
    for o in static:
        o.data.uv_layers.active = o.data.uv_layers["UVMap"]
    raw = np.empty(size * size * 4, np.float32)
    image.pixels.foreach_get(raw)
    raw = raw.reshape(size, size, 4)[::-1]
    return raw[..., :3].copy(), raw[..., 3] > 0.5


def _matte(mat, image):
    """Plain diffuse of the material's albedo; metals scatter about half of what they reflect."""
    spec = MATERIALS.get(mat.name)
    if spec is None:
        return
    mat.use_nodes = True
    tree = mat.node_tree
    tree.nodes.clear()
    out = tree.nodes.new("ShaderNodeOutputMaterial")
    bsdf = tree.nodes.new("ShaderNodeBsdfDiffuse")
    k = 0.6 if spec["metalness"] > 0.5 else 1.0
    bsdf.inputs["Color"].default_value = tuple(c * k for c in spec["color"]) + (1,)
    tree.links.new(bsdf.outputs[0], out.inputs[0])
    tex = tree.nodes.new("ShaderNodeTexImage")
    tex.image = image
    tree.nodes.active = tex


def encode(light, inside, path):
    """8-bit PNG of sqrt(value / scale), with a fixed dither; inside tells the texels that set the scale."""
    # Eight bits are for the room: the few texels in the window's reveal may clip, they are near white anyway.
    p = np.percentile(light[inside], (99, 99.9))
    scale = float(min(2 * p[0], 1.03 * p[1]))
    rng = np.random.default_rng(1)
    gray = np.sqrt(np.clip(light / scale, 0, 1)) * 255
    gray = np.clip(np.floor(gray + 0.2 + 0.6 * rng.random(gray.shape[:2])[..., None]), 0, 255).astype(np.uint8)
    save_png(path, gray)
    return {"file": os.path.basename(path), "scale": round(scale, 6)}
