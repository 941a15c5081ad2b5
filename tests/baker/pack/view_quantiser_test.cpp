// SPDX-License-Identifier: MIT
#include "pack/view_quantiser.h"

#include <catch2/catch.hpp>

namespace lumi::baker::testing
{
namespace
{

constexpr uint32_t kSheetSide = 8;

// A sheet of 64 vertices with tables of all colours, seen from all around.
struct Tables {
    Tables() : shape(sheet(), std::vector<float>(sheet().patches.size(), 1.0f)), model(empty_model(shape))
    {
        Sampler sampler(2, 0, 0);
        for (uint32_t k = 0; k < model.nodes.size(); ++k) {
            sampler.start(k);
            for (float& channel : model.nodes[k]) channel = 60 * sampler.next_1d() - 30;
        }
        for (uint32_t p = 0; p < shape.mesh.patches.size(); ++p) add_paths(p, sampler);
    }

    void add_paths(uint32_t patch, Sampler& sampler)
    {
        constexpr uint32_t kPaths = 400;
        const auto q12 = [](float f) { return static_cast<int16_t>(4096 * f); };
        std::vector<FitSample> samples;
        for (uint32_t k = 0; k < kPaths; ++k) {
            sampler.start(kPaths * patch + k);
            const Vec2 place = sampler.next_2d(), eye = sampler.next_2d();
            samples.push_back({2 * patch,
                               shape.layout.rectangles[patch].begin,
                               q12(place.x / 2),
                               q12(place.y / 2),
                               {q12(6 * eye.x - 3), q12(6 * eye.y - 3), q12(3 * sampler.next_1d())},
                               Rgb{},
                               {}});
        }
        sums.add(patch, samples.data(), samples.data() + samples.size());
    }

    static PatchMesh sheet()
    {
        PatchMesh mesh;
        for (uint32_t k = 0; k < kSheetSide * kSheetSide; ++k) {
            mesh.positions.push_back(
                {0.1f * static_cast<float>(k % kSheetSide), 0.1f * static_cast<float>(k / kSheetSide), 0});
            mesh.normals.push_back({0, 0, 1});
        }
        for (uint32_t k = 0; k + kSheetSide < kSheetSide * kSheetSide; ++k)
            if (k % kSheetSide + 1 < kSheetSide) mesh.patches.push_back({k, k + 1, k + kSheetSide, k + kSheetSide + 1});
        return mesh;
    }

    // Every node has the same.
    double error(uint32_t bits) const
    {
        const std::vector<uint8_t> all(shape.mesh.positions.size(), 1);
        const std::vector<LevelColour> shown = decoded(quantised({{sums, model}}, all, bits)[0]);
        double squares = 0;
        for (size_t k = 0; k < shown.size(); ++k)
            for (size_t c = 0; c < 3; ++c)
                squares += static_cast<double>((shown[k][c] - model.nodes[k][c]) * (shown[k][c] - model.nodes[k][c]));
        return std::sqrt(squares / static_cast<double>(3 * shown.size()));
    }

    const FitShape shape;
    const EncodedTone tone{ToneCurve::srgb};
    FitModel model;
    FitSums sums{shape, tone, model, White::goes_on};
};

}  // namespace

TEST_CASE("more bits of a code make view tables more exact, down to the format's rounding")
{
    const Tables tables;
    double last = 1e9;
    for (uint32_t bits = 1; bits <= 6; ++bits) {
        const double error = tables.error(bits);
        CAPTURE(bits, error, last);
        CHECK(error < last);
        last = error;
    }
    CHECK(last < 3);  // of 17
}

TEST_CASE("codes have as many bits as the bytes allow and the vertices can use")
{
    const auto bytes = [](uint32_t viewed, uint32_t bits) {
        return uint64_t{detail::format::view_colours_bytes(bits)} + viewed * detail::format::view_bytes(bits);
    };
    CHECK(code_bits_for(bytes(1000, 4), 1000) == 4);
    CHECK(code_bits_for(bytes(1000, 4) - 1, 1000) == 3);
    CHECK(code_bits_for(bytes(1000, 5), 1000) == 5);
    CHECK(code_bits_for(UINT64_MAX, 8192) == detail::format::kMaxCodeBits);
    CHECK(code_bits_for(UINT64_MAX, 16) == 4);
    CHECK(code_bits_for(UINT64_MAX, 17) == 5);
    CHECK(code_bits_for(0, 100) == 1);
    CHECK(code_bits_for(bytes(2187, 4), 0) >= 1);
}

}  // namespace lumi::baker::testing
