"""Reads files that the program wrote with readers of other projects, and compares what they find with what is true.

outside_readers.py exr FILE        OpenImageIO: matrices, channels and Cryptomatte agree with one another.
outside_readers.py equal A B       Pillow: two pictures have the same pixels.
outside_readers.py size FILE W H   Pillow: the size of a picture, - for standard input.
outside_readers.py schema SCHEMA FILE...
                                   jsonschema: each file is valid, and not once its values are of another type.
outside_readers.py document SCHEMA FILE
                                   jsonschema: the file is valid, and not without any one of its keys.
outside_readers.py tiles WHOLE JSON   Pillow: the tiles that the JSON lists are parts of the whole, and neighbors share 3 mm.
outside_readers.py text FILE KEY     Pillow: prints a text of a PNG.
outside_readers.py 3mf FILE N      zipfile, ElementTree and, if it is here, lib3mf: N triangles, millimeters, colors.
outside_readers.py handout FOLDER SHADER
                                   html.parser, ElementTree and Pillow: both pages of a handout have well-formed formulas, the
                                   pictures that they show, links to the web, a list, and code of this shader.

Exit 77: the reader is not here."""

import ctypes
import json
import os
import struct
import sys
import zipfile
from xml.etree import ElementTree


def skip(what):
    print("skipped:", what, "is not here")
    sys.exit(77)


def murmur_hash(name):
    """MurmurHash3 of 32 bits with seed 0, block by block as its author describes it."""
    mask, hash = 0xFFFFFFFF, 0

    def rotated(x, bits):
        return (x << bits | x >> (32 - bits)) & mask

    for at in range(0, len(name), 4):
        block = int.from_bytes(name[at:at + 4], "little")
        hash ^= rotated(block * 0xCC9E2D51 & mask, 15) * 0x1B873593 & mask
        if at + 4 <= len(name):
            hash = (rotated(hash, 13) * 5 + 0xE6546B64) & mask
    hash ^= len(name)
    for shift, factor in ((16, 0x85EBCA6B), (13, 0xC2B2AE35), (16, 1)):
        hash = (hash ^ hash >> shift) * factor & mask
    # The exponent of a float that is neither infinite nor too small to be normal.
    exponent = min(max(hash >> 23 & 255, 1), 254)
    return hash & 0x807FFFFF | exponent << 23


assert murmur_hash(b"hello") == 0x248BFA47, "the published value"


def exr(name):
    try:
        import OpenImageIO
        import numpy
    except ImportError:
        skip("python3-openimageio")
    file = OpenImageIO.ImageInput.open(name)
    spec = file.spec()
    pixels = file.read_image("float")
    channel = {name: i for i, name in enumerate(spec.channelnames)}

    def matrix(*names):
        found = [each.value for each in spec.extra_attribs if each.name.lower() in names]
        assert found, names[0] + " is missing"
        return numpy.array(found[0], dtype=float).reshape(4, 4)

    # Some versions of OpenImageIO have a name of their own for worldToNDC.
    to_camera, to_ndc = matrix("worldtocamera"), matrix("worldtondc", "worldtoscreen")
    primaries = spec.getattribute("chromaticities")
    assert numpy.allclose(primaries, [0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329], atol=1e-5), primaries
    manifest = {}
    for each in spec.extra_attribs:
        if each.name.startswith("cryptomatte/") and each.name.endswith("/manifest"):
            manifest = json.loads(each.value)
    ids = {name: struct.unpack(">f", bytes.fromhex(code))[0] for name, code in manifest.items()}
    assert len(set(ids.values())) == len(ids) > 2, "every object has its own number"
    assert all(int(code, 16) == murmur_hash(name.encode()) for name, code in manifest.items())
    seen = set()
    hits = 0
    for y in range(spec.height):
        for x in range(spec.width):
            pixel = pixels[y][x]
            depth = pixel[channel["depth.Z"]]
            number, coverage = pixel[channel["CryptoObject00.R"]], pixel[channel["CryptoObject00.G"]]
            if not numpy.isfinite(depth):
                assert number == 0 and coverage == 0
                continue
            hits += 1
            world = numpy.array([pixel[channel["position." + axis]] for axis in "XYZ"] + [1.0], dtype=float)
            camera, ndc = world @ to_camera, world @ to_ndc
            assert abs(camera[2] - depth) < 1e-4 * depth, "Z is the distance along the view axis"
            at = ndc[:2] / ndc[3]
            truth = numpy.array([(x + 0.5) / spec.width, (y + 0.5) / spec.height])
            assert numpy.abs(at - truth).max() < 1e-4, (x, y, at, truth)
            assert coverage == 1
            names = [name for name, id in ids.items() if id == number]
            assert len(names) == 1, number
            seen.add(names[0])
            if names[0] == "sdf_morph":
                albedo = [pixel[channel["albedo." + c]] for c in "RGB"]
                assert numpy.allclose(albedo, [0.8, 0.4, 0.2], atol=1e-3), albedo
    print(spec.width, "x", spec.height, "pixels,", hits, "with a surface, of", ", ".join(sorted(seen)))
    assert {"hall", "sdf_morph"} <= seen, seen


