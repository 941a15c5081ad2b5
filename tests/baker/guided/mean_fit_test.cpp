// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "guided/mean_fit.h"
#include "math/sampler.h"
#include "support/shapes.h"

namespace lumi::baker::testing
{
namespace
{

Mesh plate()
{
    Mesh mesh;
    mesh.positions = {{-0.5f, -0.5f, 0.1f}, {0.5f, -0.5f, 0.1f}, {0.5f, 0.5f, 0.1f}, {-0.5f, 0.5f, 0.1f}};
    mesh.corners = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

}  // namespace

TEST_CASE("Mean colours follow what is linear in space, and fill nodes that no point tells about", "[guided]")
{
    const NodeGrid grid(plate(), 24);
    const auto colour_at = [](const Vec3& x) { return Levels{100 + 80 * x.x, 120 - 60 * x.y, 50}; };
    MeanFit fit(grid);
    Sampler sampler(3, 0, 0);
    for (uint32_t k = 0; k < 8000; ++k) {
        sampler.start(k);
        const Vec2 u = sampler.next_2d();
        const Vec3 x = {u.x - 0.5f, u.y - 0.5f, 0.1f};
        if (std::hypot(x.x, x.y) > 0.1f) {  // a hole without points
            fit.add(x, colour_at(x));
        }
    }
    const std::vector<Levels> colours = fit.solve();
    double worst = 0, worst_in_hole = 0;
    for (uint32_t k = 0; k < 2000; ++k) {
        sampler.start(k);
        const Vec2 u = sampler.next_2d();
        const Vec3 x = {0.94f * (u.x - 0.5f), 0.94f * (u.y - 0.5f), 0.1f};
        const Levels d = trilinear(grid, colours, x) - colour_at(x);
        double& w = std::hypot(x.x, x.y) > 0.15f ? worst : worst_in_hole;
        w = std::max(w, static_cast<double>(std::max({std::abs(d.r), std::abs(d.g), std::abs(d.b)})));
    }
    CHECK(worst < 1);
    CHECK(worst_in_hole < 8);
}

}  // namespace lumi::baker::testing
