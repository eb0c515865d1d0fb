# SPDX-License-Identifier: GPL-3.0-or-later
"""Preview renders of the hall with Cycles."""
import json
import math
import os

import bpy
import numpy as np
from hall_bake import cycles, portals, sun_light, to_blender, world
from hall_materials import MATERIALS


HERE = os.path.dirname(os.path.abspath(__file__))
SUN, SUN_COLOR, SUN_AT = 20.0, (1, 0.75, 0.5), (10, 20)     # azimuth and elevation, degrees


def preview(path, eye, look, samples, mode, size):
    """mode: clay (shape only), baked (lightmaps and direct sun) or traced (everything, noisy)."""
    clay = mode == "clay"
    for mat in list(bpy.data.materials):
        if clay:
            _clay(mat)
        else:
            _glossy(mat, mode == "baked")
    for o in bpy.data.objects:
        if o.name.startswith("cloth_"):
            o.hide_render = o.name in ("cloth_5", "cloth_8")
    cycles(samples, 6)
    scene = bpy.context.scene
    scene.cycles.use_denoising = False
    scene.cycles.caustics_reflective = False
    scene.cycles.sample_clamp_indirect = 2
    sky = world(1.0)
    if mode == "baked":
        sky.cycles_visibility.diffuse = False
        scene.cycles.diffuse_bounces = 0
        scene.cycles.max_bounces = 3
    else:
        portals()
    sun_light(*SUN_AT, SUN, SUN_COLOR)
    cam = bpy.data.objects.new("eye", bpy.data.cameras.new("eye"))
    scene.collection.objects.link(cam)
    scene.camera = cam
    cam.location = to_blender(eye)
    way = to_blender(look) - cam.location
    cam.rotation_mode = "QUATERNION"
    cam.rotation_quaternion = way.to_track_quat("-Z", "Y")
    cam.data.sensor_fit, cam.data.angle = "VERTICAL", math.radians(55)
    cam.data.clip_start = 0.05
    scene.view_settings.view_transform = "Standard" if clay else "Filmic"
    scene.view_settings.look = "None" if clay else "Medium High Contrast"
    scene.view_settings.exposure = 0.0 if clay else 1.3
    scene.render.resolution_x, scene.render.resolution_y = size
    scene.render.image_settings.file_format = "PNG"
    scene.render.filepath = os.path.abspath(path)
    bpy.ops.render.render(write_still=True)


def _clay(mat):
    """Shape only: occlusion times a little directional shade; back faces red."""
    mat.use_nodes = True
    tree = mat.node_tree
    tree.nodes.clear()
    out = tree.nodes.new("ShaderNodeOutputMaterial")
    glow = tree.nodes.new("ShaderNodeEmission")
    near = tree.nodes.new("ShaderNodeAmbientOcclusion")
    near.inputs["Distance"].default_value = 0.8
    near.samples = 4
    geo = tree.nodes.new("ShaderNodeNewGeometry")
    dot = tree.nodes.new("ShaderNodeVectorMath")
    dot.operation = "DOT_PRODUCT"
    dot.inputs[1].default_value = (0.35, -0.25, 0.6)
    shade = tree.nodes.new("ShaderNodeMath")
    shade.operation = "MULTIPLY_ADD"
    shade.inputs[1].default_value, shade.inputs[2].default_value = 0.35, 0.5
    mult = tree.nodes.new("ShaderNodeMath")
    mult.operation = "MULTIPLY"
    mix = tree.nodes.new("ShaderNodeMixRGB")
    mix.inputs[1].default_value, mix.inputs[2].default_value = (1, 1, 1, 1), (1, 0.05, 0.05, 1)
    tree.links.new(geo.outputs["Backfacing"], mix.inputs[0])
    tree.links.new(mix.outputs[0], glow.inputs["Color"])
    tree.links.new(geo.outputs["Normal"], dot.inputs[0])
    tree.links.new(dot.outputs["Value"], shade.inputs[0])
    tree.links.new(shade.outputs[0], mult.inputs[0])
    tree.links.new(near.outputs["AO"], mult.inputs[1])
    tree.links.new(mult.outputs[0], glow.inputs["Strength"])
    tree.links.new(glow.outputs[0], out.inputs[0])


def _load(name):
    image = bpy.data.images.load(os.path.join(HERE, name), check_existing=True)
    image.colorspace_settings.name = "Non-Color"
    return image


