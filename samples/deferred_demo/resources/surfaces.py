"""Meshes from parametric grids, flat polygons and sweeps; a mesh is (positions, normals, uvs, triangles)."""

import numpy as np


def unit(vectors):
    """The vectors scaled to length 1 along the last axis."""
    vectors = np.asarray(vectors, dtype=float)
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-20)


def join(meshes):
    """One mesh out of many."""
    offsets = np.cumsum([0] + [len(mesh[0]) for mesh in meshes[:-1]])
    return (np.concatenate([m[0] for m in meshes]), np.concatenate([m[1] for m in meshes]),
            np.concatenate([m[2] for m in meshes]),
            np.concatenate([m[3] + offset for m, offset in zip(meshes, offsets)]))


def moved(mesh, offset):
    """The mesh, translated."""
    return mesh[0] + np.asarray(offset, dtype=float), mesh[1], mesh[2], mesh[3]


def scaled(mesh, factor):
    """The mesh, scaled about the origin."""
    return mesh[0] * factor, mesh[1], mesh[2], mesh[3]


def drop_degenerate(mesh):
    """The mesh without triangles of no area, with triangles wound to agree with their normals."""
    positions, normals, uvs, triangles = mesh
    a, b, c = (positions[triangles[:, k]] for k in range(3))
    face = np.cross(b - a, c - a)
    kept = np.linalg.norm(face, axis=1) > 1e-9 * np.ptp(positions, axis=0).max() ** 2
    is_backward = (face * normals[triangles].sum(axis=1)).sum(axis=1) < 0
    wound = np.where(is_backward[:, None], triangles[:, [0, 2, 1]], triangles)
    return positions, normals, uvs, wound[kept]


def grid(positions, normals, uvs):
    """Two triangles per cell of (rows, columns, ...) arrays, facing along the normals."""
    rows, columns = positions.shape[:2]
    corner = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = corner[:-1, :-1], corner[:-1, 1:], corner[1:, 1:], corner[1:, :-1]
    triangles = np.stack([a, b, c, a, c, d], axis=-1).reshape(-1, 3)
    return drop_degenerate((positions.reshape(-1, 3), normals.reshape(-1, 3), uvs.reshape(-1, 2), triangles))


def flat_polygon(corners, uvs=None):
    """A convex polygon, counter-clockwise seen from outside, with its own flat normal."""
    corners = np.asarray(corners, dtype=float)
    normal = unit(np.cross(corners[1] - corners[0], corners[2] - corners[0]))
    count = len(corners)
    triangles = np.array([[0, k, k + 1] for k in range(1, count - 1)])
    uvs = np.full((count, 2), 0.5) if uvs is None else np.asarray(uvs, dtype=float)
    return corners, np.tile(normal, (count, 1)), uvs, triangles


def sphere(radius, rows, columns):
    """A sphere about the origin; u runs around +y, v from the top down."""
    polar = np.linspace(0.0, np.pi, rows + 1)[:, None]
    around = np.linspace(0.0, 2.0 * np.pi, columns + 1)[None, :]
    normal = np.stack([np.sin(polar) * np.sin(around), np.cos(polar) + 0 * around, np.sin(polar) * np.cos(around)], axis=-1)
    normal = unit(normal)
    uv = np.stack(np.broadcast_arrays(around / (2 * np.pi), polar / np.pi), axis=-1)
    return grid(radius * normal, normal, uv)


def tube(center, radius, columns, ridge=lambda along, around: 0.0 * around * along):
    """A round tube along planar (z = 0) center points; ridge(along, around) modulates the radius, 0 keeps it."""
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(center, axis=0), axis=1))])
    tangent = unit(np.gradient(center, along, axis=0))
    side = np.tile([0.0, 0.0, 1.0], (len(center), 1))
    other = np.cross(side, tangent)
    around = np.linspace(0.0, 2.0 * np.pi, columns + 1)

    def ring(angle):
        spoke = np.cos(angle)[None, :, None] * other[:, None] + np.sin(angle)[None, :, None] * side[:, None]
        reach = radius[:, None] * (1.0 + ridge(along[:, None], angle[None, :]))
        return center[:, None] + spoke * reach[..., None]

    points = ring(around)
    across = ring(around + 1e-3) - ring(around - 1e-3)
    onward = np.gradient(points, axis=0)
    normal = unit(np.cross(across, onward))
    outward = points - center[:, None]
    normal *= np.where((normal * outward).sum(axis=-1, keepdims=True) < 0, -1.0, 1.0)
    uv = np.stack(np.broadcast_arrays((around / (2 * np.pi))[None, :], (along / along[-1])[:, None]), axis=-1)
    return grid(points, normal, uv)


def torus(major, minor, stretch, turn, rows=14, columns=8):
    """A chain link: a torus in the x-y plane, stretched along y, turned about y by that angle."""
    ring = np.linspace(0.0, 2.0 * np.pi, rows + 1)[:, None]
    tube_angle = np.linspace(0.0, 2.0 * np.pi, columns + 1)[None, :]
    normal = np.stack([np.cos(tube_angle) * np.cos(ring), np.cos(tube_angle) * np.sin(ring),
                       np.sin(tube_angle) + 0 * ring], axis=-1)
    center = np.stack([major * np.cos(ring), major * np.sin(ring) * stretch, 0 * ring], axis=-1)
    points = center + minor * normal
    spin = np.array([[np.cos(turn), 0, np.sin(turn)], [0, 1, 0], [-np.sin(turn), 0, np.cos(turn)]])
    uv = np.stack(np.broadcast_arrays(ring / (2 * np.pi), tube_angle / (2 * np.pi)), axis=-1)
    return grid(points @ spin.T, normal @ spin.T, uv)
