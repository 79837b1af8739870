"""The stone floor: irregular, slightly domed flagstones in sunken mortar, and their texture."""

import numpy as np

from surfaces import drop_degenerate, flat_polygon, join, unit
from textures import blend, encode_srgb, fractal, hashed, mix, noise, picture, smoothstep, surface_picture

CELLS = 20
LEFT, BACK, SIZE = -160.0, -180.0, 320.0
PITCH = SIZE / CELLS
GAP = 0.42    # half the width of a joint
DROP = 0.12   # from a stone's middle to its rim
DEPTH = 0.8   # from a stone's top to the mortar


def stone_center(column, row):
    """Where a stone's seed lies, in cells; outside the floor it mirrors the nearest inside, so the floor's edge is straight."""
    inside_c = np.where(column < 0, -1 - column, np.where(column >= CELLS, 2 * CELLS - 1 - column, column))
    inside_r = np.where(row < 0, -1 - row, np.where(row >= CELLS, 2 * CELLS - 1 - row, row))
    x = inside_c + 0.5 + 0.86 * (hashed(inside_c, inside_r, seed=1) - 0.5)
    z = inside_r + 0.5 + 0.86 * (hashed(inside_c, inside_r, seed=2) - 0.5)
    x = np.where(column < 0, -x, np.where(column >= CELLS, 2 * CELLS - x, x))
    z = np.where(row < 0, -z, np.where(row >= CELLS, 2 * CELLS - z, z))
    return x, z


def clip(polygon, normal, limit):
    """The part of a convex polygon where dot(normal, point) <= limit."""
    kept = []
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        da, db = normal @ a - limit, normal @ b - limit
        if da <= 0.0:
            kept.append(a)
        if da * db < 0.0:
            kept.append(a + (b - a) * (da / (da - db)))
    return kept


def stone_outline(column, row, inset):
    """A stone's Voronoi cell, shrunk by `inset`; counter-clockwise in (x, z) world units."""
    center = np.array(stone_center(column, row), dtype=float)
    polygon = [center + np.array(corner) for corner in ((-3.0, -3.0), (3.0, -3.0), (3.0, 3.0), (-3.0, 3.0))]
    for other_row in range(row - 2, row + 3):
        for other_column in range(column - 2, column + 3):
            if (other_column, other_row) == (column, row):
                continue
            other = np.array(stone_center(other_column, other_row), dtype=float)
            across = other - center
            length = np.sqrt(across @ across)
            normal = across / length
            polygon = clip(polygon, normal, normal @ (center + other) / 2.0 - inset / PITCH)
    return np.array(polygon) * PITCH + np.array([LEFT, BACK])


def floor_uv(points):
    """The floor texture's place of world points (..., 3)."""
    return np.stack([(points[..., 0] - LEFT) / SIZE, (points[..., 2] - BACK) / SIZE], axis=-1)


def stone(column, row):
    """One flagstone: slightly tilted and domed, so that its rim catches the light; the texture paints the mortar's edge."""
    rim = stone_outline(column, row, GAP)
    middle = rim.mean(axis=0)
    edge = np.roll(rim, -1, axis=0) - np.roll(rim, 1, axis=0)
    outward = unit(np.stack([edge[:, 1], -edge[:, 0]], axis=1))
    tilt = (np.array([hashed(column, row, seed=5), hashed(column, row, seed=6)]) - 0.5) * 0.05
    height = -0.15 + 0.3 * (hashed(column, row, seed=7) - 0.5)
    count = len(rim)
    up = unit([-tilt[0], 1.0, -tilt[1]])
    out3 = np.stack([outward[:, 0], np.zeros(count), outward[:, 1]], axis=1)
    y = height + (rim - middle) @ tilt - DROP
    positions = np.concatenate([np.stack([rim[:, 0], y, rim[:, 1]], axis=1), [[middle[0], height, middle[1]]]])
    normals = np.concatenate([unit(0.30 * out3 + up), [up]])
    k = np.arange(count)
    triangles = np.stack([k, np.roll(k, -1), np.full(count, count)], 1)
    return drop_degenerate((positions, normals, floor_uv(positions), triangles))


def slab():
    """The mortar bed and the four sides that close the floor's edge."""
    x0, x1, z0, z1 = LEFT, LEFT + SIZE, BACK, BACK + SIZE
    top, bottom = -DEPTH, -9.0
    ring = [(x0, z0), (x0, z1), (x1, z1), (x1, z0)]
    corners = [[(x, top, z) for x, z in ring]]
    for (xa, za), (xb, zb) in zip(ring, ring[1:] + ring[:1]):
        corners.append([(xa, top, za), (xa, bottom, za), (xb, bottom, zb), (xb, top, zb)])
    return join([flat_polygon(c, np.clip(floor_uv(np.array(c)), 0.001, 0.999)) for c in corners])


