"""The lamp: a crook of twisted dark bronze, a chain, and a six-sided lantern with glowing panes."""

import numpy as np

from surfaces import flat_polygon, join, moved, scaled, sphere, torus, tube
from textures import blend, encode_srgb, fractal, hashed, mix, noise, picture, smoothstep, surface_picture

LANTERN = (25.0, 44.0)  # the middle of the lantern, in the plane of the crook; its foot is the origin
SIZE = 0.86  # of the lantern, as a part of the measures below

# Where the crook goes: up in a lazy S, over, down and around into a curl.
CROOK = ((0.0, -1.0), (1.6, 6.0), (6.2, 16.0), (8.4, 27.0), (6.0, 40.0), (2.2, 53.0), (0.6, 65.0), (2.4, 76.0),
         (8.6, 84.6), (18.0, 88.6), (28.0, 87.4), (35.6, 81.6), (38.4, 73.6), (36.2, 66.4), (30.6, 62.8),
         (25.0, 63.4), (21.8, 67.8), (22.8, 72.8), (26.6, 75.0), (29.6, 73.0), (29.4, 70.2))


def spline(points, per_span):
    """A Catmull-Rom curve through the points."""
    p = np.asarray(points, dtype=float)
    p = np.concatenate([2 * p[:1] - p[1:2], p, 2 * p[-1:] - p[-2:-1]])
    t = np.arange(per_span)[:, None] / per_span
    spans = []
    for a, b, c, d in zip(p, p[1:], p[2:], p[3:]):
        spans.append(0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t ** 2 + (3 * b - a - 3 * c + d) * t ** 3))
    return np.concatenate(spans + [p[-2:-1]])


def crook_mesh():
    """The tapered, fluted post with a flared foot, collars along the stem and a bead at the end of the curl."""
    line = spline(CROOK, 5)
    center = np.column_stack([line, np.zeros(len(line))])
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(center, axis=0), axis=1))])
    part = along / along[-1]
    radius = 2.75 * (1.0 - part) ** 0.75 + 0.75 + 2.8 * np.exp(-along / 2.6)
    for collar in (0.10, 0.245, 0.40, 0.555, 0.70, 0.83):
        radius *= 1.0 + 0.26 * np.exp(-((along - collar * along[-1]) / 0.9) ** 2)
    flutes = tube(center, radius, 20, lambda s, angle: 0.075 * np.cos(5.0 * angle + 0.16 * s))
    bead = moved(sphere(1.55, 10, 16), center[-1])
    foot = stacked_rings(6, [(7.4, -0.6), (7.4, 0.9), (6.2, 1.6)], close_top=True)
    return join([flutes, bead, foot])


def hexagon(radius, height, sides=6):
    """The corners of a level regular polygon with a side towards +z, counter-clockwise seen from above."""
    angle = (np.arange(sides) + 0.5) * 2.0 * np.pi / sides + np.pi / 2.0
    return np.stack([radius * np.cos(angle), np.full(sides, float(height)), -radius * np.sin(angle)], axis=1)


def stacked_rings(sides, profile, close_top=False, close_bottom=False):
    """Flat faces between polygons of (radius, height), listed from the bottom up."""
    rings = [hexagon(radius, height, sides) for radius, height in profile]
    faces = []
    for low, high in zip(rings, rings[1:]):
        for k in range(sides):
            n = (k + 1) % sides
            faces.append(flat_polygon([low[k], low[n], high[n], high[k]], [(0, 0), (0.3, 0), (0.3, 0.3), (0, 0.3)]))
    if close_top:
        faces.append(flat_polygon(rings[-1]))
    if close_bottom:
        faces.append(flat_polygon(rings[0][::-1]))
    return join(faces)


def bar(start, end, width):
    """A square bar between two points, one edge outward from the y axis."""
    start, end = np.asarray(start, dtype=float), np.asarray(end, dtype=float)
    outward = np.array([start[0] + end[0], 0.0, start[2] + end[2]])
    outward /= np.linalg.norm(outward)
    side = np.cross([0.0, 1.0, 0.0], outward)
    corners = [outward * width, side * width, -outward * width, -side * width]
    faces = []
    for a, b in zip(corners, corners[1:] + corners[:1]):
        faces.append(flat_polygon([start + a, start + b, end + b, end + a]))
    return join(faces)


