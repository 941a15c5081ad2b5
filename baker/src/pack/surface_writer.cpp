// SPDX-License-Identifier: MIT
#include "pack/surface_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "lumi/fixed.h"
#include "lumi/surface/format.h"
#include "mesh/patch_mesh.h"
#include "pack/patch_neighbours.h"
#include "store/section_writer.h"

namespace lumi::baker
{
namespace
{

bool has_shadows_alone(const PatchMesh& mesh)
{
    for (uint32_t p = mesh.opaque_patches(); p < mesh.patches.size(); ++p)
        if (!is_shadow(mesh, p)) return false;
    return true;
}

struct Contents {
    uint32_t type;
    std::vector<uint8_t> bytes;
    bool is_required = true;
};

// By vertex: 0 for the body, k for part k - 1. Parts share no vertices.
std::vector<uint32_t> owners_of(const PatchMesh& mesh)
{
    std::vector<uint32_t> owners(mesh.positions.size());
    for (uint32_t p = 0; p < mesh.patches.size(); ++p) {
        const PatchMesh::Patch& patch = mesh.patches[p];
        for (const uint32_t v : {patch.a, patch.b, patch.c, patch.d})
            if (v != PatchMesh::kNone) owners[v] = mesh.owner_of(p);
    }
    return owners;
}

// Vertices in the file's order: those with view tables, then the others, each by owner; and their numbers in it.
struct VertexOrder {
    std::vector<uint32_t> vertices, numbers, owners;
    uint32_t viewed;