def motion(before, now):
    """The motion vectors of a frame, by the matrices and positions that the two files hold."""
    try:
        import OpenImageIO
        import numpy
    except ImportError:
        skip("python3-openimageio")
    frames = []
    for name in (before, now):
        file = OpenImageIO.ImageInput.open(name)
        spec = file.spec()
        ndc = [each.value for each in spec.extra_attribs if each.name.lower() in ("worldtondc", "worldtoscreen")]
        frames.append((spec, numpy.array(ndc[0], dtype=float).reshape(4, 4), file.read_image("float")))
    spec, _, pixels = frames[1]
    channel = {name: i for i, name in enumerate(spec.channelnames)}
    stated = spec.getattribute("vitrine:backward")
    assert "0.25 s" in stated and "v up" in stated, stated
    size = numpy.array([spec.width, spec.height])
    largest = 0
    for y in range(spec.height):
        for x in range(spec.width):
            pixel = pixels[y][x]
            if not numpy.isfinite(pixel[channel["depth.Z"]]):
                continue
            world = numpy.array([pixel[channel["position." + axis]] for axis in "XYZ"] + [1.0], dtype=float)
            was = world @ frames[0][1]
            moved = was[:2] / was[3] * size - [x + 0.5, y + 0.5]
            vector = numpy.array([pixel[channel["backward.u"]], -pixel[channel["backward.v"]]])
            assert numpy.abs(vector - moved).max() < 0.02, (x, y, vector, moved)
            largest = max(largest, numpy.abs(moved).max())
    print("motion of up to", round(largest, 1), "pixels")
    assert largest > 1


def pdf(picture, name):
    """Writes a picture as a PDF of another program."""
    pillow().open(picture).convert("RGB").save(name)


def pillow():
    try:
        from PIL import Image
    except ImportError:
        skip("Pillow")
    return Image


def equal(first, second):
    image = pillow()
    a, b = image.open(first).convert("RGBA"), image.open(second).convert("RGBA")
    assert a.size == b.size, (a.size, b.size)
    # Transparent pixels may have any color.
    for p, q in zip(a.getdata(), b.getdata()):
        assert p == q or (p[3] == 0 and q[3] == 0), (p, q)


def size(name, width, height):
    image = pillow().open(sys.stdin.buffer if name == "-" else name)
    image.load()
    assert image.size == (int(width), int(height)), image.size


