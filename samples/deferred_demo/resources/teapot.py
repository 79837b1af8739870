"""The Utah teapot: Martin Newell's 32 bicubic patches of 1975, written as 6 profiles, 2 half handles and 2 half spouts."""

import numpy as np

from surfaces import flat_polygon, grid, join, unit

# Radius and height of the patches of revolution, from the lid's knob down to the bottom's middle.
KNOB = ((0.0, 3.15), (0.8, 3.15), (0.0, 2.85), (0.2, 2.7))
LID = ((0.2, 2.7), (0.4, 2.55), (1.3, 2.55), (1.3, 2.4))
SEAT = ((1.3, 2.4), (1.334, 2.4), (1.367, 2.4), (1.4, 2.4))  # not Newell's: closes the gap between lid and rim
RIM = ((1.4, 2.4), (1.3375, 2.53125), (1.4375, 2.53125), (1.5, 2.4))
SHOULDER = ((1.5, 2.4), (1.75, 1.875), (2.0, 1.35), (2.0, 0.9))
BELLY = ((2.0, 0.9), (2.0, 0.45), (1.5, 0.225), (1.5, 0.15))
BOTTOM = ((1.5, 0.15), (1.5, 0.075), (1.425, 0.0), (0.0, 0.0))

# A quarter of a circle as Newell drew it: 0.56 instead of the rounder 0.5523.
QUARTER = ((1.0, 0.0), (1.0, 0.56), (0.56, 1.0), (0.0, 1.0))

# Half of each patch pair; the other half mirrors the middle number. Rows of four (along, across, up).
HANDLE = (
    (((-1.6, 0, 2.025), (-1.6, -0.3, 2.025), (-1.5, -0.3, 2.25), (-1.5, 0, 2.25)),
     ((-2.3, 0, 2.025), (-2.3, -0.3, 2.025), (-2.5, -0.3, 2.25), (-2.5, 0, 2.25)),
     ((-2.7, 0, 2.025), (-2.7, -0.3, 2.025), (-3.0, -0.3, 2.25), (-3.0, 0, 2.25)),
     ((-2.7, 0, 1.8), (-2.7, -0.3, 1.8), (-3.0, -0.3, 1.8), (-3.0, 0, 1.8))),
    (((-2.7, 0, 1.8), (-2.7, -0.3, 1.8), (-3.0, -0.3, 1.8), (-3.0, 0, 1.8)),
     ((-2.7, 0, 1.575), (-2.7, -0.3, 1.575), (-3.0, -0.3, 1.35), (-3.0, 0, 1.35)),
     ((-2.5, 0, 1.125), (-2.5, -0.3, 1.125), (-2.65, -0.3, 0.9375), (-2.65, 0, 0.9375)),
     ((-2.0, 0, 0.9), (-2.0, -0.3, 0.9), (-1.9, -0.3, 0.6), (-1.9, 0, 0.6))),
)
SPOUT = (
    (((1.7, 0, 1.425), (1.7, -0.66, 1.425), (1.7, -0.66, 0.6), (1.7, 0, 0.6)),
     ((2.6, 0, 1.425), (2.6, -0.66, 1.425), (3.1, -0.66, 0.825), (3.1, 0, 0.825)),
     ((2.3, 0, 2.1), (2.3, -0.25, 2.1), (2.4, -0.25, 2.025), (2.4, 0, 2.025)),
     ((2.7, 0, 2.4), (2.7, -0.25, 2.4), (3.3, -0.25, 2.4), (3.3, 0, 2.4))),
    (((2.7, 0, 2.4), (2.7, -0.25, 2.4), (3.3, -0.25, 2.4), (3.3, 0, 2.4)),
     ((2.8, 0, 2.475), (2.8, -0.25, 2.475), (3.525, -0.25, 2.49375), (3.525, 0, 2.49375)),
     ((2.9, 0, 2.475), (2.9, -0.15, 2.475), (3.45, -0.15, 2.5125), (3.45, 0, 2.5125)),
     ((2.8, 0, 2.4), (2.8, -0.15, 2.4), (3.2, -0.15, 2.4), (3.2, 0, 2.4))),
)

# Rows of the texture (v from, v to) that each part is painted on; see glaze.py.
ROWS = {"body": (0.0, 0.60), "lid": (0.61, 0.80), "handle": (0.81, 0.88), "spout": (0.89, 0.99), "plain": (0.995, 0.999)}


def bernstein(t):
    """The four cubic Bernstein polynomials at t, and their derivatives: two (n, 4) arrays."""
    s = 1.0 - t
    values = np.stack([s ** 3, 3 * t * s * s, 3 * t * t * s, t ** 3], axis=1)
    slopes = np.stack([-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t], axis=1)
    return values, slopes


