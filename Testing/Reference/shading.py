# SPDX-License-Identifier: BSD-3-Clause
"""The Mitsuba scene of a description, and how VTK shades a point of it.

Needs the environment that make_environment makes; importing it sets Mitsuba's variant.

Side and shading are VTK's: the winding of a triangle decides which side a ray sees, the vertices'
normal is turned to that side, and light counts by its cosine to that normal when it comes from that
side of the triangle. A surface that is lit from behind is dark.
"""

from __future__ import annotations

import math
from typing import Any

import mitsuba as mi
import numpy as np

import description

VARIANT = "llvm_ad_rgb"
mi.set_variant(VARIANT)

import drjit as dr  # noqa: E402  needs the variant

# The scene ----------------------------------------------------------------------------------------


class VTKLight(mi.Emitter):
    """A positional light of VTK that no built-in emitter equals.

    Its irradiance on a surface that faces it is `irradiance` times cos^exponent inside a cone with
    a hard edge, divided by c + l d + q d^2.
    """

    def __init__(self, properties: mi.Properties) -> None:
        mi.Emitter.__init__(self, properties)
        self.position = mi.ScalarPoint3f(properties["position"])
        self.direction = mi.ScalarVector3f(properties["direction"])
        self.irradiance = mi.ScalarColor3f(properties["irradiance"])
        self.attenuation = list(mi.ScalarVector3f(properties["attenuation"]))
        self.cutoff = float(properties["cutoff"])
        self.exponent = float(properties["exponent"])
        self.m_flags = mi.EmitterFlags.DeltaPosition

    def sample_direction(self, reference: Any, _sample: Any, active: Any = True) -> tuple[Any, Any]:
        offset = mi.Point3f(self.position) - reference.p
        distance = dr.norm(offset)
        sample = dr.zeros(mi.DirectionSample3f)
        sample.p = mi.Point3f(self.position)
        sample.dist = distance
        sample.d = offset / distance
        sample.n = -sample.d
        sample.time = reference.time
        sample.pdf = 1.0
        sample.delta = True
        constant, linear, quadratic = self.attenuation
        cosine = -dr.dot(sample.d, mi.Vector3f(self.direction))
        value = 1.0 / (constant + distance * (linear + distance * quadratic))
        if self.exponent > 0.0:
            value *= dr.power(dr.maximum(cosine, 0.0), self.exponent)
        value = dr.select(active & (cosine >= self.cutoff), value, 0.0)
        return sample, mi.Color3f(self.irradiance) * value

    # A ray never meets a point.

    def eval(self, _interaction: Any, _active: Any = True) -> Any:
        return mi.Color3f(0.0)

    def eval_direction(self, _reference: Any, _sample: Any, _active: Any = True) -> Any:
        return mi.Color3f(0.0)

    def pdf_direction(self, _reference: Any, _sample: Any, _active: Any = True) -> Any:
        return mi.Float(0.0)

    def bbox(self) -> mi.ScalarBoundingBox3f:
        return mi.ScalarBoundingBox3f(self.position)


mi.register_emitter("vtk_light", VTKLight)


def make_emitter(values: dict[str, Any]) -> dict[str, Any]:
    """Return Mitsuba's dictionary for an emitter of `description.emitter`."""

    def rgb(key: str) -> dict[str, Any]:
        return {"type": "rgb", "value": values[key]}

    kind = values["type"]
    if kind == "directional":
        return {"type": kind, "direction": values["direction"], "irradiance": rgb("irradiance")}
    if kind == "point":
        return {"type": kind, "position": values["position"], "intensity": rgb("intensity")}
    if kind == "spot":
        x, y, z = np.abs(values["direction"])
        up = [1.0, 0.0, 0.0] if x < max(y, z) else [0.0, 1.0, 0.0]
        target = [p + d for p, d in zip(values["position"], values["direction"])]
        look = mi.ScalarTransform4f().look_at(values["position"], target, up)
        return {
            "type": kind,
            "to_world": look,
            "intensity": rgb("intensity"),
            "cutoff_angle": values["cone"],
            "beam_width": values["cone"],
        }
    cone = values["cone"]
    return {
        "type": kind,
        "position": mi.ScalarVector3f(values["position"]),
        "direction": mi.ScalarVector3f(values["direction"]),
        "irradiance": mi.ScalarVector3f(values["irradiance"]),
        "attenuation": mi.ScalarVector3f(values["attenuation"]),
        "cutoff": -2.0 if cone is None else math.cos(math.radians(cone)),
        "exponent": values["exponent"],
    }