def with_lib3mf(name):
    """Returns vertices and triangles as lib3mf counts them; None if it is not here."""
    try:
        library = ctypes.CDLL("lib3MF.so.1")
    except OSError:
        return None
    handle, count, more = ctypes.c_void_p, ctypes.c_uint32, ctypes.c_int
    model, reader, objects, mesh = handle(), handle(), handle(), handle()
    vertices, triangles, there = count(), count(), more()
    assert library.lib3mf_createmodel(ctypes.byref(model)) == 0
    assert library.lib3mf_model_queryreader(model, b"3mf", ctypes.byref(reader)) == 0
    assert library.lib3mf_reader_readfromfileutf8(reader, name.encode()) == 0, "lib3mf cannot read it"
    assert library.lib3mf_model_getmeshobjects(model, ctypes.byref(objects)) == 0
    assert library.lib3mf_resourceiterator_movenext(objects, ctypes.byref(there)) == 0 and there.value
    assert library.lib3mf_resourceiterator_getcurrent(objects, ctypes.byref(mesh)) == 0
    assert library.lib3mf_meshobject_getvertexcount(mesh, ctypes.byref(vertices)) == 0
    assert library.lib3mf_meshobject_gettrianglecount(mesh, ctypes.byref(triangles)) == 0
    return vertices.value, triangles.value


def three_mf(name, triangles):
    with zipfile.ZipFile(name) as archive:
        assert archive.testzip() is None
        names = set(archive.namelist())
        assert {"[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"} == names, names
        for each in names:
            ElementTree.fromstring(archive.read(each))
        model = ElementTree.fromstring(archive.read("3D/3dmodel.model"))
    core = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
    material = "{http://schemas.microsoft.com/3dmanufacturing/material/2015/02}"
    assert model.get("unit") == "millimeter"
    vertices = [tuple(float(v.get(axis)) for axis in "xyz") for v in model.iter(core + "vertex")]
    faces = list(model.iter(core + "triangle"))
    colors = [c.get("color") for c in model.iter(material + "color")]
    assert len(faces) == int(triangles), len(faces)
    edges = {}
    for face in faces:
        corners = [int(face.get(v)) for v in ("v1", "v2", "v3")]
        assert max(corners) < len(vertices)
        assert all(int(face.get(p)) < len(colors) for p in ("p1", "p2", "p3"))
        for i in range(3):
            edge = (corners[i], corners[(i + 1) % 3])
            assert edge not in edges, "every edge has one triangle on each side"
            edges[edge] = True
    assert all((b, a) in edges for a, b in edges), "the mesh is closed"
    extent = [max(v[i] for v in vertices) - min(v[i] for v in vertices) for i in range(3)]
    low = [min(v[i] for v in vertices) for i in range(3)]
    item = next(model.iter(core + "item"))
    moved = [float(x) for x in item.get("transform").split()][9:]
    assert all(abs(low[i] + moved[i]) < 1e-3 for i in range(3)), "the object stands on the plate"
    # Balls with radii of 20 and 10 cm, the small one 50 cm above the large one, and z is up.
    assert all(abs(e - t) < 10 for e, t in zip(extent, (400, 400, 800))), extent
    assert set(colors) == {"#FF0000FF", "#00FF00FF"}, colors
    found = with_lib3mf(name)
    if found:
        assert found == (len(vertices), len(faces)), found
        print("lib3mf reads", found[0], "vertices and", found[1], "triangles")
    else:
        print("skipped: lib3mf is not here")


def text(name, key):
    image = pillow().open(name)
    image.load()
    print(image.text[key])


def schema(name, *files):
    try:
        import jsonschema
    except ImportError:
        skip("python3-jsonschema")
    with open(name) as file:
        described = json.load(file)
    jsonschema.Draft202012Validator.check_schema(described)
    validator = jsonschema.Draft202012Validator(described)
    for each in files:
        with open(each) as file:
            read = json.load(file)
        validator.validate(read)
        for key in read["values"]:
            read["values"][key] = {"no": "value"}
            assert not validator.is_valid(read), (each, key)