    // The first of the vertices from `begin` up to `end` that an owner or a later one has.
    uint32_t first_of(uint32_t owner, uint32_t begin, uint32_t end) const
    {
        while (begin < end && owners[vertices[begin]] < owner) ++begin;
        return begin;
    }
};

VertexOrder order_of(const PatchMesh& mesh, const std::vector<ViewCode>& views)
{
    VertexOrder order;
    order.owners = owners_of(mesh);
    order.vertices.resize(views.size());
    std::iota(order.vertices.begin(), order.vertices.end(), 0u);
    const auto place = [&](uint32_t v) { return std::pair(!views[v].is_there(), order.owners[v]); };
    std::stable_sort(
        order.vertices.begin(), order.vertices.end(), [&](uint32_t v, uint32_t w) { return place(v) < place(w); });
    order.viewed = static_cast<uint32_t>(
        std::count_if(views.begin(), views.end(), [](const ViewCode& view) { return view.is_there(); }));
    order.numbers.resize(views.size());
    for (uint32_t k = 0; k < order.vertices.size(); ++k) order.numbers[order.vertices[k]] = k;
    return order;
}

uint8_t edge_steps(float longest_edge)
{
    constexpr float kSteps = 64;
    return static_cast<uint8_t>(std::clamp(std::ceil(longest_edge * kSteps), 1.0f, 2 * kSteps));
}

std::vector<uint8_t> surface_section(const FitShape& shape, const FieldParts& parts, uint32_t viewed)
{
    namespace at = detail::format::surface;
    Bytes b(detail::format::kSurfaceBytes);
    b.put16(at::kVerticesAt, static_cast<uint16_t>(shape.mesh.positions.size()));
    b.put16(at::kViewedAt, static_cast<uint16_t>(viewed));
    b.put16(at::kPatchesAt, static_cast<uint16_t>(shape.mesh.patches.size()));
    b.put16(at::kShadowsAt, static_cast<uint16_t>(has_shadows_alone(shape.mesh) ? shape.mesh.see_through_patches : 0));
    b.put32(at::kTexelsAt, shape.layout.texels);
    b.put8(at::kColourSpaceAt, static_cast<uint8_t>(ColourSpace::srgb));
    b.put8(at::kLongestEdgeAt, edge_steps(shape.mesh.longest_edge));
    b.put8(at::kCodeBitsAt, static_cast<uint8_t>(viewed == 0 ? 0 : parts.node_colours.bits));
    for (size_t axis = 0; axis < 3; ++axis)
        b.put_float(at::kCentreAt + 4 * axis, static_cast<float>(parts.centre[axis]));
    b.put_float(at::kRadiusAt, static_cast<float>(parts.radius));
    return b.take();
}

std::vector<uint8_t> vertex_section(const FitShape& shape, const VertexOrder& order)
{
    constexpr float kOne = 16384;  // Q14
    Bytes b(order.vertices.size() * detail::format::kVertexBytes);
    size_t at = 0;
    for (const uint32_t v : order.vertices) {
        const Vec3& p = shape.mesh.positions[v];
        for (const float c : {p.x, p.y, p.z}) {
            b.put16(at, static_cast<uint16_t>(std::lround(c * kOne)));
            at += 2;
        }
    }
    return b.take();
}

std::vector<uint8_t> patch_section(const FitShape& shape, const VertexOrder& order)
{
    namespace at = detail::format::patch;
    Bytes b(shape.mesh.patches.size() * detail::format::kPatchBytes);
    for (uint32_t p = 0; p < shape.mesh.patches.size(); ++p) {
        const size_t entry = p * detail::format::kPatchBytes;
        for (uint32_t corner = 0; corner < 4; ++corner) {
            const uint32_t v = shape.vertex(p, corner);
            const uint32_t number = v == PatchMesh::kNone ? detail::format::kNoVertex : order.numbers[v];
            b.put16(entry + at::kCornersAt + 2 * corner, static_cast<uint16_t>(number));
        }
        const PatchRectangle& r = shape.layout.rectangles[p];
        b.put32(entry + at::kTexelsAt, r.begin | r.n << 20 | r.m << 26);
    }
    return b.take();
}

std::vector<uint8_t> neighbour_section(const FitShape& shape, const FieldParts& parts)
{
    Bytes b(shape.mesh.patches.size() * detail::format::kNeighbourBytes);
    size_t at = 0;
    for (const std::array<uint16_t, 4>& across : patch_neighbours(shape, parts)) {
        for (const uint16_t triangle : across) {
            b.put16(at, triangle);
            at += 2;
        }
    }
    return b.take();
}

std::vector<uint8_t> palette_section(const FieldParts& parts)
{
    Bytes b(3 * parts.palette.size());
    for (size_t k = 0; k < parts.palette.size(); ++k) {
        b.put8(3 * k, parts.palette[k].r);
        b.put8(3 * k + 1, parts.palette[k].g);
        b.put8(3 * k + 2, parts.palette[k].b);
    }
    return b.take();
}

std::vector<uint8_t> view_record(const ViewTurn& turn, const ViewCode& view, uint32_t bits)
{
    std::vector<uint8_t> record(detail::format::view_turn_at(bits));
    for (uint32_t k = 0; k < detail::format::kViewNodes; ++k) {
        const uint32_t at = k * bits, low = at / 8, code = static_cast<uint32_t>(view.codes[k]) << at % 8;
        record[low] = static_cast<uint8_t>(record[low] | code);
        if (code > 0xFF) record[low + 1] = static_cast<uint8_t>(code >> 8);
    }
    for (const int8_t axis : {turn.x, turn.y, turn.z}) record.push_back(static_cast<uint8_t>(axis));
    record.insert(record.end(), view.gains.begin(), view.gains.end());
    return record;
}

void append_colours(std::vector<uint8_t>& bytes, const PaletteColours& colours)
{
    for (const Rgb8& c : colours) bytes.insert(bytes.end(), {c.r, c.g, c.b});
}

void append_colours(std::vector<uint8_t>& bytes, const NodeColours& colours)
{
    for (const NodeColours::Colour& colour : colours.colours)
        for (const int8_t channel : colour) bytes.push_back(static_cast<uint8_t>(channel));
}

std::vector<uint8_t> view_section(const FitShape& shape, const FieldParts& parts, const VertexOrder& order)
{
    std::vector<uint8_t> bytes;
    append_colours(bytes, parts.node_colours);
    for (uint32_t k = 0; k < order.viewed; ++k) {
        const uint32_t v = order.vertices[k];
        const std::vector<uint8_t> record = view_record(shape.turns[v], parts.views[v], parts.node_colours.bits);
        bytes.insert(bytes.end(), record.begin(), record.end());
    }
    return bytes;
}

std::vector<uint8_t> see_through_section(const FitShape& shape, const FieldParts& parts)
{
    namespace at = detail::format::see_through;
    Bytes b(detail::format::kSeeThroughBytes);
    b.put16(at::kFirstAt, static_cast<uint16_t>(shape.mesh.opaque_patches()));
    using detail::format::DrawingOrder;
    const bool is_in_order = shape.mesh.is_in_drawing_order != 0;
    b.put16(at::kOrderAt, static_cast<uint16_t>(is_in_order ? DrawingOrder::of_the_file : DrawingOrder::by_depth));
    for (size_t k = 0; k < parts.see_through.size(); ++k) {
        size_t byte = at::kPaletteAt + k * at::kEntryBytes;
        for (const Rgb8& c : {parts.see_through[k].added, parts.see_through[k].passed})
            for (const uint8_t v : {c.r, c.g, c.b}) b.put8(byte++, v);
    }
    return b.take();
}

void put_vector(Bytes& b, size_t at, const Vec3& v, double one)
{
    size_t byte = at;
    for (const float c : {v.x, v.y, v.z}) {
        b.put32(byte, static_cast<uint32_t>(std::lround(c * one)));
        byte += 4;
    }
}

detail::format::Motion motion_of(const MovingPart& part)
{
    using detail::format::Motion;
    if (part.slides) return Motion::slide;
    return part.light_stays ? Motion::turn_below_light : Motion::turn;
}

void put_part(Bytes& b, size_t record, const MovingPart& part)
{
    namespace at = detail::format::part;
    b.put8(record + at::kMotionAt, static_cast<uint8_t>(motion_of(part)));
    b.put8(record + at::kFollowsAt, static_cast<uint8_t>(part.follows));
    put_vector(b, record + at::kAxisAt, part.axis, kOneQ30);
    if (!part.slides) put_vector(b, record + at::kPivotAt, part.pivot, kOneQ20);
    const double one = part.slides ? double{kOneQ20} : 0x1p32;
    const bool is_free = !part.slides && part.to - part.from >= 1;
    const int64_t from = std::llround(part.from * one), to = std::llround(part.to * one);
    b.put32(record + at::kFromAt, is_free ? 0 : static_cast<uint32_t>(from));
    b.put32(record + at::kSpanAt, is_free ? UINT32_MAX : static_cast<uint32_t>(to - from));
    for (size_t k = 0; k < std::min<size_t>(part.name.size(), at::kNameBytes); ++k)
        b.put8(record + at::kNameAt + k, static_cast<uint8_t>(part.name[k]));
}

std::vector<uint8_t> parts_section(const PatchMesh& mesh, const VertexOrder& order)
{
    namespace format = detail::format;
    const uint32_t count = static_cast<uint32_t>(mesh.parts.size()), all = static_cast<uint32_t>(order.vertices.size());
    Bytes b(format::kPartsHeaderBytes + count * format::kPartBytes);
    b.put16(0, static_cast<uint16_t>(count));
    for (uint32_t k = 0; k < count; ++k) {
        const size_t record = format::kPartsHeaderBytes + k * format::kPartBytes;
        put_part(b, record, mesh.parts[k]);
        const MovingPart& part = mesh.parts[k];
        const uint32_t first_patch = part.follows == 0 ? part.first_patch : mesh.opaque_patches();
        b.put16(record + format::part::kFirstPatchAt, static_cast<uint16_t>(first_patch));
        const uint32_t first_viewed = order.first_of(k + 1, 0, order.viewed);
        const uint32_t first_plain = order.first_of(k + 1, order.viewed, all);
        b.put16(record + format::part::kFirstViewedAt, static_cast<uint16_t>(first_viewed));
        b.put16(record + format::part::kFirstPlainAt, static_cast<uint16_t>(first_plain));
    }
    return b.take();
}

std::vector<uint8_t> states_section(const FitShape& shape, const FieldParts& parts, const VertexOrder& order)
{
    namespace at = detail::format::state;
    Bytes b(detail::format::states_palettes_at(static_cast<uint32_t>(parts.states.size())));
    b.put8(0, static_cast<uint8_t>(parts.states.size()));
    uint32_t tints = 0;
    for (size_t k = 0; k < parts.states.size(); ++k) {
        const StateColours& state = parts.states[k];
        const size_t record = detail::format::kStatesHeaderBytes + k * detail::format::kStateBytes;
        for (size_t c = 0; c < state.name.size(); ++c) b.put8(record + c, static_cast<uint8_t>(state.name[c]));
        b.put8(record + at::kScaleAt, static_cast<uint8_t>(std::lround(state.scale * float{at::kOneQ4})));
        size_t byte = record + at::kDefaultAt;
        for (const uint8_t level : {state.usual.r, state.usual.g, state.usual.b})
            b.put8(byte++, static_cast<uint8_t>(UINT8_MAX - level));
        tints |= state.is_tint ? 1u << k : 0;
    }
    b.put8(1, static_cast<uint8_t>(tints));
    std::vector<uint8_t> bytes = b.take();
    for (const StateColours& state : parts.states) append_colours(bytes, state.palette);
    if (shape.mesh.see_through_patches != 0)
        for (const StateColours& state : parts.states) append_colours(bytes, state.added);
    if (order.viewed == 0) return bytes;
    for (const StateColours& state : parts.states) append_colours(bytes, state.node_colours);
    for (uint32_t k = 0; k < order.viewed; ++k) {
        const uint32_t v = order.vertices[k];
        bytes.push_back(parts.means[v]);
        for (const StateColours& state : parts.states)
            bytes.insert(bytes.end(), state.views[v].gains.begin(), state.views[v].gains.end());
    }
    return bytes;
}

std::vector<uint8_t> gloss_section(const FitShape& shape)
{
    namespace format = detail::format;
    const auto maps = static_cast<uint32_t>(shape.gloss.maps.size());
    std::vector<uint8_t> bytes(format::gloss_maps_at(maps));
    bytes[0] = static_cast<uint8_t>(maps);
    for (uint32_t k = 0; k < maps; ++k)
        std::copy_n(shape.gloss.maps[k].gains.begin(), 3,
                    bytes.begin() + format::kGlossHeaderBytes + k * format::kGlossGainBytes);
    for (const GlossMap& map : shape.gloss.maps) bytes.insert(bytes.end(), map.texels.begin(), map.texels.end());
    bytes.resize(format::gloss_bytes(maps, static_cast<uint32_t>(shape.mesh.patches.size())));
    for (size_t p = 0; p < shape.gloss.choices.size(); ++p) {
        uint8_t& four = bytes[format::gloss_choices_at(maps) + p / 4];
        four = static_cast<uint8_t>(four | shape.gloss.choices[p] << 2 * (p % 4));
    }
    return bytes;
}

std::vector<uint8_t> file_of(const std::vector<Contents>& contents)
{
    std::vector<Section> sections;
    for (const Contents& part : contents) {
        sections.push_back({part.type, part.bytes.size(), crc_of(part.bytes)});
        if (!part.is_required) sections.back().flags = 0;
    }
    std::vector<uint8_t> file = file_head(sections);
    for (const Contents& part : contents) {
        file.insert(file.end(), part.bytes.begin(), part.bytes.end());
        file.resize(aligned(file.size()));
    }
    return file;
}

}  // namespace

std::vector<uint8_t> surface_file(const FitShape& shape, const FieldParts& parts)
{
    const VertexOrder order = order_of(shape.mesh, parts.views);
    std::vector<Contents> contents = {{detail::format::kSurfaceSection, surface_section(shape, parts, order.viewed)},
                                      {detail::format::kVertexSection, vertex_section(shape, order)},
                                      {detail::format::kPatchSection, patch_section(shape, order)},
                                      {detail::format::kColourSection, parts.texels},
                                      {detail::format::kPaletteRgb, palette_section(parts)},
                                      {detail::format::kNeighbourSection, neighbour_section(shape, parts)}};
    if (order.viewed != 0) contents.push_back({detail::format::kViewSection, view_section(shape, parts, order)});
    if (shape.mesh.see_through_patches != 0)
        contents.push_back(
            {detail::format::kSeeThroughSection, see_through_section(shape, parts), !has_shadows_alone(shape.mesh)});
    if (!shape.mesh.parts.empty())
        contents.push_back({detail::format::kPartsSection, parts_section(shape.mesh, order)});
    if (!parts.states.empty())
        contents.push_back({detail::format::kStateSection, states_section(shape, parts, order), false});
    if (shape.gloss.is_there()) contents.push_back({detail::format::kGlossSection, gloss_section(shape)});
    if (parts.is_draft) contents.push_back({detail::format::kDraftSection, std::vector<uint8_t>(4), false});
    return file_of(contents);
}

}  // namespace lumi::baker
