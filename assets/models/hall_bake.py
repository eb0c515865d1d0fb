# SPDX-License-Identifier: GPL-3.0-or-later
"""Lightmaps and preview renders with Cycles."""
import json
import math
import os
import struct
import time
import zlib

import bpy
import hall_plan as P
import numpy as np
from hall_materials import MATERIALS
from mathutils import Matrix, Vector

SIZE = 1024
SUNS = ((14, 12), (10, 20), (-6, 34))    # azimuth from -z towards +x, elevation, in degrees


def _to_blender(v):
    return Vector((v[0], -v[2], v[1]))


def sun_direction(azimuth, elevation):
    a, e = math.radians(azimuth), math.radians(elevation)
    return (math.sin(a) * math.cos(e), math.sin(e), -math.cos(a) * math.cos(e))


def _world(strength):
    """Uniform sky of the given radiance, a fifth of it below the horizon."""
    world = bpy.data.worlds.new("sky")
    bpy.context.scene.world = world
    world.use_nodes = True
    tree = world.node_tree
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
    return world


def _portals():
    """Area lights that guide the sampling of the sky to window and oculus."""
    for name, center, size, into in (("window", (0, 3.9, -P.Z - 0.62), (2.5, 5.1), (0, 0, 1)),
                                     ("oculus", (0, P.KERB_TOP - 0.1, 0), (2.9, 2.9), (0, -1, 0))):
        light = bpy.data.lights.new(name, "AREA")
        light.shape, light.size, light.size_y = "RECTANGLE", size[0], size[1]
        light.cycles.is_portal = True
        obj = bpy.data.objects.new(name, light)
        obj.location = _to_blender(center)
        obj.rotation_mode = "QUATERNION"
        obj.rotation_quaternion = _to_blender(into).to_track_quat("-Z", "Y")
        bpy.context.scene.collection.objects.link(obj)


def _sun(azimuth, elevation, strength, color=(1, 1, 1)):
    light = bpy.data.lights.new("sun", "SUN")
    light.energy, light.angle, light.color = strength, math.radians(0.53), color
    obj = bpy.data.objects.new("sun", light)
    obj.rotation_mode = "QUATERNION"
    obj.rotation_quaternion = (-_to_blender(sun_direction(azimuth, elevation))).to_track_quat("-Z", "Y")
    bpy.context.scene.collection.objects.link(obj)
    return obj


def _cycles(samples, bounces):
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
    keep = set(static)
    hidden = [o for o in bpy.data.objects if o.type == "MESH" and o not in keep]
    for o in hidden:
        o.hide_render = True
    image = bpy.data.images.new("bake", SIZE, SIZE, float_buffer=True)
    image.colorspace_settings.name = "Linear"
    for mat in bpy.data.materials:
        _matte(mat, image)
    jobs = [("sky", None)] + [(f"sun_{k}", s) for k, s in enumerate(SUNS)]
    path = os.path.join(folder, "hall_light.json")
    about = json.load(open(path)) if os.path.exists(path) else {"sky": {}, "sun": [{}, {}, {}]}
    for name, angles in jobs:
        if only and name not in only.split(","):
            continue
        start = time.time()
        _cycles(samples, 8)
        if angles is None:
            _world(1.0)
            _portals()
        else:
            world = _world(0.0)
            world.light_settings.use_ambient_occlusion = False
            sun = _sun(*angles, 1.0)
        light = _bake_pass(static, image, {"DIRECT", "INDIRECT"} if angles is None else {"INDIRECT"})
        if angles is not None:
            bpy.data.objects.remove(sun)
        else:
            for o in [o for o in bpy.data.objects if o.type == "LIGHT"]:
                bpy.data.objects.remove(o)
        np.save(os.path.join(bpy.app.tempdir or "/tmp", name + ".npy"), light)
        entry = encode(light, os.path.join(folder, f"hall_light_{name}.png"))
        if angles is None:
            about["sky"] = entry
        else:
            about["sun"][int(name[-1])] = dict(entry, azimuth=angles[0], elevation=angles[1])
        print(f"{name}: {entry} in {time.time() - start:.0f} s", flush=True)
        with open(path, "w") as f:
            json.dump(about, f, indent=2)
            f.write("\n")
    for o in hidden:
        o.hide_render = False


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