def tiles(whole, description):
    image = pillow().open(whole)
    with open(description) as file:
        listed = json.load(file)["report"]["tiles"]
    assert len(listed) > 2, listed
    end = 0
    for number, tile in enumerate(listed):
        left, right = tile["columns"]
        assert left + tile["repeatedColumns"] == end, (end, tile)
        assert number == 0 or 3 <= tile["overlap"] < 3 + 25.4 / 40 * 1.1, tile
        part = pillow().open(os.path.join(os.path.dirname(description), tile["file"]))
        assert part.size == (right - left, image.height), (part.size, tile)
        assert part.tobytes() == image.crop((left, 0, right, image.height)).tobytes(), tile
        end = right
    assert end == image.width, (end, image.width)
    print(len(listed), "tiles of", image.width, "columns")


def document(name, file):
    try:
        import jsonschema
    except ImportError:
        skip("python3-jsonschema")
    with open(name) as each:
        described = json.load(each)
    jsonschema.Draft202012Validator.check_schema(described)
    validator = jsonschema.Draft202012Validator(described)
    with open(file) as each:
        read = json.load(each)
    validator.validate(read)
    for key in read:
        without = {other: value for other, value in read.items() if other != key}
        assert not validator.is_valid(without), key
        assert not validator.is_valid({**read, key: {"no": ["value"]}}), key


def handout(folder, shader):
    from html.parser import HTMLParser

    class Page(HTMLParser):
        """Collects elements, and checks that each end tag closes the last element that is open."""

        def __init__(self):
            super().__init__()
            self.open, self.found, self.formulas, self.code = [], [], [], ""

        def handle_starttag(self, tag, attributes):
            self.found.append((tag, dict(attributes)))
            if tag == "math":
                self.formulas.append("")
            if "math" in self.open or tag == "math":
                self.formulas[-1] += self.get_starttag_text()
            if tag not in ("img", "meta", "br", "hr"):
                self.open.append(tag)

        def handle_endtag(self, tag):
            assert self.open and self.open[-1] == tag, (tag, self.open, self.getpos())
            if "math" in self.open:
                self.formulas[-1] += f"</{tag}>"
            self.open.pop()

        def handle_data(self, data):
            if "math" in self.open:
                self.formulas[-1] += data.replace("&", "&amp;").replace("<", "&lt;")
            if "pre" in self.open:
                self.code += data

    with open(shader) as each:
        library = each.read()
    for name in ("handout.html", "slides.html"):
        page = Page()
        with open(os.path.join(folder, name)) as each:
            page.feed(each.read())
        page.close()
        assert not page.open, page.open
        assert len(page.formulas) >= 5, page.formulas
        for formula in page.formulas:
            root = ElementTree.fromstring(formula)
            known = {"math", "mrow", "mi", "mo", "mn", "mtext", "msub", "msup", "msubsup", "mfrac", "msqrt", "mspace"}
            assert root.tag == "math" and {each.tag for each in root.iter()} <= known, formula
            for each in root.iter():
                children = {"mfrac": 2, "msub": 2, "msup": 2, "msubsup": 3}.get(each.tag, len(each))
                assert len(each) == children, formula
        shown = [attributes["src"] for tag, attributes in page.found if tag == "img"]
        assert any("/lesson-" in each for each in shown), shown
        for each in shown:
            pillow().open(os.path.join(folder, each)).load()
        links = [attributes["href"] for tag, attributes in page.found if tag == "a"]
        assert links and all(each.startswith("https://") for each in links), links
        assert any(tag == "li" for tag, _ in page.found)
        assert page.code.strip() and page.code.strip() in library, page.code
    print("both pages of the handout")


if __name__ == "__main__":
    {"exr": exr, "motion": motion, "pdf": pdf, "equal": equal, "size": size, "3mf": three_mf, "schema": schema,
     "text": text, "document": document, "tiles": tiles, "handout": handout}[sys.argv[1]](*sys.argv[2:])
