# SPDX-License-Identifier: GPL-3.0-or-later
"""Gray cloths over the exhibits that are missing (Blender's cloth simulation), the banner and the mobile."""
import math

import bmesh
import bpy
import hall_plan as P
from hall_mesh import fillet, grid, lathe
from mathutils import Matrix, Vector, noise



def _collider(build, friction=25.0):
    bm = bmesh.new()
    build(bm)
    mesh = bpy.data.meshes.new("collider")
    bm.to_mesh(mesh)
    bm.free()
    obj = bpy.data.objects.new("collider", mesh)
    bpy.context.scene.collection.objects.link(obj)
    obj.modifiers.new("collision", "COLLISION")
    obj.collision.thickness_outer = 0.012
    obj.collision.cloth_friction = friction
    return obj


def _block(center, size, bevel=0.02):
    """Hall coordinates."""
    def build(bm):
        bmesh.ops.create_cube(bm, size=1)
        bmesh.ops.scale(bm, vec=(size[0], size[2], size[1]), verts=bm.verts)
        bmesh.ops.bevel(bm, geom=list(bm.edges), offset=bevel, segments=2, profile=0.5, affect="EDGES")
        bmesh.ops.translate(bm, vec=(center[0], -center[2], center[1]), verts=bm.verts)
        bmesh.ops.triangulate(bm, faces=bm.faces)
    return _collider(build)


def _desk():
    """The reading desk of hall_props, its foot at the origin."""
    def build(bm):
        outline = [(-0.21, 0.02), (0.21, 0.02), (0.21, 0.755), (-0.21, 0.915)]
        sides = [[bm.verts.new((x, -z, y)) for z, y in outline] for x in (-0.47, 0.47)]
        bm.faces.new(sides[0])
        bm.faces.new(sides[1][::-1])
        for k in range(4):
            n = (k + 1) % 4
            bm.faces.new((sides[0][k], sides[1][k], sides[1][n], sides[0][n]))
        bmesh.ops.recalc_face_normals(bm, faces=bm.faces)
        bmesh.ops.bevel(bm, geom=list(bm.edges), offset=0.02, segments=2, profile=0.5, affect="EDGES")
        bmesh.ops.triangulate(bm, faces=bm.faces)
    return _collider(build)


def _ball(center, r):
    def build(bm):
        bmesh.ops.create_uvsphere(bm, u_segments=32, v_segments=20, radius=r)
        bmesh.ops.translate(bm, vec=(center[0], -center[2], center[1]), verts=bm.verts)
    return _collider(build)


def _turned(profile, n=48):
    """Solid of revolution from (r, y), closed profile."""
    def build(bm):
        rings = [[bm.verts.new((r * math.cos(2 * math.pi * k / n), r * math.sin(2 * math.pi * k / n), y))
                  for k in range(n)] for r, y in profile]
        for a, b in zip(rings, rings[1:] + rings[:1]):
            for k in range(n):
                bm.faces.new((a[k], a[(k + 1) % n], b[(k + 1) % n], b[k]))
        bmesh.ops.recalc_face_normals(bm, faces=bm.faces)
    return _collider(build)


def _simulate(name, sheet, colliders, frames, faces, pin=None, stiff=12.0, bend=0.6):
    """sheet: (points in hall coordinates, rest uv, quads). Returns a mesh in hall coordinates, reduced to faces."""
    points, uvs, quads = sheet
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([(x, -z, y) for x, y, z in points], [], quads)
    layer = mesh.uv_layers.new(name="UVMap")
    for loop in mesh.loops:
        layer.data[loop.index].uv = uvs[loop.vertex_index]
    obj = bpy.data.objects.new(name, mesh)
    scene = bpy.context.scene
    scene.collection.objects.link(obj)
    mod = obj.modifiers.new("cloth", "CLOTH")
    s, c = mod.settings, mod.collision_settings
    s.quality, s.mass, s.air_damping = 7, 0.35, 2.0
    s.tension_stiffness = s.compression_stiffness = stiff
    s.shear_stiffness, s.bending_stiffness = stiff * 0.5, bend
    s.tension_damping = s.compression_damping = s.shear_damping = 8.0
    c.collision_quality, c.distance_min = 4, 0.012
    c.use_self_collision, c.self_distance_min = True, 0.010
    if pin:
        group = obj.vertex_groups.new(name="pin")
        group.add(pin, 1.0, "ADD")
        s.vertex_group_mass = "pin"
    scene.frame_start, scene.frame_end = 1, frames
    mod.point_cache.frame_start, mod.point_cache.frame_end = 1, frames
    for f in range(1, frames + 1):
        scene.frame_set(f)
    deps = bpy.context.evaluated_depsgraph_get()
    out = bpy.data.meshes.new_from_object(obj.evaluated_get(deps))
    bpy.data.objects.remove(obj)
    for col in colliders:
        bpy.data.objects.remove(col)
    # Smooth the facets, then keep only as many triangles as the folds need.
    obj = bpy.data.objects.new(name, out)
    scene.collection.objects.link(obj)
    tri = sum(len(p.vertices) - 2 for p in out.polygons)
    sub = obj.modifiers.new("smooth", "SMOOTH")
    sub.factor, sub.iterations = 0.35, 3
    dec = obj.modifiers.new("reduce", "DECIMATE")
    dec.ratio = min(1.0, faces / tri)
    deps = bpy.context.evaluated_depsgraph_get()
    final = bpy.data.meshes.new_from_object(obj.evaluated_get(deps))
    bpy.data.objects.remove(obj)
    final.name = name
    return final            # still in Blender's coordinates


