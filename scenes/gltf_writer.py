"""Writes small glTF 2.0 files as one JSON text each, geometry inside as base64."""
import base64
import json
import math
import struct


class Gltf:
    def __init__(self, name):
        self.data = bytearray()
        self.json = {"asset": {"version": "2.0", "generator": name}, "scene": 0, "scenes": [{"nodes": []}], "nodes": [],
                     "meshes": [], "materials": [], "accessors": [], "bufferViews": [], "buffers": [], "cameras": []}

    def accessor(self, values, kind, component):
        """`values`: tuples (or integers for SCALAR); component 5126 float, 5123 unsigned short, 5125 unsigned int."""
        code, width = {5126: ("f", 4), 5123: ("H", 2), 5125: ("I", 4)}[component]
        flat = list(values) if kind == "SCALAR" else [x for v in values for x in v]
        while len(self.data) % 4:
            self.data.append(0)
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(flat) * width}
        self.data += struct.pack(f"<{len(flat)}{code}", *flat)
        self.json["bufferViews"].append(view)
        entry = {"bufferView": len(self.json["bufferViews"]) - 1, "componentType": component, "type": kind,
                 "count": len(values)}
        if kind == "VEC3":
            entry["min"] = [round(min(v[i] for v in values), 7) for i in range(3)]
            entry["max"] = [round(max(v[i] for v in values), 7) for i in range(3)]
        self.json["accessors"].append(entry)
        return len(self.json["accessors"]) - 1

    def geometry(self, positions, triangles, normals=None, uv=None):
        """Attributes and indices of a primitive; flat shaded without normals."""
        attributes = {"POSITION": self.accessor(positions, "VEC3", 5126)}
        if normals is positions:
            attributes["NORMAL"] = attributes["POSITION"]
        elif normals:
            attributes["NORMAL"] = self.accessor(normals, "VEC3", 5126)
        if uv:
            attributes["TEXCOORD_0"] = self.accessor(uv, "VEC2", 5126)
        wide = 5125 if len(positions) > 65535 else 5123
        return {"attributes": attributes, "indices": self.accessor([i for t in triangles for i in t], "SCALAR", wide)}

    def sphere(self, columns=72, rows=36):
        """Of radius 1, whose normals are its positions; uv around and up, poles on y."""
        points, uv, triangles = [], [], []
        for j in range(rows + 1):
            for i in range(columns + 1):
                theta, phi = math.pi * j / rows, 2 * math.pi * i / columns
                points.append((math.sin(theta) * math.sin(phi), math.cos(theta), math.sin(theta) * math.cos(phi)))
                uv.append((i / columns, j / rows))
                if i < columns and j < rows:
                    a, b = j * (columns + 1) + i, (j + 1) * (columns + 1) + i
                    if j > 0:
                        triangles.append((a, b, a + 1))
                    if j < rows - 1:
                        triangles.append((a + 1, b, b + 1))
        return self.geometry(points, triangles, points, uv)

    def quad(self, a, b, c, d):
        """Counter-clockwise seen from its front."""
        return self.geometry([a, b, c, d], [(0, 1, 2), (0, 2, 3)], uv=[(0, 1), (1, 1), (1, 0), (0, 0)])

    def prism(self, profile, z0, z1):
        """A convex counter-clockwise profile in the x-y plane, extruded from z0 to z1 > z0; flat faces."""
        n = len(profile)
        points = [(x, y, z0) for x, y in profile] + [(x, y, z1) for x, y in profile]
        triangles = [(n, n + i, n + i + 1) for i in range(1, n - 1)] + [(0, i + 1, i) for i in range(1, n - 1)]
        for i in range(n):
            j = (i + 1) % n
            triangles += [(i, j, n + j), (i, n + j, n + i)]
        return self.geometry(points, triangles)

    def box(self, low, high):
        (x0, y0, z0), (x1, y1, z1) = low, high
        return self.prism([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], z0, z1)

    def material(self, name, base_colour=(1, 1, 1), metallic=0.0, roughness=1.0, extensions=None, **others):
        m = {"name": name, "pbrMetallicRoughness": {"baseColorFactor": [*base_colour, 1], "metallicFactor": metallic,
                                                    "roughnessFactor": roughness}, **others}
        if extensions:
            m["extensions"] = {f"KHR_materials_{k}": v for k, v in extensions.items()}
        self.json["materials"].append(m)
        return len(self.json["materials"]) - 1

    def add(self, name, geometry, material, **placement):
        """placement: translation, rotation, scale or matrix of the node."""
        self.json["meshes"].append({"name": name, "primitives": [{**geometry, "material": material}]})
        self.add_node({"name": name, "mesh": len(self.json["meshes"]) - 1, **placement})

    def add_node(self, node):
        self.json["nodes"].append(node)
        self.json["scenes"][0]["nodes"].append(len(self.json["nodes"]) - 1)

    def camera(self, eye, target, yfov_degrees, aspect):
        """Looks from `eye` to `target`, up +y."""
        def unit(v):
            length = math.sqrt(sum(x * x for x in v))
            return [x / length for x in v]

        def cross(a, b):
            return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        z = unit([e - t for e, t in zip(eye, target)])
        x = unit(cross([0, 1, 0], z))
        matrix = [*x, 0, *cross(z, x), 0, *z, 0, *eye, 1]
        self.json["cameras"].append({"type": "perspective", "perspective": {
            "yfov": math.radians(yfov_degrees), "aspectRatio": aspect, "znear": 0.01}})
        self.add_node({"name": "camera", "camera": len(self.json["cameras"]) - 1, "matrix": [round(v, 7) for v in matrix]})

    def write(self, path):
        self.json["buffers"] = [{"byteLength": len(self.data), "uri": "data:application/octet-stream;base64," +
                                 base64.b64encode(self.data).decode()}]
        used = sorted({e for m in self.json["materials"] for e in m.get("extensions", {})} | set(self.json.get("extensions", {})))
        if used:
            self.json["extensionsUsed"] = used
        text = json.dumps({k: v for k, v in self.json.items() if v != []}, indent=None, separators=(",", ":"))
        path.write_text(text.replace('},{', '},\n{') + "\n")
