#!/usr/bin/env python3
"""Writes the corpora: small valid files (seeds of the fuzzer) and bad-* ones that every command must refuse.

usage: tests/corpora/make.py   (writes beside itself; files that a fuzzer found are not made here and stay)
"""
import base64
import gzip
import json
import pathlib
import random
import struct
import zlib

HERE = pathlib.Path(__file__).parent
NAN, INF = float("nan"), float("inf")


def write(name, content):
    path = HERE / name
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(content if isinstance(content, bytes) else content.encode())


def data_uri(content, kind="application/octet-stream"):
    return f"data:{kind};base64," + base64.b64encode(content).decode()


def floats(*numbers):
    return struct.pack(f"<{len(numbers)}f", *numbers)


# Images ------------------------------------------------------------------------------------------------------------
def png(width, height, rows):
    chunk = lambda kind, d: struct.pack(">I", len(d)) + kind + d + struct.pack(">I", zlib.crc32(kind + d))
    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")


def pfm(width, height, numbers):
    return f"PF\n{width} {height}\n-1.0\n".encode() + floats(*numbers)


def hdr(width, height, pixels):
    return f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n".encode() + pixels


def tiff(width, height, pixels, count=None):
    entries = [(256, 4, 1, width), (257, 4, 1, height), (258, 3, 1, 8), (259, 3, 1, 1), (262, 3, 1, 1), (273, 4, 1, 8),
               (277, 3, 1, 1), (278, 4, 1, height), (279, 4, 1, len(pixels) if count is None else count)]
    pad = (-len(pixels)) % 2
    directory = struct.pack("<H", len(entries)) + b"".join(struct.pack("<HHII", *e) for e in entries) + bytes(4)
    return b"II*\0" + struct.pack("<I", 8 + len(pixels) + pad) + pixels + bytes(pad) + directory


def float_tiff(width, height, numbers):
    """One row of tags more than tiff(): 32 bits of floating point."""
    pixels = floats(*numbers)
    entries = [(256, 4, 1, width), (257, 4, 1, height), (258, 3, 1, 32), (259, 3, 1, 1), (262, 3, 1, 1), (273, 4, 1, 8),
               (277, 3, 1, 1), (278, 4, 1, height), (279, 4, 1, len(pixels)), (339, 3, 1, 3)]
    directory = struct.pack("<H", len(entries)) + b"".join(struct.pack("<HHII", *e) for e in entries) + bytes(4)
    return b"II*\0" + struct.pack("<I", 8 + len(pixels)) + pixels + directory


