"""The teapot's decoration: silver bands, triangles, lozenges, flowers and leaves on a blue-black glaze."""

import numpy as np

from teapot import ROWS
from textures import blend, encode_srgb, fractal, ink, mix, picture, surface_picture

PEN = 0.0042  # half a line's width, in quarters of the pot's girth


def fold(x, count):
    """x in [0, 1] folded into `count` mirrored cells: the distance to the cell's middle, in units of x."""
    return (np.mod(x * count, 1.0) - 0.5) / count


def stroke(distance, half_width, texel):
    """Coverage of a line of that half width about a curve at zero distance."""
    return ink(np.abs(distance) - half_width, texel)


def dots(x, y, center, count, radius, texel):
    """A row of `count` dots around the quarter."""
    return ink(np.hypot(fold(x, count), y - center) - radius, texel)


def triangles(x, y, top, bottom, count, texel):
    """A row of filled triangles pointing down, outlined ones pointing up between them."""
    cell, height = 1.0 / count, bottom - top
    slope = (y - top) / height
    inside = (slope >= 0.0) & (slope <= 1.0)
    edge = np.abs(fold(x, count)) - 0.5 * cell * (1.0 - slope)
    filled = ink(edge + 1.7 * PEN, texel) * inside
    small = np.abs(fold(x + 0.5 * cell, count)) - 0.5 * cell * (slope - 0.38)
    return np.maximum(filled, ink(small + 1.2 * PEN, texel) * inside * (slope < 0.86))


def lozenges(x, y, center, half_height, count, texel):
    """A row of outlined lozenges with a dot in each and dots between."""
    half = 0.5 / count
    shape = (np.abs(fold(x, count)) / half + np.abs(y - center) / half_height - 1.0) * half * 0.7
    outline = stroke(shape, 0.9 * PEN, texel)
    kernel = ink(shape + 0.45 * half, texel)
    between = ink(np.minimum(np.hypot(fold(x + half, count), y - center - 0.72 * half_height),
                             np.hypot(fold(x + half, count), y - center + 0.72 * half_height)) - 1.7 * PEN, texel)
    return np.maximum(np.maximum(outline, kernel), between)


def leaves(x, y, top, length, count, texel):
    """A row of pointed leaves hanging from `top`, each with an inner leaf and a midrib."""
    across = np.abs(fold(x, count))
    t = np.clip((y - top) / length, 0.0, 1.0)
    width = 0.47 / count * np.sin(np.pi * np.clip(0.30 + 0.70 * t, 0.0, 1.0)) ** 0.8
    hung = (y >= top) & (y <= top + length * 1.02)
    outline = stroke(across - width, 1.1 * PEN, texel)
    inner = ink(across - 0.52 * width + 1.5 * PEN, texel) * (t < 0.80)
    rib = ink(across - 0.8 * PEN, texel)
    return np.maximum(outline, inner * (1.0 - rib)) * hung


def flowers(x, y, center, radius, count, texel):
    """A row of outlined five-petalled flowers with a heart and a ring of stamens."""
    dx, dy = fold(x, count), y - center
    r, angle = np.hypot(dx, dy), np.arctan2(dx, -dy)
    sector = np.abs(np.mod(angle / (2.0 * np.pi) * 5.0 + 0.5, 1.0) - 0.5) * 2.0 * np.pi / 5.0
    px, py = r * np.sin(sector), r * np.cos(sector)
    petal = np.hypot(px, py - 0.62 * radius) - 0.40 * radius
    outside = np.where(r < 0.3 * radius, 1.0, petal)
    drawn = np.maximum(stroke(outside, 1.1 * PEN, texel), ink(np.hypot(px, py - 0.66 * radius) - 0.20 * radius, texel))
    drawn = np.maximum(drawn, ink(r - 0.17 * radius, texel))
    return np.maximum(drawn, stroke(r - 0.27 * radius, 0.6 * PEN, texel))


def vine(x, y, center, swing, count, texel):
    """A wave around the pot with a bud in every bend."""
    phase = 2.0 * np.pi * count * x
    wave = (y - center - swing * np.cos(phase)) / np.sqrt(1.0 + (2.0 * np.pi * count * swing * np.sin(phase)) ** 2)
    bud_low = np.hypot(fold(x + 0.5 / count, count), y - center - 0.15 * swing) - 0.55 * swing
    bud_high = np.hypot(fold(x, count), y - center + 0.15 * swing) - 0.55 * swing
    return np.maximum(stroke(wave, PEN, texel), ink(np.minimum(bud_low, bud_high), texel))


def combined(*coverages):
    """The union of what was drawn."""
    return np.maximum.reduce(coverages)