def _sheet(w, d, n, center, wobble=0.004, yaw=0.0):
    """Horizontal square-celled sheet at center."""
    nx = max(2, int(n * w / max(w, d)))
    nz = max(2, int(n * d / max(w, d)))
    pts, uvs, quads = [], [], []
    c, s = math.cos(yaw), math.sin(yaw)
    for j in range(nz + 1):
        for i in range(nx + 1):
            u, v = w * (i / nx - 0.5), d * (j / nz - 0.5)
            h = wobble * noise.noise(Vector((u * 3, v * 3, center[1])))
            pts.append((center[0] + c * u + s * v, center[1] + h, center[2] - s * u + c * v))
            uvs.append((u, v))
    for j in range(nz):
        for i in range(nx):
            a = j * (nx + 1) + i
            quads.append((a, a + nx + 1, a + nx + 2, a + 1))
    return pts, uvs, quads


def _round(r, rings, n, height):
    """Round sheet: a center, then rings."""
    pts, uvs, quads = [(0.0, height, 0.0)], [(0.0, 0.0)], []
    for j in range(1, rings + 1):
        for i in range(n):
            a, q = 2 * math.pi * i / n, r * j / rings
            x, z = q * math.cos(a), q * math.sin(a)
            pts.append((x, height + 0.03 * noise.noise(Vector((x * 2, z * 2, 4.0))), z))
            uvs.append((x, z))
    for i in range(n):
        quads.append((0, 1 + (i + 1) % n, 1 + i))
    for j in range(rings - 1):
        for i in range(n):
            a, b = 1 + j * n + i, 1 + j * n + (i + 1) % n
            quads.append((a, b, b + n, a + n))
    return pts, uvs, quads


def drapes():
    """{node suffix: mesh}; origins are the exhibits' foot points (1..4) or the portal's center (5..9)."""
    out = {}
    out[1] = _simulate("cloth_1", _sheet(2.3, 2.3, 56, (0, 1.92, 0), yaw=0.35),
                       [_ball((0, 1.45, 0), 0.4), _block((0, 0.45, 0), (0.8, 0.9, 0.8))], 60, 2200)
    out[2] = _simulate("cloth_2", _sheet(1.7, 1.5, 52, (0, 1.66, 0), yaw=0.2),
                       [_block((0, 1.2, 0), (0.62, 0.78, 0.06)), _block((0, 0.45, -0.06), (0.05, 0.9, 0.05))], 60, 1500)
    r = P.PIT_R
    rim = [(r + 0.005, -0.2), (r + 0.02, 0.10), (r + 0.08, 0.165), (r + 0.14, 0.175), (r + 0.22, 0.16),
           (r + 0.285, 0.08), (r + 0.285, -0.2)]
    out[3] = _simulate("cloth_3", _round(2.30, 28, 96, 0.25),
                       [_turned(rim), _block((0, -0.25, 0), (8, 0.5, 8), 0.01)], 60, 2200, stiff=20)
    out[4] = _simulate("cloth_4", _sheet(1.65, 1.25, 52, (0, 1.0, 0), yaw=0.12),
                       [_desk()], 60, 1300)
    for k, surplus in ((5, 1.22), (6, 1.30)):
        out[k] = _curtain(f"cloth_{k}", surplus)
    return out


def _curtain(name, surplus):
    """Cloth pinned along the frame's head, falling in folds over the opening."""
    w, h, n, pins = P.NICHE_W + 0.30, P.NICHE_H + 0.26, 84, 7
    rows = int(n * h / (w * surplus))
    top = P.NICHE_H / 2 + 0.10
    pts, uvs, quads = [], [], []
    for j in range(rows + 1):
        for i in range(n + 1):
            t, y = i / n, top - h * j / rows
            phase = t * (pins - 1) * 2 * math.pi
            z = 0.15 + 0.055 * (1 - math.cos(phase)) + 0.02 * math.sin(phase * 0.5 + surplus * 9)
            sag = 0.02 * (1 - math.cos(phase)) / 2 if j == 0 else 0
            pts.append((w * (t - 0.5), y - sag, z))
            uvs.append((w * surplus * (t - 0.5), -h * j / rows))
    for j in range(rows):
        for i in range(n):
            a = j * (n + 1) + i
            quads.append((a, a + n + 1, a + n + 2, a + 1))
    pin = [round(n * k / (pins - 1)) + d for k in range(pins) for d in (-1, 0, 1)]
    pin = [p for p in pin if 0 <= p <= n]
    wall = [_block((0, 0, -0.2), (3.4, 3.4, 0.52), 0.02)]
    return _simulate(name, (pts, uvs, quads), wall, 50, 1300, pin=pin, bend=0.4)