def _bake_pass(static, image, passes):
    """RGB of the light; texels that no chart covers, or that lie buried in a wall, are filled from their neighbours."""
    bpy.ops.object.select_all(action="DESELECT")
    for o in static:
        o.select_set(True)
        o.data.uv_layers.active = o.data.uv_layers["Lightmap"]
    bpy.context.view_layer.objects.active = static[0]
    clear = np.zeros(SIZE * SIZE * 4, np.float32)
    image.pixels.foreach_set(clear)
    bpy.ops.object.bake(type="DIFFUSE", pass_filter=passes, margin=0, use_clear=False, target="IMAGE_TEXTURES")
    for o in static:
        o.data.uv_layers.active = o.data.uv_layers["UVMap"]
    raw = np.empty(SIZE * SIZE * 4, np.float32)
    image.pixels.foreach_get(raw)
    raw = raw.reshape(SIZE, SIZE, 4)[::-1]          # top row first
    light, valid = raw[..., :3].copy(), (raw[..., 3] > 0.5) & (raw[..., :3].max(axis=2) > 1e-5)
    return dilate(denoise(dilate(light, valid), passes), valid)


def denoise(light, passes):
    """Open Image Denoise through the compositor."""
    if not any(getattr(__import__("_cycles"), n, False) for n in ("with_openimagedenoise",)):
        return light
    scene = bpy.context.scene
    img = bpy.data.images.new("noisy", SIZE, SIZE, float_buffer=True)
    img.colorspace_settings.name = "Linear"
    full = np.ones((SIZE, SIZE, 4), np.float32)
    full[..., :3] = light[::-1]
    img.pixels.foreach_set(full.ravel())
    img.update()
    path = os.path.join(bpy.app.tempdir or "/tmp", "noisy.exr")
    img.filepath_raw, img.file_format = path, "OPEN_EXR"
    img.save()
    img = bpy.data.images.load(path)
    img.colorspace_settings.name = "Linear"
    scene.use_nodes = True
    tree = scene.node_tree
    tree.nodes.clear()
    source = tree.nodes.new("CompositorNodeImage")
    source.image = img
    clean = tree.nodes.new("CompositorNodeDenoise")
    clean.use_hdr, clean.prefilter = True, "NONE"
    out = tree.nodes.new("CompositorNodeComposite")
    tree.links.new(source.outputs[0], clean.inputs[0])
    tree.links.new(clean.outputs[0], out.inputs[0])
    engine, old = scene.render.engine, (scene.render.resolution_x, scene.render.resolution_y)
    scene.render.engine = "BLENDER_WORKBENCH" if False else "CYCLES"
    scene.render.resolution_x = scene.render.resolution_y = SIZE
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    samples, scene.cycles.samples = scene.cycles.samples, 1
    target = os.path.join(bpy.app.tempdir or "/tmp", "clean.exr")
    scene.render.filepath = target
    if scene.camera is None:
        cam = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
        scene.collection.objects.link(cam)
        scene.camera = cam
    bpy.ops.render.render(write_still=True)
    scene.use_nodes = False
    scene.cycles.samples = samples
    scene.render.resolution_x, scene.render.resolution_y = old
    result = bpy.data.images.load(target)
    result.colorspace_settings.name = "Linear"
    raw = np.empty(SIZE * SIZE * 4, np.float32)
    result.pixels.foreach_get(raw)
    return np.maximum(raw.reshape(SIZE, SIZE, 4)[::-1, :, :3], 0)


def dilate(light, valid, rounds=12):
    out, have = np.where(valid[..., None], light, 0).astype(np.float32), valid.copy()
    for _ in range(rounds):
        total, count = np.zeros_like(out), np.zeros(have.shape, np.float32)
        for dy in (-1, 0, 1):
            for dx in (-1, 0, 1):
                w = 1.0 if dx == 0 or dy == 0 else 0.5
                h = np.roll(have, (dy, dx), (0, 1)).astype(np.float32) * w
                total += np.roll(out, (dy, dx), (0, 1)) * h[..., None]
                count += h
        new = ~have & (count > 0)
        out[new] = total[new] / count[new][:, None]
        have |= new
    rest = ~have
    if rest.any():
        out[rest] = np.median(light[valid], axis=0)
    return out


def encode(light, path):
    """8-bit PNG of sqrt(value / scale), with a fixed dither of half a step."""
    scale = float(np.percentile(light, 99.95) * 1.05)
    rng = np.random.default_rng(1)
    grey = np.sqrt(np.clip(light / scale, 0, 1)) * 255
    grey = np.clip(np.floor(grey + 0.5 + (rng.random(grey.shape[:2])[..., None] - 0.5) * 0.5), 0, 255).astype(np.uint8)
    png(path, grey)
    return {"file": os.path.basename(path), "scale": round(scale, 6)}


