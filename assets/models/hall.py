# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes hall.glb: blender -b --factory-startup -noaudio -P hall.py -- [--no-cloth] [--bake] [--preview FILE]

  --no-cloth        leave the simulated cloths out (quicker)
  --bake [SAMPLES]  also bake the sky's lightmap hall_light_sky.png and hall_light.json
  --only NAME       bake only this one
  --preview FILE    render the hall from its entrance, or from --eye x,y,z towards --look x,y,z
  --mode MODE       of that render: baked (default, shows the lightmaps), traced, or clay (shape, back faces red)
"""
import argparse
import os
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
sys.dont_write_bytecode = True

import bmesh                   # noqa: E402
import bpy                     # noqa: E402
import hall_atlas              # noqa: E402
import hall_blocks             # noqa: E402
import hall_cloth              # noqa: E402
import hall_fittings           # noqa: E402
import hall_plan as P          # noqa: E402
import hall_props              # noqa: E402
import hall_shell              # noqa: E402
import hall_vault              # noqa: E402
from hall_materials import MATERIALS  # noqa: E402
from hall_mesh import Mesh     # noqa: E402
from mathutils import Matrix   # noqa: E402

TO_BLENDER = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))


def material(name):
    mat = bpy.data.materials.get(name)
    if mat is None:
        mat = bpy.data.materials.new(name)
        mat.use_nodes = True
        spec = MATERIALS[name]
        node = mat.node_tree.nodes["Principled BSDF"]
        node.inputs["Base Color"].default_value = (*spec["color"], 1)
        node.inputs["Roughness"].default_value = spec["roughness"]
        node.inputs["Metallic"].default_value = spec["metalness"]
        mat.use_backface_culling = name != "cloth"
    return mat


def to_object(name, mesh, faces, atlas=None, matrix=None):
    """Blender object out of faces of a Mesh (hall coordinates)."""
    names = sorted({f[1] for f in faces})
    used = sorted({i for f in faces for i in f[0]})
    index = {old: new for new, old in enumerate(used)}
    data = bpy.data.meshes.new(name)
    data.from_pydata([(mesh.verts[i][0], -mesh.verts[i][2], mesh.verts[i][1]) for i in used], [],
                     [[index[i] for i in f[0]] for f in faces])
    uv0 = data.uv_layers.new(name="UVMap")
    uv1 = data.uv_layers.new(name="Lightmap") if atlas else None
    for poly, f in zip(data.polygons, faces):
        poly.use_smooth = True
        poly.material_index = names.index(f[1])
        for k, loop in enumerate(poly.loop_indices):
            uv0.data[loop].uv = f[2][k]
            if atlas:
                uv1.data[loop].uv = hall_atlas.coordinate(atlas[f[3]], f[4][k])
    for n in names:
        data.materials.append(material(n))
    finish(data)
    obj = bpy.data.objects.new(name, data)
    if matrix is not None:
        obj.matrix_world = TO_BLENDER @ matrix @ TO_BLENDER.inverted()
    bpy.context.scene.collection.objects.link(obj)
    mod = obj.modifiers.new("normals", "WEIGHTED_NORMAL")
    mod.keep_sharp = True
    return obj


def finish(data):
    """Weld, and shade smooth up to 50 degrees."""
    bm = bmesh.new()
    bm.from_mesh(data)
    bmesh.ops.remove_doubles(bm, verts=bm.verts, dist=2e-4)
    bmesh.ops.dissolve_degenerate(bm, edges=bm.edges, dist=1e-5)
    bm.to_mesh(data)
    bm.free()
    data.use_auto_smooth = True
    data.auto_smooth_angle = 0.87


def empty(name, matrix):
    obj = bpy.data.objects.new(name, None)
    obj.matrix_world = TO_BLENDER @ matrix @ TO_BLENDER.inverted()
    bpy.context.scene.collection.objects.link(obj)


def build(cloth):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    drapes = hall_cloth.drapes() if cloth else {}
    mesh, nodes = Mesh(), hall_props.Nodes()
    hall_shell.build(mesh)
    hall_vault.build(mesh)
    hall_fittings.build(mesh)
    hall_props.build(mesh, nodes)
    hall_blocks.build(nodes)
    atlas, scale = hall_atlas.pack(mesh)
    print(f"lightmap: {len(atlas)} charts, {scale:.2f} texels per meter at density 1")
    static = [to_object("hall_" + n, mesh, [f for f in mesh.faces if f[1] == n], atlas)
              for n in MATERIALS if any(f[1] == n for f in mesh.faces)]
    for name, matrix in nodes.items:
        empty(name, matrix)
    places = dict(nodes.items)
    shift = Matrix.Translation
    for name, make, matrix in (
            ("stand_2", hall_props.stand, places["place_2"] @ shift((0, -1.2, 0))),
            ("stand_4_banner", hall_cloth.banner, shift((-1.6, 6.03, -6.5))),
            ("hanging_4", hall_cloth.mobile, shift((1.3, 5.2, -6.0)))):
        part = Mesh()
        make(part)
        to_object(name, part, part.faces, matrix=matrix)
    foot = {1: shift((0, 0, 0)), 2: places["place_2"] @ shift((0, -1.2, 0)),
            3: shift((P.PIT[0], 0, P.PIT[1])), 4: shift((0, 0, -8.5))}
    for n in range(1, 10):
        data = drapes.get(n) or drapes.get(5 + n % 2)
        if data is None:
            continue
        if not data.materials:
            data.materials.append(material("cloth"))
            for poly in data.polygons:
                poly.use_smooth = True
        obj = bpy.data.objects.new(f"cloth_{n}", data)
        obj.matrix_world = TO_BLENDER @ (foot.get(n) or places[f"place_{n}"]) @ TO_BLENDER.inverted()
        bpy.context.scene.collection.objects.link(obj)
    return static


def report():
    deps = bpy.context.evaluated_depsgraph_get()
    total, seen = 0, set()
    for obj in sorted(bpy.data.objects, key=lambda o: o.name):
        if obj.type == "MESH":
            data = obj.evaluated_get(deps).data
            tris = sum(len(p.vertices) - 2 for p in data.polygons)
            total += 0 if obj.data.name in seen else tris
            seen.add(obj.data.name)
            print(f"  {obj.name}: {tris} triangles")
    print(f"  stored in all: {total} triangles")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--no-cloth", action="store_true")
    parser.add_argument("--no-export", action="store_true")
    parser.add_argument("--bake", nargs="?", const=192, type=int)
    parser.add_argument("--only")
    parser.add_argument("--preview")
    parser.add_argument("--eye", default="0,1.65,10.5")
    parser.add_argument("--look", default="0,1.9,-12")
    parser.add_argument("--mode", default="baked", choices=("clay", "baked", "traced"))
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--samples", type=int, default=96)
    parser.add_argument("--out", default=os.path.join(HERE, "hall.glb"))
    args = parser.parse_args(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else [])
    start = time.time()
    static = build(not args.no_cloth)
    report()
    if not args.no_export:
        bpy.ops.export_scene.gltf(filepath=args.out, export_format="GLB", export_apply=True, export_yup=True,
                                  export_image_format="NONE", export_colors=False, export_animations=False,
                                  export_cameras=False, export_lights=False, export_tangents=False)
        print(f"{args.out}: {os.path.getsize(args.out) / 1e6:.2f} MB after {time.time() - start:.0f} s")
    if args.bake:
        import hall_bake
        hall_bake.bake(static, HERE, args.bake, args.only)
    if args.preview:
        import hall_preview
        number = lambda text: [float(c) for c in text.split(",")]
        hall_preview.preview(args.preview, number(args.eye), number(args.look), args.samples, args.mode,
                             [int(c) for c in args.size.split("x")])


main()
