// SPDX-License-Identifier: MIT
// Small scenes made in memory. z is up; a scene's sphere is the unit sphere, if span_unit_sphere() is called.
#pragma once

#include <vector>

#include "scene/scene_data.h"

namespace lumi::baker::testing
{

Material diffuse(const Rgb& albedo);
Material glossy(const Rgb& albedo, float alpha);
Material metal(const Rgb& f0, float alpha);
Material lamp(const Rgb& radiance);
Material glass(float index, float alpha, const Rgb& transmittance = grey(1));  // along one unit

class SceneMaker
{
public:
    uint32_t add(const Material& material);
    void add(const Fixture& fixture);  // in the scene's units
    void fill(const Volume& volume);
    void expose(float factor);
    void surround(const Environment& environment);
    void see_through(ToneCurve tone);
    // Corners in order around the edge.
    void quad(uint32_t material, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
    // A convex ball of flat faces whose corners lie on the sphere.
    void ball(uint32_t material, const Vec3& centre, float radius, int rings = 16);
    // An axis-parallel box, seen from both sides.
    void box(uint32_t material, const Vec3& low, const Vec3& high);

    // Gives a material a normal map that leans everywhere by this sine along x, where it is drawn as the only quad.
    void tilt_normals(uint32_t material, float sine);

    // All that is added from here on is a part that moves so.
    void begin_part(const PartMovement& movement);

    // Fixes the bounding sphere to the unit sphere: adds six specks at its axis points, which nothing else may exceed.
    void span_unit_sphere();

    Scene make(const Environment& environment);  // exposed by 1 unless expose() was called
    Scene make_open();                           // the scene chooses what nobody stated

private:
    void triangle(uint32_t material, const Vec3& a, const Vec3& b, const Vec3& c);

    SceneParts parts_;
};

}  // namespace lumi::baker::testing
