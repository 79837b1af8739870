"""The night sky as six cube faces: gradient, misty ridges, milky way, stars and moon, all functions of direction."""

import numpy as np

from surfaces import unit
from textures import blend, encode_srgb, fractal, hashed, noise, smoothstep

MOON = np.array([-0.75, 0.75, 0.75]) / np.sqrt(3 * 0.75 ** 2)  # where the moonlight comes from
GALAXY = np.array([0.42, 0.55, -0.72])  # the milky way lies around the circle this is the axis of
FACES = ("px", "nx", "py", "ny", "pz", "nz")


def face_directions(face, size):
    """The direction through each texel's center, in OpenGL's cube orientation, first row first."""
    axis = (np.arange(size) + 0.5) / size * 2.0 - 1.0
    s, t = np.meshgrid(axis, axis)
    one = np.ones_like(s)
    return unit(np.stack({"px": (one, -t, -s), "nx": (-one, -t, s), "py": (s, one, t),
                          "ny": (s, -one, -t), "pz": (s, -t, one), "nz": (-s, -t, -one)}[face], axis=-1))


def stars(count):
    """Directions, brightness and color of the stars: few bright ones, many faint, more of them in the milky way."""
    index = np.arange(4 * count)
    height = 2.0 * hashed(index, seed=201) - 1.0
    around = 2.0 * np.pi * hashed(index, seed=202)
    flat = np.sqrt(1.0 - height ** 2)
    direction = np.stack([flat * np.cos(around), height, flat * np.sin(around)], axis=1)
    band = np.exp(-(direction @ unit(GALAXY) / 0.22) ** 2)
    kept = np.flatnonzero(hashed(index, seed=203) < 0.22 + 0.5 * band)[:count]
    direction = direction[kept]
    brightness = 0.05 / (0.012 + hashed(kept, seed=204)) ** 0.85
    warmth = hashed(kept, seed=205)
    color = blend(blend([0.62, 0.76, 1.0], [1.0, 1.0, 1.0], smoothstep(0.0, 0.5, warmth)), [1.0, 0.78, 0.52], smoothstep(0.7, 1.0, warmth))
    return direction, np.minimum(brightness, 1.6), color