def lantern_frame():
    """Base, corner bars, waist rails, two-tiered roof with knob, and the chain up to the crook; about the lantern's middle."""
    base = stacked_rings(6, [(1.2, -11.2), (2.6, -9.9), (2.6, -9.0), (4.2, -8.2), (6.3, -7.8), (6.3, -6.6), (5.2, -6.2)],
                         close_top=True, close_bottom=True)
    roof = stacked_rings(6, [(6.4, 6.2), (8.4, 6.6), (8.4, 7.4), (5.2, 10.0), (3.2, 10.6), (3.2, 11.8), (4.2, 12.1), (1.5, 14.4), (0.9, 15.2)],
                         close_top=True, close_bottom=True)
    low, high = hexagon(5.15, -6.3), hexagon(6.75, 6.3)
    bars = [bar(a, b, 0.62) for a, b in zip(low, high)]
    finial = moved(sphere(1.0, 8, 12), (0, 15.6, 0))
    lantern = scaled(join([base, roof, finial] + bars), SIZE)
    links = [moved(torus(0.72, 0.20, 1.45, turn), (0, 14.6 + 1.72 * k, 0)) for k, turn in enumerate([0.0, np.pi / 2.0] * 2)]
    return join([lantern] + links)


def lantern_panes():
    """Six panes just inside the bars, each with the whole pane picture."""
    low, high = hexagon(4.9, -6.3), hexagon(6.5, 6.3)
    corners = [(0.02, 0.98), (0.98, 0.98), (0.98, 0.02), (0.02, 0.02)]
    faces = [flat_polygon([low[k], low[(k + 1) % 6], high[(k + 1) % 6], high[k]], corners) for k in range(6)]
    return scaled(join(faces), SIZE)


def pane_textures(size=256):
    """Emission and albedo of leaded glass: bright cells, hot in the middle, between dark lines."""
    count = 5
    axis = (np.arange(size) + 0.5) / size
    u, v = np.meshgrid(axis, axis)
    x, y = u * count * 0.8, v * count
    home_c, home_r = np.floor(x), np.floor(y)
    first, second, tone = np.full(x.shape, 9.0), np.full(x.shape, 9.0), np.zeros(x.shape)
    for dr in range(-2, 3):
        for dc in range(-2, 3):
            c, r = home_c + dc, home_r + dr
            cx = c + 0.5 + 0.5 * np.mod(r, 2) - 0.25 + 0.45 * (hashed(c, r, seed=3) - 0.5)
            cy = r + 0.5 + 0.45 * (hashed(c, r, seed=4) - 0.5)
            distance = np.hypot(x - cx, y - cy)
            is_first = distance < first
            second = np.where(is_first, first, np.minimum(second, distance))
            tone = np.where(is_first, hashed(c, r, seed=5), tone)
            first = np.where(is_first, distance, first)
    glass = smoothstep(0.05, 0.13, second - first)
    flame = np.exp(-((u - 0.5) / 0.42) ** 2 - ((v - 0.58) / 0.50) ** 2)
    glow = (0.26 + 0.74 * flame) * (0.72 + 0.28 * tone) * (0.75 + 0.25 * smoothstep(0.0, 0.5, second - first))
    color = blend([1.0, 0.36, 0.055], [1.0, 0.56, 0.14], flame * (0.6 + 0.4 * tone))
    emission = color * (glow * glass + 0.012)[..., None]
    albedo = blend([0.03, 0.025, 0.02], [0.25, 0.16, 0.06], glass)
    return picture(encode_srgb(emission)), picture(encode_srgb(albedo))


def bronze_textures(width=256, height=512):
    """Dark bronze with brown and verdigris patina along the post."""
    u, v = np.meshgrid((np.arange(width) + 0.5) / width, (np.arange(height) + 0.5) / height)
    angle = 2.0 * np.pi * u
    points = np.stack([1.6 * np.cos(angle), 1.6 * np.sin(angle), 26.0 * v], axis=-1)
    patina = smoothstep(0.02, 0.45, fractal(points, 4, seed=90))
    streak = fractal(points * [3.0, 3.0, 0.7], 3, seed=95)
    speck = noise(points * 9.0, seed=99)
    color = blend([0.235, 0.165, 0.095], [0.085, 0.105, 0.085], patina) * (1.0 + 0.30 * streak + 0.12 * speck)[..., None]
    roughness = np.round((0.36 + 0.24 * patina + 0.08 * streak) * 32.0) / 32.0
    metallic = np.round(mix(0.75, 0.15, patina) * 16.0) / 16.0
    return picture(encode_srgb(color)), surface_picture(roughness[::2, ::2], metallic[::2, ::2])