def exr(width, height, pixels, lying_width=None, display=None, channels="BGR", sampling=1, more=()):
    """Uncompressed floats. With a `sampling` above 1: luminance, and chroma at every so-many-th pixel."""
    string = lambda s: s.encode() + b"\0"
    attribute = lambda n, t, v: string(n) + string(t) + struct.pack("<i", len(v)) + v
    names = ["BY", "RY", "Y"] if sampling > 1 else list(channels)
    of = lambda c: sampling if len(c) == 2 else 1
    listed = b"".join(string(c) + struct.pack("<iB3xii", 2, 0, of(c), of(c)) for c in names) + b"\0"
    box = struct.pack("<4i", 0, 0, (lying_width or width) - 1, height - 1)
    head = (struct.pack("<II", 20000630, 2) + attribute("channels", "chlist", listed) + b"".join(attribute(*m) for m in more) +
            attribute("compression", "compression", b"\0") + attribute("dataWindow", "box2i", box) +
            attribute("displayWindow", "box2i", struct.pack("<4i", *display) if display else box) +
            attribute("lineOrder", "lineOrder", b"\0") + attribute("pixelAspectRatio", "float", floats(1)) +
            attribute("screenWindowCenter", "v2f", floats(0, 0)) + attribute("screenWindowWidth", "float", floats(1)) + b"\0")
    lines, used = [], 0
    for y in range(height):
        count = sum(width // of(c) for c in names if y % of(c) == 0)
        lines.append(struct.pack("<ii", y, 4 * count) + floats(*pixels[used:used + count]))
        used += count
    offsets, at = [], len(head) + 8 * height
    for line in lines:
        offsets.append(at)
        at += len(line)
    return head + struct.pack(f"<{height}Q", *offsets) + b"".join(lines)


def exif(orientation):
    """1/125 s in the Exif directory."""
    first = struct.pack("<H", 2) + struct.pack("<HHII", 274, 3, 1, orientation) + struct.pack("<HHII", 34665, 4, 1, 38) + bytes(4)
    return b"II*\0" + struct.pack("<I", 8) + first + struct.pack("<HHHII", 1, 33434, 5, 1, 56) + bytes(4) + struct.pack("<II", 1, 125)


def with_chunks(image, *chunks):
    """A PNG with more chunks behind its header."""
    chunk = lambda kind, d: struct.pack(">I", len(d)) + kind + d + struct.pack(">I", zlib.crc32(kind + d))
    return image[:33] + b"".join(chunk(*c) for c in chunks) + image[33:]


PNG = png(2, 2, b"\0" + bytes([255, 0, 0, 255, 0, 255, 0, 255]) + b"\0" + bytes([0, 0, 255, 255, 255, 255, 255, 128]))
WEBP = base64.b64decode("UklGRjAAAABXRUJQVlA4TCMAAAAvAUAAEB8gEEjeHzqN+RcQFPwfnYCg6LrlImYPwg0YIvofAgA=")
EXR = exr(2, 2, [1.0] * 12)


def images():
    write("image/good.png", PNG)
    write("image/good.webp", WEBP)
    write("image/good.exr", EXR)
    write("image/good.pfm", pfm(2, 2, [1] * 12))
    write("image/good.hdr", hdr(2, 2, bytes([128, 128, 128, 129]) * 4))
    write("image/good.tif", tiff(2, 2, b"abcd"))
    write("image/good-float.tif", float_tiff(2, 2, [1, 0.5, -2, 1e9]))
    write("image/good-chroma.exr", exr(4, 4, [0.5] * 24, sampling=2))
    write("image/good-windows.exr", exr(2, 2, [1.0] * 12, display=(-3, -2, 4, 5), more=[
        ("chromaticities", "chromaticities", floats(1, 0, 0, 1, 0, 0, 1 / 3, 1 / 3)), ("timeCode", "timecode", bytes(8)),
        ("multiView", "stringvector", struct.pack("<i", 4) + b"left"), ("own", "ownType", b"abc")]))
    write("image/good-alpha.pfm", b"PF4\n1 1\n2.0\n" + struct.pack(">4f", 1, 0.5, 0, 0.5))
    write("image/good-header.hdr", hdr(2, 2, bytes([128, 128, 128, 129]) * 4).replace(
        b"FORMAT=32-bit_rle_rgbe", b"EXPOSURE=2\nCOLORCORR=1 2 1\nPIXASPECT=2\nGAMMA=2.2\nVIEW= -vtv\n"
        b"PRIMARIES=.64 .33 .29 .6 .15 .06 .333 .333\nFORMAT=32-bit_rle_xyze").replace(b"-Y 2 +X 2", b"+X 2 -Y 2"))
    write("image/good-notes.png", with_chunks(PNG, (b"gAMA", struct.pack(">I", 50000)), (b"cHRM", struct.pack(
        ">8I", 31270, 32900, 68000, 32000, 26500, 69000, 15000, 6000)), (b"tEXt", b"Comment\0hello"), (b"eXIf", exif(6))))
    write("image/bad-display.exr", exr(2, 2, [1.0] * 12, display=(-2000000000, 0, 2000000000, 1)))
    write("image/bad-empty-display.exr", exr(2, 2, [1.0] * 12, display=(5, 5, 2, 2)))
    write("image/bad-chromaticities.exr", exr(2, 2, [1.0] * 12, more=[("chromaticities", "chromaticities", floats(*[0] * 8))]))
    write("image/bad-primaries.hdr", hdr(2, 2, bytes(16)).replace(b"FORMAT", b"PRIMARIES=0 0 0 0 0 0 0 0\nFORMAT"))
    write("image/bad-correction.hdr", hdr(2, 2, bytes(16)).replace(b"FORMAT", b"COLORCORR=1 nan 1\nFORMAT"))
    write("image/bad-scale.pfm", pfm(1, 1, [1] * 3).replace(b"-1.0", b"0"))
    write("image/bad-empty.png", b"")
    write("image/bad-unknown.png", b"no image at all")
    write("image/bad-cut.png", PNG[:-30])
    write("image/bad-sum.png", PNG[:45] + b"\xff" + PNG[46:])
    write("image/bad-size-lies.png", png(30000, 30000, b"\0" * 100))
    write("image/bad-no-size.png", png(0, 2, b"\0"))
    write("image/bad-chunk-size.png", PNG[:33] + struct.pack(">I", 1879048205) + b"tEXt" + bytes(20))
    write("image/bad-cut.webp", WEBP[:40])
    write("image/bad-cut.exr", EXR[:-20])
    write("image/bad-header.exr", EXR[:60])
    write("image/bad-size-lies.exr", exr(2, 2, [1.0] * 12, lying_width=2000000000))
    write("image/bad-nan.exr", exr(2, 2, [1.0] * 5 + [NAN] + [1.0] * 6))
    write("image/bad-inf.pfm", pfm(2, 2, [1] * 8 + [INF] + [1] * 3))
    write("image/bad-nan.pfm", pfm(2, 2, [NAN] * 12))
    write("image/bad-cut.pfm", pfm(2, 2, [1] * 11))
    write("image/bad-size-lies.pfm", pfm(1000000, 1000000, [1] * 12))
    write("image/bad-negative.pfm", pfm(-2, 2, [1] * 12))
    write("image/bad-cut.hdr", hdr(2, 2, bytes(7)))
    write("image/bad-size-lies.hdr", hdr(1000000, 1000000, bytes(16)))
    write("image/bad-run.hdr", hdr(8, 1, bytes([2, 2, 0, 8]) + bytes([255, 1] * 4)))
    write("image/bad-cut.tif", tiff(2, 2, b"abcd")[:40])
    write("image/bad-size-lies.tif", tiff(60000, 60000, b"abcd"))
    write("image/bad-cut.jpg", bytes.fromhex("ffd8ffe000104a46494600010100000100010000ffdb0043"))


# glTF --------------------------------------------------------------------------------------------------------------
def gltf(**changes):
    buffer = floats(0, 0, 0, 1, 0, 0, 0, 1, 0) + struct.pack("<4H", 0, 1, 2, 0)
    d = {"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
         "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
         "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3},
                       {"bufferView": 1, "componentType": 5123, "type": "SCALAR", "count": 3}],
         "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 8}],
         "buffers": [{"byteLength": 44, "uri": data_uri(buffer)}]}
    d.update(changes)
    return json.dumps(d)


