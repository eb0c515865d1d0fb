# SPDX-License-Identifier: GPL-3.0-or-later
"""Preview renders of the hall with Cycles."""
import math
import os

import bpy
from hall_bake import cycles, portals, sun_light, to_blender, world
from hall_materials import MATERIALS


def preview(path, eye, look, samples, clay=False, size=(1280, 720), sun=20.0):
    folder = os.path.dirname(os.path.abspath(__file__))
    for mat in bpy.data.materials:
        if clay:
            _clay(mat)
        else:
            _glossy(mat, folder)
    for o in bpy.data.objects:
        if o.name.startswith("cloth_"):
            o.hide_render = o.name not in ("cloth_1", "cloth_3", "cloth_6", "cloth_4")
    cycles(samples, 6)
    scene = bpy.context.scene
    scene.cycles.use_denoising = False
    scene.cycles.caustics_reflective = False
    scene.cycles.sample_clamp_indirect = 10
    world(1.0)
    portals()
    sun_light(10, 20, sun, (1, 0.75, 0.5))
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