def floor_mesh():
    """All stones and the bed."""
    return join([stone(c, r) for r in range(CELLS) for c in range(CELLS)] + [slab()])


def nearest_stone(size):
    """For each texel: the nearest stone's column and row, and the distance to the joint, in world units."""
    axis = (np.arange(size) + 0.5) / size * CELLS
    x, z = np.meshgrid(axis, axis)
    home_c, home_r = np.floor(x).astype(int), np.floor(z).astype(int)
    first, second = np.full(x.shape, 1e9), np.full(x.shape, 1e9)
    column, row = home_c.copy(), home_r.copy()
    for dr in range(-2, 3):
        for dc in range(-2, 3):
            cx, cz = stone_center(home_c + dc, home_r + dr)
            distance = np.hypot(x - cx, z - cz)
            is_first = distance < first
            second = np.where(is_first, first, np.minimum(second, distance))
            column, row = np.where(is_first, home_c + dc, column), np.where(is_first, home_r + dr, row)
            first = np.where(is_first, distance, first)
    return column, row, (second - first) * 0.5 * PITCH


def round_pits(points):
    """Depth in [0, 1] of small round holes, at most one per unit cell, in every other cell on average."""
    home = np.floor(points)
    depth = np.zeros(points.shape[:-1])
    for dr in (-1, 0, 1):
        for dc in (-1, 0, 1):
            c, r = home[..., 0] + dc, home[..., 1] + dr
            distance = np.hypot(points[..., 0] - c - hashed(c, r, seed=62), points[..., 1] - r - hashed(c, r, seed=63))
            radius = 0.55 * hashed(c, r, seed=64) * (hashed(c, r, seed=65) > 0.5)
            depth = np.maximum(depth, smoothstep(radius + 0.08, radius - 0.16, distance) * (radius > 0.1))
    return depth


def floor_textures(size=1024):
    """Albedo and metallic-roughness pictures: stones of several greys, grain, pits, cracks, lichen and mortar."""
    column, row, joint = nearest_stone(size)
    axis = (np.arange(size) + 0.5) / size
    points = np.stack(np.meshgrid(axis, axis), axis=-1)
    tone, warmth = hashed(column, row, seed=11), hashed(column, row, seed=12)
    grain = fractal(points * 260.0, 2, seed=20)
    mottle = fractal(points * 45.0 + 9.0 * tone[..., None], 4, seed=30)
    weather = fractal(points * 7.0, 4, seed=40)

    value = (0.19 + 0.20 * tone ** 1.3) * (1.0 + 0.16 * grain + 0.40 * mottle + 0.30 * weather)
    color = value[..., None] * blend([0.90, 0.97, 1.08], [1.12, 1.0, 0.84], warmth)
    warped = points * 60.0 + 1.6 * np.stack([noise(points * 40.0, 50), noise(points * 40.0, 51)], axis=-1)
    vein = np.abs(noise(warped * 0.55 + 31.0 * tone[..., None], 52))
    crack = (1.0 - smoothstep(0.012, 0.05, vein)) * (hashed(column, row, seed=13) > 0.55)
    pits = round_pits(points * 150.0) * smoothstep(0.05, 0.40, fractal(points * 13.0, 3, 61))
    color *= ((1.0 - 0.6 * crack) * (1.0 - 0.75 * pits))[..., None]
    lichen = smoothstep(0.20, 0.50, fractal(points * 16.0 + 5.0, 4, seed=70)) * (0.35 + 0.65 * smoothstep(3.0, 0.5, joint))
    color = blend(color, color * [0.72, 0.95, 0.60], 0.8 * lichen)
    color *= mix(0.62, 1.0, smoothstep(0.4, 2.6, joint))[..., None]
    mortar = (0.085 * (1.0 + 0.5 * grain))[..., None] * np.array([0.95, 1.0, 0.95])
    is_joint = 1.0 - smoothstep(0.30, 0.62, joint)
    color = blend(color, mortar, is_joint)

    worn = hashed(column, row, seed=14)
    roughness = 0.33 + 0.30 * worn + 0.14 * mottle + 0.10 * weather + 0.20 * crack + 0.25 * pits + 0.10 * lichen
    roughness = np.clip(mix(roughness, 0.95, is_joint), 0.26, 1.0)
    roughness = np.round(roughness[::2, ::2] * 32.0) / 32.0
    return picture(encode_srgb(color)), surface_picture(roughness, 0.0)
