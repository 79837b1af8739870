"""Makes the demo scene's models and night sky out of arithmetic; the same bytes every time."""

import pathlib

import numpy as np
from PIL import Image

import glaze
import lamp
import paving
import sky
import surfaces
import teapot
from glb import Glb
from textures import blend, encode_srgb, fractal, picture, smoothstep

HERE = pathlib.Path(__file__).resolve().parent


def make_floor(path):
    """The flagstone floor; its stones' tops lie about y = 0."""
    model = Glb("floor")
    albedo, surface = paving.floor_textures()
    stone = model.material("flagstone", metallic=0.0, roughness=1.0, color_texture=model.texture(albedo, 86),
                           surface_texture=model.texture(surface))
    model.primitive(paving.floor_mesh(), stone)
    model.save(path)


def make_teapot(path):
    """The teapot, 60 units tall."""
    model = Glb("teapot")
    albedo, surface = glaze.teapot_textures()
    porcelain = model.material("glaze and silver", metallic=1.0, roughness=1.0, color_texture=model.texture(albedo, 88),
                               surface_texture=model.texture(surface))
    model.primitive(teapot.teapot_mesh(60.0 / 3.15), porcelain)
    model.save(path)


def make_sphere(path):
    """The crimson sphere, of radius 18 about its middle, with faint clouds in the lacquer."""
    height, width = 256, 512
    around, polar = np.meshgrid((np.arange(width) + 0.5) / width * 2 * np.pi, (np.arange(height) + 0.5) / height * np.pi)
    point = np.stack([np.sin(polar) * np.sin(around), np.cos(polar), np.sin(polar) * np.cos(around)], axis=-1)
    cloud = smoothstep(-0.5, 0.6, fractal(point * 2.5 + fractal(point * 2.0, 3, 301)[..., None], 5, seed=300))
    color = blend([0.38, 0.005, 0.028], [0.54, 0.010, 0.036], cloud)
    model = Glb("sphere")
    lacquer = model.material("crimson lacquer", metallic=0.0, roughness=0.16,
                             color_texture=model.texture(picture(encode_srgb(color)), 88))
    model.primitive(surfaces.sphere(18.0, 18, 36), lacquer)
    model.save(path)


def make_lamp(path):
    """The crook from the origin up, the lantern in it, its panes glowing."""
    model = Glb("lamp")
    albedo, surface = lamp.bronze_textures()
    bronze = model.material("bronze", metallic=1.0, roughness=1.0, color_texture=model.texture(albedo, 88),
                            surface_texture=model.texture(surface))
    iron = model.material("iron", color=(0.050, 0.042, 0.040), metallic=0.6, roughness=0.42)
    emission, glass = lamp.pane_textures()
    panes = model.material("panes", roughness=0.35, color_texture=model.texture(glass, 88), emissive=(1, 1, 1),
                           emissive_texture=model.texture(emission, 90), emissive_strength=5.0)
    middle = (*lamp.LANTERN, 0.0)
    model.primitive(lamp.crook_mesh(), bronze)
    model.primitive(surfaces.moved(lamp.lantern_frame(), middle), iron)
    model.primitive(surfaces.moved(lamp.lantern_panes(), middle), panes)
    model.save(path)


def make_sky(folder, size=512):
    """The six faces of the night sky."""
    catalogue = sky.stars(5200)
    for face in sky.FACES:
        Image.fromarray(sky.sky_face(face, size, catalogue), "RGB").save(folder / f"{face}.png", optimize=True)


def main():
    """Writes models/ and sky/ beside this script."""
    for folder in ("models", "sky"):
        (HERE / folder).mkdir(exist_ok=True)
    make_floor(HERE / "models/floor.glb")
    make_teapot(HERE / "models/teapot.glb")
    make_sphere(HERE / "models/sphere.glb")
    make_lamp(HERE / "models/lamp.glb")
    make_sky(HERE / "sky")


if __name__ == "__main__":
    main()