def with_buffer(positions, indices=(0, 1, 2, 0)):
    return [{"byteLength": 44, "uri": data_uri(floats(*positions) + struct.pack("<4H", *indices))}]


def glb(text, binary, length=None, size=None):
    text = text.encode() + b" " * (-len(text) % 4)
    body = struct.pack("<I", len(text)) + b"JSON" + text + struct.pack("<I", size or len(binary)) + b"BIN\0" + binary
    return b"glTF" + struct.pack("<II", 2, length or 12 + len(body)) + body


def textured(content):
    return gltf(meshes=[{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
                materials=[{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
                textures=[{"source": 0}], images=[{"uri": data_uri(content)}])


def animated(times, values):
    d = json.loads(gltf())
    d["accessors"] += [{"bufferView": 2, "componentType": 5126, "type": "SCALAR", "count": 2},
                       {"bufferView": 3, "componentType": 5126, "type": "VEC3", "count": 2}]
    d["bufferViews"] += [{"buffer": 1, "byteLength": 8}, {"buffer": 1, "byteOffset": 8, "byteLength": 24}]
    d["buffers"] += [{"byteLength": 32, "uri": data_uri(floats(*times, *values))}]
    d["animations"] = [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
                        "samplers": [{"input": 2, "output": 3}]}]
    return json.dumps(d)


def gltfs():
    extension = lambda name, content: [{"mesh": 0, "extensions": {name: content}}]
    write("gltf/good.gltf", gltf())
    write("gltf/good-textured.gltf", textured(PNG))
    write("gltf/good-animated.gltf", animated([0, 1], [0, 0, 0, 1, 1, 1]))
    binary = floats(0, 0, 0, 1, 0, 0, 0, 1, 0) + struct.pack("<4H", 0, 1, 2, 0)
    whole = gltf(buffers=[{"byteLength": 44}])
    write("gltf/good.glb", glb(whole, binary))
    write("gltf/bad-cut.glb", glb(whole, binary)[:-10])
    write("gltf/bad-length.glb", glb(whole, binary, length=0xffffffff))
    write("gltf/bad-chunk.glb", glb(whole, binary, size=0xfffffff0))
    write("gltf/bad-header.glb", b"glTF\2\0")
    write("gltf/bad-empty.gltf", "")
    write("gltf/bad-cut.gltf", gltf()[:200])
    write("gltf/bad-deep.gltf", "[" * 20000)
    write("gltf/bad-not-gltf.gltf", "{}")
    write("gltf/bad-nan-word.gltf", gltf().replace('"mesh": 0', '"mesh": 0, "translation": [NaN, 0, 0]'))
    write("gltf/bad-inf-number.gltf", gltf().replace('"mesh": 0', '"mesh": 0, "translation": [1e999, 0, 0]'))
    write("gltf/bad-large-number.gltf", gltf(nodes=[{"mesh": 0, "scale": [1e300, 1, 1]}]))
    write("gltf/bad-overflow.gltf", gltf(nodes=[{"scale": [1e30, 1, 1], "children": [1]}, {"mesh": 0, "scale": [1e30, 1, 1]}]))
    write("gltf/bad-nan-position.gltf", gltf(buffers=with_buffer([0, 0, 0, 1, NAN, 0, 0, 1, 0])))
    write("gltf/bad-inf-position.gltf", gltf(buffers=with_buffer([0, 0, 0, 1, 0, 0, 0, -INF, 0])))
    write("gltf/bad-index.gltf", gltf(buffers=with_buffer([0, 0, 0, 1, 0, 0, 0, 1, 0], (0, 1, 3, 0))))
    write("gltf/bad-nan-key.gltf", animated([0, NAN], [0] * 6))
    write("gltf/bad-nan-pose.gltf", animated([0, 1], [NAN] * 6))
    write("gltf/bad-cycle.gltf", gltf(nodes=[{"mesh": 0, "children": [1]}, {"children": [0]}], scenes=[]))
    write("gltf/bad-count.gltf", gltf(accessors=[{"componentType": 5126, "type": "VEC3", "count": 4294967295}] * 2))
    write("gltf/bad-mesh.gltf", gltf(nodes=[{"mesh": 9}]))
    write("gltf/bad-missing-buffer.gltf", gltf(buffers=[{"byteLength": 44, "uri": "no-such.bin"}]))
    write("gltf/bad-remote-buffer.gltf", gltf(buffers=[{"byteLength": 44, "uri": "https://example.org/a.bin"}]))
    write("gltf/bad-required.gltf", gltf(extensionsRequired=["KHR_texture_basisu"]))
    write("gltf/bad-camera.gltf", gltf(cameras=[{"type": "perspective", "perspective": {"yfov": 0, "znear": 1}}],
                                       nodes=[{"mesh": 0, "camera": 0}]))
    write("gltf/bad-light.gltf", gltf(extensions={"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 1e39}]}},
                                      nodes=extension("KHR_lights_punctual", {"light": 0})))
    write("gltf/bad-emission.gltf", gltf(
        meshes=[{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
        materials=[{"emissiveFactor": [1e30, 0, 0],
                    "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 1e30}}}]))
    write("gltf/bad-draco.gltf", gltf(meshes=[{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "extensions": {
        "KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {"POSITION": 0}}}}]}]))
    meshopt = {"buffer": 0, "byteLength": 36, "mode": "ATTRIBUTES", "count": 3, "byteStride": 12}
    write("gltf/bad-meshopt.gltf", gltf(bufferViews=[{"buffer": 0, "byteLength": 36, "extensions": {"EXT_meshopt_compression": meshopt}},
                                                     {"buffer": 0, "byteOffset": 36, "byteLength": 8}]))
    write("gltf/bad-instances.gltf", gltf(
        accessors=[{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3},
                   {"componentType": 5126, "type": "VEC3", "count": 300000000}],
        meshes=[{"primitives": [{"attributes": {"POSITION": 0}}]}],
        nodes=extension("EXT_mesh_gpu_instancing", {"attributes": {"TRANSLATION": 1}})))
    write("gltf/bad-texture.gltf", textured(PNG[:40]))
    write("gltf/bad-nan-texture.gltf", textured(pfm(1, 1, [1, NAN, 1])))


# OBJ ---------------------------------------------------------------------------------------------------------------
def objs():
    square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
    write("obj/good.obj", "mtllib good.mtl\n" + square + "vt 0 0\nvn 0 0 1\nusemtl m\nf 1/1/1 2/1/1 3/1/1 4/1/1\n")
    write("obj/good.mtl", "newmtl m\nKd 0.5 0.5 0.5\nNs 10\nillum 2\n")
    write("obj/good-polygons.obj", square + "s 1\no a\ng b\nf -4 -3 -2 -1\nl 1 2\np 1\n")
    write("obj/bad-nan-vertex.obj", square + "v nan 0 0\nf 1 2 5\n")
    write("obj/bad-inf-vertex.obj", square + "v 1e999 0 0\nf 1 2 5\n")
    write("obj/bad-nan-uv.obj", square + "vt nan 0\nf 1/1 2/1 3/1\n")
    write("obj/bad-inf-normal.obj", square + "vn 0 0 -inf\nf 1//1 2//1 3//1\n")
    write("obj/bad-cut-vertex.obj", square + "v 1 2\nf 1 2 3\n")
    write("obj/bad-index.obj", square + "f 1 2 99\n")
    write("obj/bad-zero-index.obj", square + "f 0 1 2\n")
    write("obj/bad-negative-index.obj", square + "f -1 -2 -99\n")
    write("obj/bad-huge-index.obj", square + "f 1 2 99999999999999999999\n")
    write("obj/bad-corner.obj", square + "f 1/x 2 3\n")
    write("obj/bad-material.obj", "mtllib bad-material.mtl\n" + square + "usemtl m\nf 1 2 3\n")
    write("obj/bad-material.mtl", "newmtl m\nKd nan 0 0\n")
    write("obj/bad-emission.obj", "mtllib bad-emission.mtl\n" + square + "usemtl m\nf 1 2 3\n")
    write("obj/bad-emission.mtl", "newmtl m\nKe 1e999 0 0\n")


# PLY ---------------------------------------------------------------------------------------------------------------
def ply(kind, vertices, faces, body, vertex_type="float"):
    head = (f"ply\nformat {kind} 1.0\nelement vertex {vertices}\n" + "".join(f"property {vertex_type} {c}\n" for c in "xyz") +
            f"element face {faces}\nproperty list uchar int vertex_indices\nend_header\n")
    return head.encode() + body


def plys():
    corners, face = [0, 0, 0, 1, 0, 0, 0, 1, 0], struct.pack("<B3i", 3, 0, 1, 2)
    binary = lambda numbers, body=face, v=3, f=1: ply("binary_little_endian", v, f, floats(*numbers) + body)
    write("ply/good.ply", binary(corners))
    write("ply/good-text.ply", ply("ascii", 3, 1, b"0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"))
    write("ply/good-big.ply", ply("binary_big_endian", 3, 1, struct.pack(">9f", *corners) + struct.pack(">B3i", 3, 0, 1, 2)))
    write("ply/good.ply.gz", gzip.compress(binary(corners), mtime=0))
    write("ply/bad-empty.ply", b"")
    write("ply/bad-magic.ply", b"plx\nformat ascii 1.0\nend_header\n")
    write("ply/bad-header.ply", binary(corners)[:60])
    write("ply/bad-format.ply", binary(corners).replace(b"binary_little_endian", b"binary_middle_endian"))
    write("ply/bad-type.ply", binary(corners).replace(b"float x", b"flout x"))
    write("ply/bad-cut.ply", binary(corners)[:-5])
    write("ply/bad-vertex-count.ply", binary(corners, v=4000000000))
    write("ply/bad-face-count.ply", binary(corners, f=18446744073709551615))
    write("ply/bad-negative-count.ply", binary(corners, f=-1))
    write("ply/bad-nan.ply", binary([0, 0, 0, 1, NAN, 0, 0, 1, 0]))
    write("ply/bad-inf.ply", binary([0, 0, 0, 1, INF, 0, 0, 1, 0]))
    write("ply/bad-nan-text.ply", ply("ascii", 3, 1, b"0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"))
    write("ply/bad-cut-text.ply", ply("ascii", 3, 1, b"0 0 0\n1 0 0\n0 1\n"))
    write("ply/bad-double-overflow.ply", ply("ascii", 3, 1, b"0 0 0\n1e300 0 0\n0 1 0\n3 0 1 2\n", "double"))
    write("ply/bad-index.ply", binary(corners, struct.pack("<B3i", 3, 0, 1, 3)))
    write("ply/bad-negative-index.ply", binary(corners, struct.pack("<B3i", 3, 0, 1, -1)))
    write("ply/bad-list.ply", binary(corners, struct.pack("<B3i", 255, 0, 1, 2)))
    write("ply/bad-cut.ply.gz", gzip.compress(binary(corners), mtime=0)[:-20])
    write("ply/bad-sum.ply.gz", gzip.compress(binary(corners), mtime=0)[:-6] + b"\0" * 6)


# pbrt --------------------------------------------------------------------------------------------------------------
def pbrts():
    sphere = 'Shape "sphere" "float radius" 1\n'
    triangle = 'Shape "trianglemesh" "point3 P" [{}] "integer indices" [0 1 2]\n'
    world = lambda text, head="": f"{head}WorldBegin\n{text}"
    write("pbrt/good.pbrt", world('LightSource "infinite"\nMaterial "diffuse" "rgb reflectance" [.5 .5 .5]\n' + sphere,
                                  'LookAt 0 0 5 0 0 0 0 1 0\nCamera "perspective" "float fov" 40\n'
                                  'Film "rgb" "integer xresolution" 8 "integer yresolution" 8\n'))
    write("pbrt/good-more.pbrt", world(
        'AttributeBegin\nTranslate 1 0 0\nRotate 30 0 1 0\nAreaLightSource "diffuse" "rgb L" [1 1 1]\n' + sphere +
        'AttributeEnd\nObjectBegin "o"\n' + triangle.format("0 0 0 1 0 0 0 1 0") + 'ObjectEnd\nObjectInstance "o"\n'
        'Texture "t" "spectrum" "checkerboard" "rgb tex1" [1 0 0]\nMaterial "coateddiffuse" "texture reflectance" "t"\n'
        'MakeNamedMaterial "g" "string type" "dielectric"\nNamedMaterial "g"\n' + sphere))
    bad = lambda name, text: write(f"pbrt/bad-{name}.pbrt", text)
    bad("string", world('Shape "sphere'))
    bad("bracket", world('Shape "sphere" "float radius" [ 1'))
    bad("directive", world("Shapes"))
    bad("bytes", bytes(range(256)))
    bad("attribute-end", world("AttributeEnd\n"))
    bad("attribute-begin", world("AttributeBegin\n" + sphere))
    bad("nan-translate", world("Translate nan 0 0\n" + sphere))
    bad("inf-scale", world("Scale 1e999 1 1\n" + sphere))
    bad("overflow", world("Scale 1e30 1 1\nScale 1e30 1 1\n" + sphere))
    bad("flat", world("Scale 1 0 1\n" + sphere))
    bad("nan-matrix", world("ConcatTransform [1 0 0 0 0 1 0 0 0 0 nan 0 0 0 0 1]\n" + sphere))
    bad("nan-camera", world(sphere, 'LookAt 0 0 nan 0 0 0 0 1 0\nCamera "perspective"\n'))
    bad("look-at", world(sphere, 'LookAt 0 0 0 0 0 0 0 1 0\nCamera "perspective"\n'))
    bad("fov", world(sphere, 'Camera "perspective" "float fov" 180\n'))
    bad("nan-fov", world(sphere, 'Camera "perspective" "float fov" nan\n'))
    bad("film", world(sphere, 'Film "rgb" "integer xresolution" 2000000000 "integer yresolution" 2000000000\n'))
    bad("nan-vertex", world(triangle.format("0 0 0 1 nan 0 0 1 0")))
    bad("inf-vertex", world(triangle.format("0 0 0 1 1e999 0 0 1 0")))
    bad("index", world(triangle.format("0 0 0 1 0 0 0 1 0").replace("0 1 2", "0 1 7")))
    bad("cut-points", world(triangle.format("0 0 0 1 0 0 0 1")))
    bad("nan-light", world('LightSource "point" "rgb I" [1 nan 1]\n' + sphere))
    bad("inf-light", world('LightSource "infinite" "rgb L" [1 1e999 1]\n' + sphere))
    bad("light-overflow", world('LightSource "point" "rgb I" [1e38 1e38 1e38] "float scale" 1e38\n' + sphere))
    bad("nan-material", world('Material "diffuse" "rgb reflectance" [nan 0 0]\n' + sphere))
    bad("nan-texture", world('Texture "t" "float" "constant" "float value" nan\n' + sphere))
    bad("nan-image", world('Texture "t" "spectrum" "imagemap" "string filename" "../image/bad-nan.pfm"\n'
                           'Material "diffuse" "texture reflectance" "t"\n' + sphere))
    bad("material", world('Material "difuse"\n' + sphere))
    bad("missing-image", world('LightSource "infinite" "string filename" "no-such.exr"\n' + sphere))
    bad("missing-ply", world('Shape "plymesh" "string filename" "no-such.ply"\n'))
    bad("include-itself", world('Include "bad-include-itself.pbrt"\n'))
    bad("missing-include", world('Include "no-such.pbrt"\n'))
    bad("instance", world('ObjectInstance "never"\n'))
    bad("instance-in-itself", world('ObjectBegin "o"\nObjectInstance "o"\nObjectEnd\nObjectInstance "o"\n'))
    bad("radius", world('Shape "sphere" "float radius" nan\n'))
    write("pbrt/bad-cut.pbrt.gz", gzip.compress(world(sphere).encode(), mtime=0)[:-12])


# Polygons ----------------------------------------------------------------------------------------------------------
def polygons():
    bad = lambda name, text: write(f"polygon/bad-{name}", text)
    geometry = lambda kind, coordinates: f'{{"type":"{kind}","coordinates":{coordinates}}}'
    feature = lambda g, more="": f'{{"type":"Feature","id":7,"properties":{{"name":"a","b":[1,{{}}]}}{more},"geometry":{g}}}'
    collection = lambda *features: '{"type":"FeatureCollection","crs":null,"features":[\n' + ",\n".join(features) + "\n]}\n"
    holed = "[[[0,0],[9,0],[9,9],[0,9],[0,0]],[[1,1],[1,2],[2,1],[1,1]]]"
    write("polygon/good.geojson", collection(
        feature(geometry("Polygon", holed)), feature(geometry("MultiPolygon", f"[{holed},[[[20,0,1],[30,0,1],[20,9,1],[20,0,1]]]]")),
        feature("null"), feature('{"type":"GeometryCollection","geometries":[' + ",".join(
            [geometry("Point", "[1,2]"), geometry("MultiPoint", "[[1,2],[3e1,-4.5]]"), geometry("LineString", "[[1,2],[3,4]]"),
             geometry("MultiLineString", "[[[1,2],[3,4]],[[5,6],[7,8]]]")]) + "]}", ',"bbox":[0,0,1,1]')))
    write("polygon/good-bare.json", holed)
    write("polygon/good-degenerate.geojson", geometry("MultiPolygon", "[[],[[]],[[[0,0]]],[[[0,0],[0,0],[1,1],[0,0]]]]"))
    write("polygon/good.wkt", "SRID=4326;POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 1 2, 2 1, 1 1))\npolygon empty\n"
          "MULTIPOINT ((1 2), (3 4));\nGEOMETRYCOLLECTION Z (POINT Z (1 2 3), LINESTRING (1 2, 3 4),\n"
          "  MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), EMPTY), MULTILINESTRING ((1 2, 3 4), (5 6, 7 8)))\n")
    write("polygon/good.txt", "# a polygon with a hole, another, a line and points\n0 0\n9,0\n9 , 9\n0 9 # corner\nhole\n1 1\n1 2\n2 1\n\n"
          "20 0 1\n30 0 1\n20 9 1\nline\n1 2\n3 4\npoints\n5e-1 6\n")

    bad("cut.geojson", collection(feature(geometry("Polygon", holed)))[:-40])
    bad("empty.geojson", "")
    bad("no-type.geojson", "{}")
    bad("type.geojson", geometry("Poligon", holed))
    bad("type-number.geojson", '{"type":5}')
    bad("nan.geojson", geometry("Point", "[NaN,0]"))
    bad("null.geojson", collection(feature(geometry("Polygon", "[[[0,0],[1,null],[0,1],[0,0]]]"))))
    bad("overflow.geojson", geometry("Point", "[1e999,0]"))
    bad("one-number.geojson", geometry("LineString", "[[0,0],[1]]"))
    bad("shallow.geojson", geometry("Polygon", "[[0,0],[1,0],[0,1],[0,0]]"))
    bad("deep.geojson", geometry("Polygon", "[" * 10_000))
    bad("deep-collection.geojson", '{"type":"GeometryCollection","geometries":[' * 1000)
    bad("deep-properties.geojson", '{"type":"Feature","properties":{"a":' + "[" * 10_000)
    bad("mixed.geojson", geometry("MultiPolygon", "[[[[0,0],[1,0],[0,1],[0,0]]],[[0,0]]]"))
    bad("object.geojson", geometry("Point", '[{"x":1},2]'))
    bad("features.geojson", '{"type":"FeatureCollection","features":[7]}')
    bad("no-features.geojson", '{"type":"FeatureCollection"}')
    bad("no-coordinates.geojson", '{"type":"Polygon"}')
    bad("utf8.geojson", b'{"type":"Feature","properties":{"name":"\xff"},"geometry":null}')
    bad("trailing.geojson", geometry("Point", "[1,2]") + "x")
    bad("cut.wkt", "POLYGON ((0 0, 1 0, 0 1, 0 0)")
    bad("name.wkt", "POLIGON ((0 0, 1 0, 0 1, 0 0))")
    bad("nan.wkt", "POINT (nan 0)")
    bad("inf.wkt", "LINESTRING (0 0, inf 1)")
    bad("overflow.wkt", "POINT (1e999 0)")
    bad("one-number.wkt", "LINESTRING (0 0, 1)")
    bad("measure.wkt", "POINT M (1 2 3)")
    bad("four.wkt", "POINT (1 2 3 4)")
    bad("srid.wkt", "SRID=x;POINT (1 2)")
    bad("deep.wkt", "GEOMETRYCOLLECTION (" * 1000)
    bad("brackets.wkt", "POLYGON " + "(" * 10_000)
    bad("binary.wkt", b"POINT (1 2)\0\xff")
    bad("word.txt", "0 0\n1 x\n")
    bad("nan.txt", "0 0\nnan 1\n")
    bad("overflow.txt", "0 0\n1 1e999\n")
    bad("one-number.txt", "0 0\n1\n")
    bad("four.txt", "0 0 0 0\n")
    bad("binary.txt", bytes(range(1, 256)))


def booleans():
    """Operands as tests/stress/boolean_case.h decodes them: fill rule, kind of coordinates, grid, scale, then rings."""
    random.seed(3)
    for kind, name in enumerate(["grid", "offset", "steps", "anywhere", "noise", "mixed"]):
        write(f"boolean/{name}.bytes", bytes([0, kind, 3, 0]) + bytes(random.randrange(256) for _ in range(96)))


def composites():
    write("composite/over.txt", "fg.exr over (sky.exr opaque 0.7)")
    write("composite/keys.txt", "a.exr key-colour 0 1 0 spill=0.5 mask disk([1:0 24:9], 5, 3) dissolve [1:0, 5:1]")
    write("composite/names.txt", "\"title \\\"card\\\"\" in 'b.####.exr' layer albedo frame 3 xor polygon(0,0,1,0,1,1,5,6)")
    write("composite/tree.json", '{"word": "over", "inputs": ["a.exr", {"file": "b.exr"}, {"word": "blur", "numbers": [2], "inputs": ["c"]}]}')
    for name, text in {"cut": "a.exr over", "deep": "(" * 10_000, "chain": "a.exr" + " over a.exr" * 5000, "quote": '"a.exr',
                       "nan": "a.exr blur nan", "range": "a.exr dissolve 2", "keys": "a.exr dissolve [2:0 1:1]",
                       "binary": "a.exr \x01\x02", "many": "disk(" + "1," * 5000 + "1)", "huge": "a.exr blur 1e999"}.items():
        write(f"composite/bad-{name}.comp", text)
    write("composite/bad-word.json", '{"word": "ovre", "inputs": ["a", "b"]}')
    write("composite/bad-deep.json", '{"word":"clamp","inputs":[' * 5000)


if __name__ == "__main__":
    images()
    gltfs()
    objs()
    plys()
    pbrts()
    polygons()
    booleans()
    composites()