def _bounced():
    """The sun's bounced light as the square roots of its values: the sum of hall_transfer.py's modes."""
    if "bounced" in bpy.data.images:
        return bpy.data.images["bounced"]
    import hall_transfer
    with open(os.path.join(HERE, "hall_bounce.json")) as f:
        about = json.load(f)
    modes = len(about["modes"])
    weights = hall_transfer.interpolated(np.array(about["coefficients"]).reshape(-1, modes).T, *SUN_AT)

    def pixels(name):
        image = _load(name)
        raw = np.empty(len(image.pixels), np.float32)
        image.pixels.foreach_get(raw)
        return raw.reshape(image.size[1], image.size[0], 4)
    total = 0
    for k, (mode, weight) in enumerate(zip(about["modes"], weights)):
        t = mode["low"] + (1 - mode["low"]) * pixels(about["files"][k // 3])[..., k % 3]
        total = total + t * np.abs(t) * mode["scale"] * weight
    tint = pixels(about["files"][-1])
    tint[..., :3] = np.sqrt(np.maximum(total, 0)[..., None] * 2 * tint[..., :3])
    image = bpy.data.images.new("bounced", tint.shape[1], tint.shape[0], float_buffer=True)
    image.colorspace_settings.name = "Linear"
    image.pixels.foreach_set(tint.ravel())
    return image


def _baked(tree, color):
    """Light of the lightmaps times the color (a socket or a constant), as emission."""
    with open(os.path.join(HERE, "hall_light.json")) as f:
        about = json.load(f)
    uv = tree.nodes.new("ShaderNodeUVMap")
    uv.uv_map = "Lightmap"
    total = None
    sky = about["sky"]
    for image, scale, tint in ((_load(sky["file"]), sky["scale"], (1, 1, 1)),
                               (_bounced(), 1.0, [SUN * c for c in SUN_COLOR])):
        tex = tree.nodes.new("ShaderNodeTexImage")
        tex.image = image
        tree.links.new(uv.outputs[0], tex.inputs[0])
        square = tree.nodes.new("ShaderNodeVectorMath")
        square.operation = "MULTIPLY"
        scaled = tree.nodes.new("ShaderNodeVectorMath")
        scaled.operation = "MULTIPLY_ADD"
        scaled.inputs[1].default_value = [scale * c for c in tint]
        scaled.inputs[2].default_value = (0, 0, 0)
        tree.links.new(tex.outputs[0], square.inputs[0])
        tree.links.new(tex.outputs[0], square.inputs[1])
        tree.links.new(square.outputs[0], scaled.inputs[0])
        if total:
            tree.links.new(total, scaled.inputs[2])
        total = scaled.outputs[0]
    mult = tree.nodes.new("ShaderNodeVectorMath")
    mult.operation = "MULTIPLY"
    mult.inputs[0].default_value = mult.inputs[1].default_value = tuple(color) if isinstance(color, tuple) else (1, 1, 1)
    tree.links.new(total, mult.inputs[0])
    if not isinstance(color, tuple):
        tree.links.new(color, mult.inputs[1])
    return mult.outputs[0]


def _glossy(mat, baked):
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
    base = os.path.join(HERE, "textures", mat.name)
    static = any(o.name.startswith("hall_") and mat.name in o.data.materials
                 for o in bpy.data.objects if o.type == "MESH")
    shine = bsdf.inputs["Emission"]
    if baked and spec["metalness"] < 0.5:
        bsdf.inputs["Emission Strength"].default_value = 1.0
        if static:
            tree.links.new(_baked(tree, spec["color"]), shine)
        else:
            shine.default_value = tuple(a * c for a, c in zip((0.115, 0.095, 0.075), spec["color"])) + (1,)
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
    color = texture("color", False)
    tree.links.new(color, bsdf.inputs["Base Color"])
    if baked and static:
        tree.links.new(_baked(tree, color), shine)
    split = tree.nodes.new("ShaderNodeSeparateColor")
    tree.links.new(texture("orm", True), split.inputs[0])
    tree.links.new(split.outputs[1], bsdf.inputs["Roughness"])
    bump = tree.nodes.new("ShaderNodeNormalMap")
    bump.uv_map = "UVMap"
    tree.links.new(texture("normal", True), bump.inputs["Color"])
    tree.links.new(bump.outputs[0], bsdf.inputs["Normal"])