def star_light(direction, size, catalogue):
    """Each star as a small round spot, wider when brighter; drawn only around the texels it covers."""
    light = np.zeros(direction.shape)
    texel = (np.pi / 2.0) / size
    # The face's own axes: the direction of its middle, and those in which columns and rows grow.
    middle = direction[size // 2 - 1:size // 2 + 1, size // 2 - 1:size // 2 + 1].mean(axis=(0, 1)).round()
    right = np.sign((direction[0, -1] - direction[0, 0]).round(3))
    down = np.sign((direction[-1, 0] - direction[0, 0]).round(3))
    for star, brightness, color in zip(*catalogue):
        depth = star @ middle
        if depth < 0.5:
            continue
        column = int((star @ right / depth + 1.0) * 0.5 * size)
        row = int((star @ down / depth + 1.0) * 0.5 * size)
        if not (-6 <= column < size + 6 and -6 <= row < size + 6):
            continue
        rows, columns = slice(max(row - 6, 0), row + 7), slice(max(column - 6, 0), column + 7)
        offset = np.linalg.norm(direction[rows, columns] - star, axis=-1) / texel
        width = 0.55 + 0.32 * brightness
        spot = brightness * np.exp(-(offset / width) ** 2)
        if brightness > 0.9:
            spot = spot + 0.05 * brightness * np.exp(-(offset / 2.2) ** 2)
        light[rows, columns] += spot[..., None] * color
    return light


def dome(direction):
    """Gradient, glow above the ridges, and the milky way's cloud."""
    y = direction[..., 1]
    height = np.degrees(np.arcsin(np.clip(y, -1.0, 1.0)))
    color = blend([0.0100, 0.0165, 0.046], [0.0024, 0.0042, 0.0150], smoothstep(-12.0, 60.0, height))
    side = 0.72 + 0.28 * (direction @ unit(np.array([0.35, 0.0, -1.0])))
    glow = np.exp(-((height + 13.5) / 7.5) ** 2) * side
    color = color + glow[..., None] * np.array([0.018, 0.034, 0.062])
    across = direction @ unit(GALAXY)
    cloud = fractal(direction * 5.0 + 11.0, 5, seed=210)
    dust = fractal(direction * 8.0 + 3.0, 4, seed=220)
    band = np.exp(-((across + 0.05 * cloud) / 0.16) ** 2) * np.clip(0.60 + 0.9 * cloud, 0.0, 2.0)
    band = band * (1.0 - 0.8 * np.exp(-((across - 0.02 + 0.10 * dust) / 0.045) ** 2))
    return color + band[..., None] * np.array([0.015, 0.017, 0.027])


def ridges(direction, color):
    """Three mountain ranges far below, each nearer one darker, with mist between; and whether the sky is still open."""
    height = np.degrees(np.arcsin(np.clip(direction[..., 1], -1.0, 1.0)))
    ground = unit(direction * [1.0, 0.0, 1.0])
    is_open = np.ones(height.shape)
    for k, (base, rise, rock, mist) in enumerate(((-12.6, 2.3, (0.0130, 0.0235, 0.0460), (0.026, 0.046, 0.082)),
                                                  (-14.8, 1.9, (0.0070, 0.0135, 0.0290), (0.017, 0.031, 0.058)),
                                                  (-17.6, 2.0, (0.0030, 0.0060, 0.0140), (0.008, 0.016, 0.031)))):
        outline = fractal(ground * (5.0 + 2.0 * k) + 17.0 * k, 5, seed=230 + 10 * k)
        crest = base + rise * (outline + 0.55 * np.abs(noise(ground * (9.0 + 2.0 * k), 260 + k)))
        cover = smoothstep(-0.10, 0.10, crest - height)
        deep = smoothstep(0.0, 4.5, crest - height)
        color = blend(color, blend(rock, mist, deep), cover)
        is_open = is_open * (1.0 - cover)
    abyss = smoothstep(-18.0, -55.0, height)
    return blend(color, [0.0012, 0.0022, 0.0060], abyss), is_open


def moon_disc(direction):
    """The moon's disc with its dark seas, and its halo."""
    angle = np.degrees(np.arccos(np.clip(direction @ MOON, -1.0, 1.0)))
    disc = 1.0 - smoothstep(2.05, 2.30, angle)
    seas = smoothstep(-0.1, 0.4, fractal(direction * 38.0, 3, seed=290))
    halo = 0.10 * np.exp(-angle / 3.0) + 0.03 * np.exp(-angle / 11.0)
    face = blend([0.92, 0.94, 0.98], [0.55, 0.60, 0.70], seas)
    return face * disc[..., None], halo[..., None] * np.array([0.55, 0.72, 1.0]), disc


def sky_face(face, size, catalogue):
    """One face as 8-bit sRGB, dithered so that the dark gradients show no bands."""
    direction = face_directions(face, size)
    color, is_open = ridges(direction, dome(direction))
    disc, halo, cover = moon_disc(direction)
    fade = is_open * smoothstep(-15.0, -5.0, np.degrees(np.arcsin(np.clip(direction[..., 1], -1.0, 1.0))))
    lit = color + halo + star_light(direction, size, catalogue) * (fade * (1.0 - cover) * 0.75)[..., None]
    lit = blend(lit, disc, cover)
    row, column = np.mgrid[0:size, 0:size]
    dither = hashed(row, column, FACES.index(face), seed=299)[..., None] - 0.5
    return np.floor(np.clip(encode_srgb(lit) * 255.0 + dither + 0.5, 0.0, 255.0)).astype(np.uint8)
