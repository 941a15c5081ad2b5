// SPDX-License-Identifier: MIT
// Composes files of surface fields with moving parts, written from surface/format.h.
#pragma once

#include <string>

#include "see_through_bytes.h"

namespace lumi::test
{

struct TestPart {
    TestSurface mesh;
    std::string name = "hand";
    bool slides = false;
    std::array<double, 3> axis = {0, 0, 1}, pivot = {0, 0, 0};  // unit length; radii
    int32_t from = 0;
    uint32_t span = UINT32_MAX;
    bool light_stays = false;
    uint32_t follows = 0;  // k: a shadow of part k - 1, whose patches are see-through
};

// A body and its parts as one mesh, in the order of the file, and the parts' records.
struct TestMover {
    TestSurface all;
    Bytes section;
    uint32_t opaque = 0;  // patches; those behind them are see-through
};

inline int32_t rounded(double v, double one)
{
    return static_cast<int32_t>(std::lround(v * one));
}

inline void put_record(Bytes& b, const TestPart& part, uint32_t viewed, uint32_t plain, uint32_t patch)
{
    for (const uint32_t first : {viewed, plain, patch}) put16(b, first);
    put16(b, (part.slides ? 1 : part.light_stays ? 2 : 0) | part.follows << 8);
    for (const double c : part.axis) put32(b, static_cast<uint32_t>(rounded(c, 0x1p30)));
    for (const double c : part.pivot) put32(b, static_cast<uint32_t>(part.slides ? 0 : rounded(c, 0x1p20)));
    put32(b, static_cast<uint32_t>(part.from));
    put32(b, part.span);
    b.insert(b.end(), part.name.begin(), part.name.end());
    b.resize(b.size() + detail::format::part::kNameBytes - part.name.size());
}

// Vertices whose own mesh gives them a view table come first, each kind by owner. The body's last `glass` patches go
// behind the parts', to be see-through.
inline TestMover mover(const TestSurface& body, const std::vector<TestPart>& parts, uint32_t glass = 0)
{
    std::vector<const TestSurface*> owners = {&body};
    for (const TestPart& part : parts) owners.push_back(&part.mesh);
    TestMover m;
    m.all = body;
    m.all.vertices.clear();
    m.all.patches.clear();
    m.all.texels.clear();
    std::vector<std::vector<uint32_t>> numbers(owners.size());
    std::vector<uint32_t> first_viewed, first_plain, first_patch;
    const auto add = [&](size_t k, uint32_t begin, uint32_t end) {
        for (uint32_t v = begin; v < end; ++v) {
            numbers[k].push_back(static_cast<uint32_t>(m.all.vertices.size()));
            m.all.vertices.push_back(owners[k]->vertices[v]);
        }
    };
    const auto add_patches = [&](size_t k, uint32_t begin, uint32_t end) {
        for (uint32_t p = begin; p < end; ++p) {
            TestPatch patch = owners[k]->patches[p];
            for (uint32_t* corner : {&patch.a, &patch.b, &patch.c, &patch.d})
                if (*corner != detail::format::kNoVertex) *corner = numbers[k][*corner];
            m.all.patches.push_back(patch);
        }
    };
    const auto opaque = [&](size_t k) {
        const auto all = static_cast<uint32_t>(owners[k]->patches.size());
        return k == 0 ? all - glass : parts[k - 1].follows == 0 ? all : 0;
    };
    for (size_t k = 0; k < owners.size(); ++k) {
        first_viewed.push_back(static_cast<uint32_t>(m.all.vertices.size()));
        add(k, 0, owners[k]->viewed);
    }
    m.all.viewed = static_cast<uint32_t>(m.all.vertices.size());
    for (size_t k = 0; k < owners.size(); ++k) {
        first_plain.push_back(static_cast<uint32_t>(m.all.vertices.size()));
        add(k, owners[k]->viewed, static_cast<uint32_t>(owners[k]->vertices.size()));
        first_patch.push_back(static_cast<uint32_t>(m.all.patches.size()));
        add_patches(k, 0, opaque(k));
    }
    m.opaque = static_cast<uint32_t>(m.all.patches.size());
    for (size_t k = owners.size(); k-- > 0;)
        add_patches(k, opaque(k), static_cast<uint32_t>(owners[k]->patches.size()));
    put_texels(m.all);
    put16(m.section, static_cast<uint32_t>(parts.size()));
    put16(m.section, 0);
    for (size_t k = 0; k < parts.size(); ++k)
        put_record(m.section, parts[k], first_viewed[k + 1], first_plain[k + 1], first_patch[k + 1]);
    return m;
}

inline std::vector<TestSection> mover_sections(const TestMover& m)
{
    const bool has_glass = m.opaque < m.all.patches.size();
    std::vector<TestSection> sections =
        has_glass ? see_through_sections(m.all, m.opaque, many_glasses()) : surface_sections(m.all);
    sections.push_back({detail::format::kPartsSection, detail::format::kRequired, m.section});
    return sections;
}

inline Bytes mover_file(const TestMover& m)
{
    return file_of(mover_sections(m));
}

// The mesh made smaller and put elsewhere, radii.
inline TestSurface placed(TestSurface mesh, double scale, const std::array<double, 3>& at)
{
    for (SurfacePoint& v : mesh.vertices)
        for (size_t k = 0; k < 3; ++k) v[k] = rounded(v[k] * scale / 16384 + at[k], 16384);
    return mesh;
}

inline TestSurface ball(int side, uint32_t plain)
{
    TestSurface s = BumpyBall(side).take();
    s.viewed = static_cast<uint32_t>(s.vertices.size()) - plain;
    return s;
}

// A ball with three others around it. The first goes round it, the second turns about itself and no farther than an
// eighth of a turn, and the third slides into the ball.
inline std::vector<TestPart> three_parts()
{
    const double side = std::sqrt(0.5);
    return {{placed(ball(2, 5), 0.2, {0.6, 0, 0}), "moon"},
            {placed(ball(3, 0), 0.3, {0, 0.5, 0.3}),
             "knob",
             false,
             {0, side, side},
             {0, 0.5, 0.3},
             -0x10000000,
             0x20000000},
            {placed(ball(1, 8), 0.25, {-0.3, -0.3, -0.6}), "slider", true, {0, 0, 1}, {}, -(1 << 16), 1 << 20}};
}

// A square that lies across an axis, as the shadow of a part.
inline TestPart shadow(const TestPart& leader, uint32_t follows, int32_t half, const std::array<double, 3>& at)
{
    TestPart part = leader;
    part.mesh = placed(panes({{half, 0, 77}}), 1, at);
    part.mesh.viewed = 0;
    part.name = "";
    part.follows = follows;
    if (!part.slides) part.pivot[0] += 0.05;
    return part;
}

// These are three_parts() with shadows of the first and of the third part.
inline std::vector<TestPart> parts_with_shadows()
{
    std::vector<TestPart> parts = three_parts();
    parts.push_back(shadow(parts[0], 1, 3000, {0.5, 0.1, 0.25}));
    parts.push_back(shadow(parts[2], 3, 2000, {-0.3, -0.2, -0.3}));
    return parts;
}

inline TestMover shaded_ball(uint32_t glass)
{
    return mover(placed(ball(4, 20), 0.4, {0, 0, 0}), parts_with_shadows(), glass);
}

inline TestMover moving_ball(uint32_t glass = 0)
{
    return mover(placed(ball(4, 20), 0.4, {0, 0, 0}), three_parts(), glass);
}

}  // namespace lumi::test