def body_ink(x, y, texel):
    """The pot from its rim (y = 0) to its foot (y = 0.93, in quarters of the girth)."""
    lines = [0.020, 0.125, 0.142, 0.465, 0.482, 0.585, 0.597, 0.690, 0.702, 0.800, 0.812, 0.885]
    bands = np.maximum.reduce([stroke(y - line, 0.75 * PEN, texel) for line in lines])
    return combined(bands, dots(x, y, 0.060, 16, 0.010, texel), leaves(x, y, 0.150, 0.135, 8, texel),
                    dots(x, y, 0.302, 8, 0.008, texel), flowers(x, y, 0.375, 0.066, 4, texel),
                    dots(x + 0.125, y, 0.345, 4, 0.011, texel), dots(x + 0.125, y, 0.405, 4, 0.016, texel),
                    dots(x, y, 0.4735, 48, 0.0045, texel),
                    triangles(x, y, 0.496, 0.572, 12, texel), lozenges(x, y, 0.6435, 0.036, 10, texel),
                    triangles(x, y, 0.714, 0.788, 12, texel), vine(x, y, 0.848, 0.018, 8, texel),
                    dots(x, y, 0.905, 24, 0.006, texel))


def lid_ink(x, y, texel):
    """The knob (y = 0) and the lid down to its edge (y = 1); x is one quarter of the way around."""
    # Towards the middle a quarter gets narrower; heights are scaled to keep the flowers near the edge round.
    h = 1.54 * (y - 0.45)
    drawn = [stroke(y - at, 0.008, texel * 2.0) for at in (0.10, 0.20, 0.415, 0.455, 0.94, 0.97)]
    drawn += [leaves(x, h, 0.04, 0.40, 8, texel), flowers(x, h, 0.59, 0.088, 4, texel),
              dots(x + 0.125, h, 0.60, 4, 0.020, texel), dots(x, y, 0.30, 4, 0.045, texel * 1.5)]
    return combined(*drawn)


def handle_ink(x, y, texel):
    """A strap of lozenges between two lines; y runs along the handle, which is three times as long as wide."""
    t = 3.4 * y
    shape = np.abs(np.mod(t * 5.0, 1.0) - 0.5) * 2.0 + np.abs(x - 0.5) / 0.30 - 1.0
    drawn = [stroke(shape, 0.10, 0.06), ink(shape + 0.55, 0.06), stroke(x - 0.13, 0.018, texel), stroke(x - 0.87, 0.018, texel)]
    return combined(*drawn) * (y > 0.05) * (y < 0.95)


def spout_ink(x, y, texel):
    """Triangles and leaves climbing the spout from its root (y = 0) to its lip (y = 1)."""
    drawn = [stroke(y - at, 0.007, texel) for at in (0.22, 0.25, 0.44, 0.47, 0.62, 0.88, 0.91)]
    wide = 0.25 * x
    drawn += [triangles(x, 0.9 * (y - 0.27), 0.0, 0.14, 5, texel), dots(x, 0.6 * (y - 0.545), 0.0, 6, 0.028, texel),
              np.maximum(stroke(np.abs(wide - 0.125) - 0.07 * (1.0 - (y - 0.63) / 0.24), 0.010, texel),
                         ink(np.hypot(wide - 0.125, 0.5 * (y - 0.69)) - 0.018, texel)) * (y > 0.63) * (y < 0.87)]
    return combined(*drawn)


def teapot_textures(size=1024):
    """Albedo and metallic-roughness pictures of all parts, drawn at twice the size and averaged."""
    fine = 2 * size
    x = np.broadcast_to(((np.arange(fine) + 0.5) / fine)[None, :], (fine, fine))
    v = np.broadcast_to(((np.arange(fine) + 0.5) / fine)[:, None], (fine, fine))
    silver = np.zeros((fine, fine))
    for part, draw, extent in (("body", body_ink, 0.93), ("lid", lid_ink, 1.0), ("handle", handle_ink, 1.0), ("spout", spout_ink, 1.0)):
        low, high = ROWS[part]
        rows = slice(int(low * fine), int(high * fine))
        across = (v[rows] - low) / (high - low) * extent
        silver[rows] = draw(across, x[rows], 3.0 / size) if part in ("handle", "spout") else draw(x[rows], across, 1.5 / size)
    silver = silver.reshape(size, 2, size, 2).mean(axis=(1, 3))
    axis = (np.arange(size) + 0.5) / size
    points = np.stack(np.meshgrid(np.abs(axis - 0.5), axis), axis=-1)
    tarnish = fractal(points * 24.0, 4, seed=80)
    glaze = np.array([0.010, 0.013, 0.040]) * (1.0 + 0.25 * tarnish)[..., None]
    metal = np.array([0.72, 0.75, 0.82]) * (1.0 + 0.14 * tarnish)[..., None]
    roughness = np.round(mix(0.30, 0.24, silver) * 64.0) / 64.0
    return picture(encode_srgb(blend(glaze, metal, silver))), surface_picture(roughness, np.round(0.62 * silver * 32.0) / 32.0)