def make_sky(sky: description.Environment) -> dict[str, Any]:
    """Return Mitsuba's dictionary for an environment; only its own integrators need it.

    Mitsuba interpolates between pixels, VTK's light does not, so each pixel becomes `fine` x `fine`
    equal ones. Mitsuba's image begins with the upper row, and its middle lies behind (+z).
    """
    if sky.image.shape[:2] == (1, 1):
        return {"type": "constant", "radiance": {"type": "rgb", "value": sky.image[0, 0].tolist()}}
    fine = 8
    image = np.roll(sky.image[::-1], sky.image.shape[1] // 2, axis=1)
    image = np.repeat(np.repeat(image, fine, axis=0), fine, axis=1).astype(np.float32)
    turn = np.eye(4)
    turn[:3, :3] = np.stack([sky.right, sky.up, sky.back], axis=1)
    bitmap = mi.Bitmap(np.ascontiguousarray(image))
    return {"type": "envmap", "bitmap": bitmap, "to_world": mi.ScalarTransform4f(turn)}


def make_area_light(
    light: description.AreaLight, center: np.ndarray, scale: float
) -> dict[str, Any]:
    """Return Mitsuba's dictionary for an area light; only its own integrators need it.

    It is a black surface there, which light does not pass. Mitsuba's rectangle has edges of length
    2 along x and y, and its image begins where both are -1.
    """
    if light.two_sided:
        raise ValueError("Mitsuba's area emitters have one side")
    turn = np.eye(4)
    turn[:3, 0], turn[:3, 1] = 0.5 * scale * light.edge1, 0.5 * scale * light.edge2
    turn[:3, 2] = light.normal
    turn[:3, 3] = (light.corner + 0.5 * (light.edge1 + light.edge2) - center) * scale
    image = np.ascontiguousarray(light.image, dtype=np.float32)
    radiance = {
        "type": "bitmap",
        "bitmap": mi.Bitmap(image),
        "raw": True,
        "filter_type": "nearest",
        "wrap_mode": "clamp",
    }
    return {
        "type": "rectangle",
        "to_world": mi.ScalarTransform4f(turn),
        "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.0}},
        "emitter": {"type": "area", "radiance": radiance},
    }


def make_scene(scene: description.Description, with_emitters: bool = False) -> mi.Scene:
    """Return the Mitsuba scene of a description, in tracer coordinates.

    `with_emitters`: with sky and area lights, which the tracer's own estimators do not need.
    """
    surface = scene.surface
    properties = mi.Properties()
    properties["mesh_bsdf"] = mi.load_dict(
        {
            "type": "twosided",
            "material": {
                "type": "diffuse",
                "reflectance": {"type": "mesh_attribute", "name": "vertex_color"},
            },
        }
    )
    mesh = mi.Mesh(
        scene.name,
        vertex_count=len(surface.points),
        face_count=len(surface.faces),
        has_vertex_normals=True,
        has_vertex_texcoords=False,
        props=properties,
    )
    mesh.add_attribute("vertex_color", 3, surface.albedo.astype(np.float32).ravel())
    if surface.specular is not None:
        specular = surface.specular.astype(np.float32)
        mesh.add_attribute("vertex_specular", 3, specular[:, :3].ravel())
        mesh.add_attribute("vertex_power", 1, specular[:, 3].ravel())
    parameters = mi.traverse(mesh)
    points = (surface.points - scene.center) * scene.scale
    parameters["faces"] = surface.faces.astype(np.uint32).ravel()
    parameters["vertex_positions"] = points.astype(np.float32).ravel()
    parameters["vertex_normals"] = surface.normals.astype(np.float32).ravel()
    parameters.update()
    objects: dict[str, Any] = {"type": "scene", "surface": mesh}
    for index, light in enumerate(scene.lights):
        emitted = description.emitter(light, scene.center, scene.scale)
        objects[f"light{index}"] = make_emitter(emitted)
    if with_emitters and scene.environment is not None:
        objects["sky"] = make_sky(scene.environment)
    for index, area_light in enumerate(scene.area_lights if with_emitters else []):
        objects[f"area{index}"] = make_area_light(area_light, scene.center, scene.scale)
    return mi.load_dict(objects)


# Light --------------------------------------------------------------------------------------------


def ray_origin(point: Any, facet: Any, back: Any) -> Any:
    """Return where rays from a surface start: off its facet, and back towards where it was seen.

    The way to the eye is free, so `back` keeps a point in a corner from ending up behind the other
    wall.
    """
    return point + (facet + back) * ((1.0 + dr.max(dr.abs(point))) * mi.math.RayEpsilon)


def sides(hit: Any, direction: Any) -> tuple[Any, Any, Any]:
    """Return the facet's and the shading normal at hits, on the side that the ray sees, and where.

    Where there is none (normals of opposite signs that cancel, slivers without area) the surface is
    drawn but takes no part in lighting, as in the passes.
    """
    front = dr.dot(hit.n, direction) < 0.0
    facet, normal = hit.n, hit.sh_frame.n
    # False for NaN too.
    there = (dr.dot(facet, facet) > 0.5) & (dr.dot(normal, normal) > 0.5)
    sign = dr.select(front, 1.0, -1.0)
    anything = mi.Normal3f(0.0, 0.0, 1.0)
    return (
        dr.select(there, facet * sign, anything),
        dr.select(there, normal * sign, anything),
        there,
    )


def albedo_at(hit: Any, there: Any) -> Any:
    """Return the diffuse reflectance at hits, black where there is none.

    Interpolation in a triangle that is all but a line gives numbers that are no colours.
    """
    value = hit.bsdf().eval_diffuse_reflectance(hit, there)
    return dr.select(there & dr.all((value >= 0.0) & (value < 2.0)), value, 0.0)


def specular_at(hit: Any, there: Any) -> tuple[Any, Any]:
    """Return colour and power of VTK's specular term at hits, of a scene that has such."""
    color = hit.shape.eval_attribute_3("vertex_specular", hit, there)
    power = hit.shape.eval_attribute_1("vertex_power", hit, there)
    good = there & dr.all((color >= 0.0) & (color < 100.0)) & (power >= 0.0)
    return dr.select(good, color, 0.0), dr.select(good, power, 1.0)


def direct(
    scene: mi.Scene,
    point: Any,
    back: Any,
    facet: Any,
    normal: Any,
    active: Any,
    power: Any = None,
) -> Any:
    """Return the direct irradiance at a point in VTK's units, shadowed; see `ray_origin`.

    With `power` instead what VTK's specular term of coefficient one shows the viewer, who is at
    `back`: the sum of I max(r.v, 0)^power over the lights that the surface faces, without a cosine.
    """
    total = dr.zeros(mi.Color3f, dr.width(point))
    reference = dr.zeros(mi.Interaction3f)
    reference.p = point
    reference.n = facet
    origin = ray_origin(point, facet, back)
    for emitter in scene.emitters():
        sample, weight = emitter.sample_direction(reference, mi.Point2f(0.5, 0.5), active)
        cosine = dr.dot(normal, sample.d)
        lit = active & (cosine > 0.0) & (dr.dot(facet, sample.d) > 0.0)
        lit &= dr.max(weight) > 0.0
        way = sample.p - origin
        length = dr.norm(way)
        ray = mi.Ray3f(origin, way / length, length * (1.0 - mi.math.ShadowEpsilon), 0.0, [])
        lit &= ~scene.ray_test(ray, lit)
        factor = cosine
        if power is not None:
            mirrored = dr.dot(2.0 * cosine * normal - sample.d, back)
            factor = dr.select(mirrored > 0.0, dr.power(dr.maximum(mirrored, 1e-6), power), 0.0)
        total += dr.select(lit, weight * (factor * dr.inv_pi), 0.0)
    return total


def first_hit(scene: mi.Scene, ray: mi.Ray3f) -> dict[str, Any]:
    """Return what rays from the eye meet: receivers, and their albedo and direct irradiance."""
    hit = scene.ray_intersect(ray)
    valid = hit.is_valid()
    facet, normal, there = sides(hit, ray.d)
    valid &= there
    return {
        "valid": valid,
        "point": hit.p,
        "back": -ray.d,
        "facet": facet,
        "normal": normal,
        "albedo": albedo_at(hit, valid),
        "direct": direct(scene, hit.p, -ray.d, facet, normal, valid),
    }


def take(values: Any, where: Any) -> Any:
    return dr.gather(type(values), values, where)
