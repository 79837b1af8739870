"""Makes spheres.glb out of arithmetic: two rows of one sphere, a metal and a lacquer, from smooth to rough.

Needs nothing beside Python; the same bytes every time.
"""

import json
import math
import pathlib
import struct

ROUGHNESSES = (0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 1.0)
MATTERS = (("gold", (1.0, 0.71, 0.29), 1.0), ("lacquer", (0.55, 0.02, 0.04), 0.0))
SPACING = 2.2  # of spheres of radius 1
GAP = 0.8  # between the two kinds
RINGS, SECTORS = 36, 72

ARRAY_BUFFER, ELEMENT_ARRAY_BUFFER = 34962, 34963
FLOAT, UNSIGNED_SHORT = 5126, 5123


def sphere():
    """Positions, which are also the normals, texture coordinates, and triangles seen from outside."""
    points, uvs, triangles = [], [], []
    for ring in range(RINGS + 1):
        polar = math.pi * ring / RINGS
        for sector in range(SECTORS + 1):
            around = 2 * math.pi * sector / SECTORS
            points.append((math.sin(polar) * math.sin(around), math.cos(polar), math.sin(polar) * math.cos(around)))
            uvs.append((sector / SECTORS, ring / RINGS))
    for ring in range(RINGS):
        for sector in range(SECTORS):
            low, high = ring * (SECTORS + 1) + sector, (ring + 1) * (SECTORS + 1) + sector
            if ring > 0:
                triangles += [low, high, low + 1]
            if ring < RINGS - 1:
                triangles += [low + 1, high, high + 1]
    return points, uvs, triangles


def places():
    """(material index, x) of every sphere, centered about 0."""
    count = len(ROUGHNESSES)
    width = (2 * count - 1) * SPACING + GAP
    for i in range(2 * count):
        yield i, i * SPACING + (GAP if i >= count else 0.0) - width / 2


def document(points, views):
    """The glTF document: one mesh per material, all of the same accessors."""
    lowest = [min(p[axis] for p in points) for axis in range(3)]
    highest = [max(p[axis] for p in points) for axis in range(3)]
    spread = len(views[2]["data"]) // 2
    accessors = [
        {"bufferView": 0, "componentType": FLOAT, "count": len(points), "type": "VEC3", "min": lowest, "max": highest},
        {"bufferView": 1, "componentType": FLOAT, "count": len(points), "type": "VEC2"},
        {"bufferView": 2, "componentType": UNSIGNED_SHORT, "count": spread, "type": "SCALAR"},
    ]
    materials = [
        {"name": f"{name} {roughness}",
         "pbrMetallicRoughness": {"baseColorFactor": [*color, 1.0], "metallicFactor": metallic, "roughnessFactor": roughness}}
        for name, color, metallic in MATTERS for roughness in ROUGHNESSES
    ]
    attributes = {"POSITION": 0, "NORMAL": 0, "TEXCOORD_0": 1}
    meshes = [{"name": material["name"], "primitives": [{"attributes": attributes, "indices": 2, "material": i}]}
              for i, material in enumerate(materials)]
    nodes = [{"name": materials[i]["name"], "mesh": i, "translation": [x, 0.0, 0.0]} for i, x in places()]
    return {"asset": {"version": "2.0", "generator": "passgraph make_spheres.py"}, "scene": 0,
            "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes, "meshes": meshes, "materials": materials,
            "accessors": accessors}


def main():
    """Writes spheres.glb beside this script."""
    points, uvs, triangles = sphere()
    views = [
        {"data": struct.pack(f"<{3 * len(points)}f", *(x for p in points for x in p)), "target": ARRAY_BUFFER},
        {"data": struct.pack(f"<{2 * len(uvs)}f", *(x for uv in uvs for x in uv)), "target": ARRAY_BUFFER},
        {"data": struct.pack(f"<{len(triangles)}H", *triangles), "target": ELEMENT_ARRAY_BUFFER},
    ]
    gltf = document(points, views)
    blob = bytearray()
    gltf["bufferViews"] = []
    for view in views:
        gltf["bufferViews"].append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(view["data"]), "target": view["target"]})
        blob += view["data"] + bytes(-len(view["data"]) % 4)
    gltf["buffers"] = [{"byteLength": len(blob)}]
    text = json.dumps(gltf, separators=(",", ":"), sort_keys=True).encode()
    text += b" " * (-len(text) % 4)
    with open(pathlib.Path(__file__).resolve().parent / "spheres.glb", "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(blob)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text)
        file.write(struct.pack("<I4s", len(blob), b"BIN\0") + bytes(blob))


if __name__ == "__main__":
    main()