def banner(m):
    """Hanging cloth 1.2 x 3 m with its pole; origin in the middle of the pole, faces +z."""
    w, h, nx, ny = 1.2, 3.0, 10, 16

    def point(i, j, back):
        u, v = i / nx - 0.5, j / ny
        fold = 0.05 * math.sin(u * 9.0 + v * 1.1) * v ** 0.7 + 0.03 * math.sin(u * 17 + 1.3 - v * 2.1) * v
        curl = 0.05 * v * v * math.cos(u * 5 + 0.6)
        z = fold + curl + (-0.003 if back else 0.003)
        return (w * u * (1 - 0.03 * v), -0.03 - h * v + 0.05 * (abs(u * 2) - 0.5) * v ** 6, z)
    for back in (False, True):
        rows = [[point(i, j, back) for j in range(ny, -1, -1)] for i in range(nx + 1)]
        grid(m, rows, "banner", flip=back)
    rim = [(i, 0) for i in range(nx + 1)] + [(nx, j) for j in range(1, ny + 1)] + \
        [(i, ny) for i in range(nx - 1, -1, -1)] + [(0, j) for j in range(ny - 1, 0, -1)]
    grid(m, [[point(i, j, True), point(i, j, False)] for i, j in rim], "banner", close_i=True)
    turn = Matrix.Rotation(math.pi / 2, 4, "Z")
    lathe(m, fillet([(0.0, -0.70), (0.030, -0.69, 0.01), (0.030, -0.65, 0.008), (0.017, -0.64), (0.017, 0.64),
                     (0.030, 0.65, 0.008), (0.030, 0.69, 0.01), (0.0, 0.70)], 2), "brass", segments=14, matrix=turn)
    for x in (-0.5, 0.5):
        lathe(m, [(0.004, 0.0), (0.004, 3.16)], "brass", center=(x, 0, 0), segments=5)


def mobile(m):
    """Balanced arms with leaves, hanging from the pivot at the origin; a wire goes up to the vault."""
    lathe(m, [(0.0035, 0.0), (0.0035, 3.95)], "brass", segments=5)

    def arm(origin, yaw, left, right, rise, wire):
        """Curved rod from -left to +right along its own x, hanging from origin by a wire."""
        ox, oy, oz = origin
        oy -= wire
        lathe(m, [(0.003, 0.0), (0.003, wire)], "brass", center=(ox, oy, oz), segments=5)
        c, s = math.cos(yaw), math.sin(yaw)
        n, ring = 12, 5
        rows, ends = [], []
        for k in range(n + 1):
            t = k / n
            x = -left + (left + right) * t
            y = rise * (1 - (2 * t - 1) ** 2) - rise * (1 - (2 * left / (left + right) - 1) ** 2)
            px, pz = ox + c * x, oz - s * x
            rows.append([(px - s * 0.006 * math.cos(2 * math.pi * q / ring), oy + y + 0.006 * math.sin(2 * math.pi * q / ring),
                          pz - c * 0.006 * math.cos(2 * math.pi * q / ring)) for q in range(ring + 1)])
            ends.append((px, oy + y, pz))
        grid(m, rows, "brass", flip=True)
        return ends[0], ends[-1]

    def leaf(at, size, yaw, drop):
        x, y, z = at
        y -= drop
        lathe(m, [(0.0025, 0.0), (0.0025, drop)], "brass", center=(x, y, z), segments=5)
        n, prof = 13, []
        for k in range(n):
            a = 2 * math.pi * k / n
            r = size * (0.62 + 0.30 * math.cos(a) ** 2 * (1.15 if math.cos(a) > 0 else 0.8))
            prof.append((r * math.sin(a) * 0.62, -size * 0.86 + r * math.cos(a)))
        turn = Matrix.Translation((x, y, z)) @ Matrix.Rotation(yaw, 4, "Y")
        rows = []
        for (a, b), (ca, cb) in zip(prof + prof[:1], [(0, -size * 0.86)] * (n + 1)):
            bow = lambda q: 0.10 * size * (1 - q * q)
            rows.append([turn @ Vector((ca + (a - ca) * q, cb + (b - cb) * q, bow(q) + t)) for q, t in
                         ((0.0, 0.004), (0.6, 0.004), (1.0, 0.0), (0.6, -0.004), (0.0, -0.004))])
        grid(m, rows, "brass")

    a, b = arm((0, 0, 0), 0.5, 0.62, 0.95, 0.10, 0.22)
    leaf(a, 0.24, 0.9, 0.10)
    c, d = arm(b, 1.7, 0.42, 0.62, 0.08, 0.26)
    leaf(d, 0.19, 2.4, 0.08)
    e, f = arm(c, -0.4, 0.28, 0.46, 0.06, 0.30)
    leaf(e, 0.17, 0.2, 0.07)
    g, h = arm(f, 1.1, 0.20, 0.33, 0.04, 0.22)
    leaf(g, 0.14, 1.5, 0.05)
    leaf(h, 0.11, 2.9, 0.05)
