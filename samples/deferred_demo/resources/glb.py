"""Writes triangles with metallic-roughness materials as one self-contained binary glTF 2.0 file."""

import io
import json
import struct

import numpy as np

ARRAY_BUFFER = 34962
ELEMENT_ARRAY_BUFFER = 34963
FLOAT = 5126
UNSIGNED_SHORT = 5123
UNSIGNED_INT = 5125


class Glb:
    """A model under construction: add images, then materials, then primitives, then save."""

    def __init__(self, name):
        self.blob = bytearray()
        self.extensions = set()
        self.doc = {
            "asset": {"version": "2.0", "generator": "passgraph make_assets.py"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [{"name": name, "mesh": 0}],
            "meshes": [{"name": name, "primitives": []}],
            "materials": [], "accessors": [], "bufferViews": [],
        }

    def _view(self, data, target=None):
        while len(self.blob) % 4:
            self.blob.append(0)
        view = {"buffer": 0, "byteOffset": len(self.blob), "byteLength": len(data)}
        if target is not None:
            view["target"] = target
        self.blob += data
        self.doc["bufferViews"].append(view)
        return len(self.doc["bufferViews"]) - 1

    def _accessor(self, array, kind, component, target, has_bounds=False):
        accessor = {"bufferView": self._view(array.tobytes(), target), "componentType": component,
                    "count": len(array), "type": kind}
        if has_bounds:
            accessor["min"] = [float(x) for x in array.min(axis=0)]
            accessor["max"] = [float(x) for x in array.max(axis=0)]
        self.doc["accessors"].append(accessor)
        return len(self.doc["accessors"]) - 1

    def texture(self, picture, quality=None):
        """Embeds a Pillow picture, as JPEG of that quality or else as PNG; returns its texture index."""
        data = io.BytesIO()
        if quality is None:
            picture.save(data, "PNG", optimize=True)
        else:
            picture.save(data, "JPEG", quality=quality, subsampling=0, optimize=True)
        mime = "image/png" if quality is None else "image/jpeg"
        images = self.doc.setdefault("images", [])
        images.append({"bufferView": self._view(data.getvalue()), "mimeType": mime})
        self.doc.setdefault("samplers", [{"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497}])
        textures = self.doc.setdefault("textures", [])
        textures.append({"sampler": 0, "source": len(images) - 1})
        return len(textures) - 1

    def material(self, name, color=(1, 1, 1), metallic=0.0, roughness=0.5, color_texture=None,
                 surface_texture=None, emissive=None, emissive_texture=None, emissive_strength=1.0):
        """Adds a material and returns its index; colors are linear factors."""
        surface = {"baseColorFactor": [*map(float, color), 1.0], "metallicFactor": float(metallic),
                   "roughnessFactor": float(roughness)}
        if color_texture is not None:
            surface["baseColorTexture"] = {"index": color_texture}
        if surface_texture is not None:
            surface["metallicRoughnessTexture"] = {"index": surface_texture}
        material = {"name": name, "pbrMetallicRoughness": surface}
        if emissive is not None:
            material["emissiveFactor"] = [*map(float, emissive)]
            material["extensions"] = {"KHR_materials_emissive_strength": {"emissiveStrength": float(emissive_strength)}}
            self.extensions.add("KHR_materials_emissive_strength")
        if emissive_texture is not None:
            material["emissiveTexture"] = {"index": emissive_texture}
        self.doc["materials"].append(material)
        return len(self.doc["materials"]) - 1

    def primitive(self, mesh, material):
        """Adds (positions, normals, uvs, triangles) drawn with that material."""
        positions, normals, uvs, triangles = mesh
        small = len(positions) <= 65535
        indices = np.ascontiguousarray(triangles).reshape(-1).astype("<u2" if small else "<u4")
        self.doc["meshes"][0]["primitives"].append({
            "attributes": {
                "POSITION": self._accessor(positions.astype("<f4"), "VEC3", FLOAT, ARRAY_BUFFER, True),
                "NORMAL": self._accessor(normals.astype("<f4"), "VEC3", FLOAT, ARRAY_BUFFER),
                "TEXCOORD_0": self._accessor(uvs.astype("<f4"), "VEC2", FLOAT, ARRAY_BUFFER),
            },
            "indices": self._accessor(indices, "SCALAR", UNSIGNED_SHORT if small else UNSIGNED_INT,
                                      ELEMENT_ARRAY_BUFFER),
            "material": material,
        })

    def save(self, path):
        """Writes the .glb: header, JSON chunk padded with spaces, binary chunk padded with zeros."""
        while len(self.blob) % 4:
            self.blob.append(0)
        self.doc["buffers"] = [{"byteLength": len(self.blob)}]
        if self.extensions:
            self.doc["extensionsUsed"] = sorted(self.extensions)
        text = json.dumps(self.doc, separators=(",", ":"), sort_keys=True).encode()
        text += b" " * (-len(text) % 4)
        with open(path, "wb") as file:
            file.write(struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(self.blob)))
            file.write(struct.pack("<I4s", len(text), b"JSON") + text)
            file.write(struct.pack("<I4s", len(self.blob), b"BIN\0") + bytes(self.blob))
