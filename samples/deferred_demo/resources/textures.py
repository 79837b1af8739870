"""Arithmetic pictures: lattice noise, coverage of drawn shapes, and conversion to 8-bit images."""

import numpy as np
from PIL import Image


def hashed(*integers, seed=0):
    """A repeatable pseudo-random number in [0, 1) for each tuple of integers."""
    mixed = np.full(1, seed * 747796405 + 2891336453 & 0xFFFFFFFF, dtype=np.uint32)
    for value in integers:
        mixed = np.asarray(value).astype(np.int64).astype(np.uint32) ^ mixed
        mixed = (mixed ^ (mixed >> np.uint32(16))) * np.uint32(0x7FEB352D)
        mixed = (mixed ^ (mixed >> np.uint32(15))) * np.uint32(0x846CA68B)
        mixed = mixed ^ (mixed >> np.uint32(16))
    shape = np.broadcast_shapes(*(np.shape(value) for value in integers))
    return mixed.astype(float).reshape(shape) / 4294967296.0


def smoothstep(low, high, x):
    """0 below low, 1 above high, a cubic between."""
    t = np.clip((x - low) / (high - low), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def mix(a, b, amount):
    """a where amount is 0, b where it is 1."""
    return a * (1.0 - amount) + b * amount


def blend(a, b, amount):
    """Colors (..., 3): a where amount (...) is 0, b where it is 1."""
    return mix(np.asarray(a), np.asarray(b), np.asarray(amount)[..., None])


def noise(points, seed=0):
    """Value noise in [-1, 1] of points (..., 2 or 3), one feature per unit."""
    base = np.floor(points)
    f = points - base
    f = f * f * f * (f * (f * 6.0 - 15.0) + 10.0)
    total = 0.0
    for corner in np.ndindex(*(2,) * points.shape[-1]):
        weight = np.prod(np.where(np.array(corner) == 1, f, 1.0 - f), axis=-1)
        total = total + weight * hashed(*(base[..., k] + corner[k] for k in range(points.shape[-1])), seed=seed)
    return 2.0 * total - 1.0


def fractal(points, octaves, seed=0):
    """A sum of octaves of noise, each of half the size and half the strength; about [-1, 1]."""
    return sum(noise(points * 2.0 ** k, seed + k) * 0.5 ** k for k in range(octaves)) / (2.0 - 0.5 ** (octaves - 1))


def ink(distance, width):
    """Coverage of a shape given its signed distance and the width of one texel."""
    return np.clip(0.5 - distance / width, 0.0, 1.0)


def encode_srgb(linear):
    """Linear [0, 1] to sRGB-encoded [0, 1]."""
    linear = np.clip(linear, 0.0, 1.0)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1.0 / 2.4) - 0.055)


def picture(values):
    """An 8-bit Pillow picture of (rows, columns, 3) values in [0, 1]."""
    return Image.fromarray(np.floor(np.clip(values, 0.0, 1.0) * 255.0 + 0.5).astype(np.uint8), "RGB")


def surface_picture(roughness, metallic):
    """glTF's metallic-roughness picture: roughness in green, metallic in blue."""
    return picture(np.stack(np.broadcast_arrays(0.0 * roughness, roughness, metallic), axis=-1))