def png(path, rgb):
    h, w, _ = rgb.shape
    rows = rgb.astype(np.int16).reshape(h, w * 3)
    left = np.zeros_like(rows)
    left[:, 3:] = rows[:, :-3]
    up = np.zeros_like(rows)
    up[1:] = rows[:-1]
    data = bytearray()
    average = ((rows - (left + up) // 2) & 255).astype(np.uint8)      # filter 3
    for y in range(h):
        data += b"\x03" + average[y].tobytes()

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    with open(path, "wb") as f:
        f.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", w, h, 8, 2, 0, 0, 0))
                + chunk(b"IDAT", zlib.compress(bytes(data), 9)) + chunk(b"IEND", b""))


# Preview -----------------------------------------------------------------------------------------------

def preview(path, eye, look, samples, size=(1280, 720), sun=20.0):
    folder = os.path.dirname(os.path.abspath(__file__))
    for mat in bpy.data.materials:
        _glossy(mat, folder)
    for o in bpy.data.objects:
        if o.name.startswith("cloth_"):
            o.hide_render = o.name not in ("cloth_1", "cloth_3", "cloth_6", "cloth_4")
    _cycles(samples, 6)
    scene = bpy.context.scene
    scene.cycles.use_denoising = False
    scene.cycles.caustics_reflective = False
    scene.cycles.sample_clamp_indirect = 10
    _world(1.0)
    _portals()
    _sun(10, 20, sun, (1, 0.75, 0.5))
    cam = bpy.data.objects.new("eye", bpy.data.cameras.new("eye"))
    scene.collection.objects.link(cam)
    scene.camera = cam
    cam.location = _to_blender(eye)
    way = _to_blender(look) - cam.location
    cam.rotation_mode = "QUATERNION"
    cam.rotation_quaternion = way.to_track_quat("-Z", "Y")
    cam.data.sensor_fit, cam.data.angle = "VERTICAL", math.radians(55)
    cam.data.clip_start = 0.05
    scene.view_settings.view_transform = "Filmic"
    scene.view_settings.look = "Medium High Contrast"
    scene.view_settings.exposure = 0.9
    scene.render.resolution_x, scene.render.resolution_y = size
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = os.path.abspath(path)
    bpy.ops.render.render(write_still=True)


def _glossy(mat, folder):
    spec = MATERIALS.get(mat.name)
    if spec is None:
        return
    mat.use_nodes = True
    tree = mat.node_tree
    tree.nodes.clear()
    out = tree.nodes.new("ShaderNodeOutputMaterial")
    bsdf = tree.nodes.new("ShaderNodeBsdfPrincipled")
    tree.links.new(bsdf.outputs[0], out.inputs[0])
    bsdf.inputs["Base Color"].default_value = (*spec["color"], 1)
    bsdf.inputs["Roughness"].default_value = spec["roughness"]
    bsdf.inputs["Metallic"].default_value = spec["metalness"]
    base = os.path.join(folder, "textures", mat.name)
    if "tile" not in spec or not os.path.exists(base + "_color.png"):
        return
    uv = tree.nodes.new("ShaderNodeUVMap")
    uv.uv_map = "UVMap"
    scale = tree.nodes.new("ShaderNodeVectorMath")
    scale.operation = "SCALE"
    scale.inputs["Scale"].default_value = 1.0 / spec["tile"]
    tree.links.new(uv.outputs[0], scale.inputs[0])

    def texture(kind, linear):
        node = tree.nodes.new("ShaderNodeTexImage")
        node.image = bpy.data.images.load(f"{base}_{kind}.png")
        if linear:
            node.image.colorspace_settings.name = "Non-Color"
        tree.links.new(scale.outputs[0], node.inputs[0])
        return node.outputs[0]
    tree.links.new(texture("color", False), bsdf.inputs["Base Color"])
    split = tree.nodes.new("ShaderNodeSeparateColor")
    tree.links.new(texture("orm", True), split.inputs[0])
    tree.links.new(split.outputs[1], bsdf.inputs["Roughness"])
    bump = tree.nodes.new("ShaderNodeNormalMap")
    bump.uv_map = "UVMap"
    tree.links.new(texture("normal", True), bump.inputs["Color"])
    tree.links.new(bump.outputs[0], bsdf.inputs["Normal"])