def patch_grid(control, along, across):
    """Points and unit normals (up to sign) of a bicubic patch with control (4, 4, 3) at a grid of parameters."""
    def normals(u, v):
        (bu, du), (bv, dv) = bernstein(u), bernstein(v)
        return np.cross(np.einsum("ui,vj,ijk->uvk", du, bv, control), np.einsum("ui,vj,ijk->uvk", bu, dv, control))

    points = np.einsum("ui,vj,ijk->uvk", bernstein(along)[0], bernstein(across)[0], control)
    # Where a whole edge collapses into a point the tangents vanish: take the normal of a step aside.
    inner = np.clip(along, 1e-4, 1.0 - 1e-4)
    return points, unit(normals(inner, across))


def arc_length(profile):
    """The length of a cubic curve and, at 65 equal parameters, the part of it covered so far."""
    points = bernstein(np.linspace(0.0, 1.0, 65))[0] @ np.array(profile)
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    return steps.sum(), np.concatenate([[0.0], np.cumsum(steps)]) / steps.sum()


def revolved(profile, signs, rows, columns, v_from, v_to):
    """A quarter patch of revolution; u runs 0 to 1 around the quarter, v with arc length along the profile."""
    radius, height = np.array(profile).T
    quarter = np.array(QUARTER) * np.array(signs)
    control = np.concatenate([radius[:, None, None] * quarter[None], np.broadcast_to(height[:, None, None], (4, 4, 1))], axis=2)
    along, across = np.linspace(0.0, 1.0, rows + 1), np.linspace(0.0, 1.0, columns + 1)
    points, normals = patch_grid(control, along, across)
    # The profiles run from the top down and outside is on their left, on either side of a mirror.
    normals *= signs[0] * signs[1]
    covered = np.interp(along, np.linspace(0.0, 1.0, 65), arc_length(profile)[1])
    uv = np.stack(np.broadcast_arrays(across[None, :], (v_from + (v_to - v_from) * covered)[:, None]), axis=-1)
    return points, normals, uv


def swept(control, mirror, rows, columns, v_from, v_to, part):
    """Half a patch of the handle or spout, the first (0) or second (1) part of it; u runs along, v across the half."""
    control = np.array(control, dtype=float) * np.array([1.0, mirror, 1.0])
    along, across = np.linspace(0.0, 1.0, rows + 1), np.linspace(0.0, 1.0, columns + 1)
    points, normals = patch_grid(control, along, across)
    middle = 0.5 * (points[:, :1] + points[:, -1:]) * np.array([1.0, 0.0, 1.0])
    sample = (normals * (points - middle)).sum(axis=-1).sum()
    normals *= np.sign(sample)
    uv = np.stack(np.broadcast_arrays((along[:, None] + part) / 2.0, v_from + (v_to - v_from) * across[None, :]), axis=-1)
    return points, normals, uv


def profile_rows():
    """The profiles with their tessellation and texture rows."""
    rows = []
    for part, names in (("lid", ((KNOB, 6), (LID, 5))), ("plain", ((SEAT, 1),)),
                        ("body", ((RIM, 3), (SHOULDER, 6), (BELLY, 6))), ("plain", ((BOTTOM, 2),))):
        low, high = ROWS[part]
        total = sum(arc_length(profile)[0] for profile, _ in names)
        at = low
        for profile, count in names:
            end = at + (high - low) * arc_length(profile)[0] / total
            rows.append((profile, count, at, end))
            at = end
    return rows


def spout_cap():
    """Closes the spout inside its lip, so that nobody looks into an empty shell."""
    control = np.array(SPOUT[1][3], dtype=float)
    half = bernstein(np.linspace(0.0, 1.0, 13))[0] @ control
    loop = np.concatenate([half, (half * [1.0, -1.0, 1.0])[-2:0:-1]])
    corners, normals, uvs, triangles = flat_polygon(loop)
    uvs = np.tile([0.5, np.mean(ROWS["plain"])], (len(uvs), 1))
    up = np.array([0.0, 0.0, 1.0])
    triangles = triangles if normals[0] @ up > 0 else triangles[:, ::-1]
    return corners, np.tile(up, (len(corners), 1)), uvs, triangles


def teapot_mesh(scale):
    """The whole teapot standing on y = 0, its spout towards +x; `scale` world units per unit of Newell's."""
    grids = []
    for profile, rows, v_from, v_to in profile_rows():
        for signs in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
            grids.append(revolved(profile, signs, rows, 8, v_from, v_to))
    for patches, part in ((HANDLE, "handle"), (SPOUT, "spout")):
        for index, control in enumerate(patches):
            for mirror in (1.0, -1.0):
                grids.append(swept(control, mirror, 8, 6, *ROWS[part], index))
    mesh = join([grid(*one) for one in grids] + [spout_cap()])
    # Newell's z is up; a turn about x (not a mirror) makes it y.
    upright = np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]], dtype=float)
    return mesh[0] @ upright * scale, mesh[1] @ upright, mesh[2], mesh[3]
