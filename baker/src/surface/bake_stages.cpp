// SPDX-License-Identifier: MIT
#include "surface/bake_stages.h"

#include <algorithm>

#include "store/settings_codec.h"
#include "surface/surface_codec.h"

namespace lumi::baker
{
namespace
{

constexpr uint64_t kVectorBytes = 12, kSampleBytes = 30;

// Of entries that take so many bytes each. False where fewer are left: sizes come before memory.
bool get_count(ByteReader& in, uint64_t entry_bytes, uint64_t& count)
{
    count = in.get64();
    return count <= in.left() / entry_bytes;
}

void put_colours(ByteWriter& out, const std::vector<LevelColour>& colours)
{
    out.put64(colours.size());
    for (const LevelColour& c : colours) put(out, Vec3{c[0], c[1], c[2]});
}
bool get_colours(ByteReader& in, std::vector<LevelColour>& colours)
{
    uint64_t count = 0;
    if (!get_count(in, kVectorBytes, count)) return false;
    for (uint64_t k = 0; k < count; ++k) {
        const Vec3 v = get_vector(in);
        colours.push_back({v.x, v.y, v.z});
    }
    return true;
}

void put16(ByteWriter& out, int16_t v)
{
    out.put8(static_cast<uint8_t>(v));
    out.put8(static_cast<uint8_t>(v >> 8));
}
int16_t get16(ByteReader& in)
{
    const uint8_t low = in.get8();
    return static_cast<int16_t>(low | in.get8() << 8);
}

void put(ByteWriter& out, const SurfaceSample& s)
{
    out.put32(s.triangle);
    out.put32(s.texel);
    for (const int16_t v : {s.second_q12, s.third_q12, s.eye.x, s.eye.y, s.eye.z}) put16(out, v);
    put(out, Vec3{s.radiance.r, s.radiance.g, s.radiance.b});
}
SurfaceSample get_sample(ByteReader& in)
{
    SurfaceSample s = {};
    s.triangle = in.get32();
    s.texel = in.get32();
    for (int16_t* v : {&s.second_q12, &s.third_q12, &s.eye.x, &s.eye.y, &s.eye.z}) *v = get16(in);
    const Vec3 radiance = get_vector(in);
    s.radiance = {radiance.x, radiance.y, radiance.z};
    return s;
}

}  // namespace

void put(ByteWriter& out, const Mesh& mesh)
{
    out.put64(mesh.positions.size());
    for (const Vec3& p : mesh.positions) put(out, p);
    out.put64(mesh.corners.size());
    for (const Mesh::Corners& triangle : mesh.corners)
        for (const uint32_t corner : triangle) out.put32(corner);
}

bool get(ByteReader& in, Mesh& mesh)
{
    uint64_t vertices = 0, triangles = 0;
    if (!get_count(in, kVectorBytes, vertices)) return false;
    for (uint64_t v = 0; v < vertices; ++v) mesh.positions.push_back(get_vector(in));
    if (!get_count(in, kVectorBytes, triangles)) return false;
    for (uint64_t t = 0; t < triangles; ++t) {
        const Mesh::Corners corners = {in.get32(), in.get32(), in.get32()};
        if (*std::max_element(corners.begin(), corners.end()) >= vertices) return false;
        mesh.corners.push_back(corners);
    }
    return true;
}

void put(ByteWriter& out, const Outside& outside)
{
    out.put8(outside.two_sided ? 1 : 0);
    put(out, outside.mesh);
}

bool get(ByteReader& in, Outside& outside)
{
    outside.two_sided = in.get8() != 0;
    return get(in, outside.mesh);
}

void put(ByteWriter& out, const MeshDraft& draft)
{
    out.put8(draft.rough ? 1 : 0);
    out.put8(draft.fits ? 1 : 0);
    put(out, draft.mesh);
}

bool get(ByteReader& in, MeshDraft& draft)
{
    draft.rough = in.get8() != 0;
    draft.fits = in.get8() != 0;
    return get(in, draft.mesh);
}

void put(ByteWriter& out, const SampleBatches& batches)
{
    out.put64(batches.size());
    for (const std::vector<SurfaceSample>& batch : batches) {
        out.put64(batch.size());
        for (const SurfaceSample& sample : batch) put(out, sample);
    }
}

bool get(ByteReader& in, SampleBatches& batches)
{
    uint64_t count = 0;
    if (!get_count(in, sizeof count, count)) return false;
    for (uint64_t b = 0; b < count; ++b) {
        uint64_t samples = 0;
        if (!get_count(in, kSampleBytes, samples)) return false;
        batches.emplace_back();
        for (uint64_t s = 0; s < samples; ++s) batches.back().push_back(get_sample(in));
    }
    return true;
}

void put(ByteWriter& out, const SurfaceModel& model)
{
    put_colours(out, model.texels);
    put_colours(out, model.nodes);
}

bool get(ByteReader& in, SurfaceModel& model)
{
    return get_colours(in, model.texels) && get_colours(in, model.nodes);
}

void put(ByteWriter& out, const ConjugateGradients& d)
{
    for (const std::vector<double>* numbers : {&d.x, &d.residual, &d.direction}) {
        out.put64(numbers->size());
        for (const double v : *numbers) out.put_double(v);
    }
    for (size_t c = 0; c < 3; ++c) {
        out.put_double(d.size[c]);
        out.put_double(d.first[c]);
    }
    out.put8(d.done ? 1 : 0);
}

bool get(ByteReader& in, ConjugateGradients& d)
{
    for (std::vector<double>* numbers : {&d.x, &d.residual, &d.direction}) {
        uint64_t count = 0;
        if (!get_count(in, sizeof(double), count)) return false;
        for (uint64_t k = 0; k < count; ++k) numbers->push_back(in.get_double());
    }
    for (size_t c = 0; c < 3; ++c) {
        d.size[c] = in.get_double();
        d.first[c] = in.get_double();
    }
    d.done = in.get8() != 0;
    return true;
}

void put(ByteWriter& out, const ProxyLoss& loss)
{
    for (const double v : {loss.missed, loss.added, loss.displaced}) out.put_double(v);
    for (const uint32_t v : {loss.rough ? 1u : 0u, loss.holes, loss.largest_hole}) out.put32(v);
}

bool get(ByteReader& in, ProxyLoss& loss)
{
    for (double* v : {&loss.missed, &loss.added, &loss.displaced}) *v = in.get_double();
    loss.rough = in.get32() != 0;
    loss.holes = in.get32();
    loss.largest_hole = in.get32();
    return true;
}

void BakeStages::fail_as_damaged() const
{
    throw BakeError(file_.path().string() + ": is damaged; discard it with --restart");
}

void BakeStages::require_shape(const ConjugateGradients& gradients, const SurfaceShape& shape) const
{
    const size_t numbers = 3 * empty_model(shape).nodes.size();
    if (gradients.x.size() != numbers || gradients.residual.size() != numbers || gradients.direction.size() != numbers)
        fail_as_damaged();
}

void BakeStages::require_shape(const SurfaceModel& model, const SurfaceShape& shape) const
{
    const SurfaceModel empty = empty_model(shape);
    if (model.texels.size() != empty.texels.size() || model.nodes.size() != empty.nodes.size()) fail_as_damaged();
}

void BakeStages::require_shape(const SampleBatches& batches, const SurfaceShape& shape) const
{
    for (const std::vector<SurfaceSample>& batch : batches) {
        for (const SurfaceSample& s : batch) {
            const uint32_t patch = s.triangle / 2;
            if (patch >= shape.mesh.patches.size() ||
                s.texel - shape.layout.rectangles[patch].begin >= shape.layout.rectangles[patch].size())
                fail_as_damaged();
        }
    }
}

BakeStages::BakeStages(const std::filesystem::path& file, const Digest::Value& scene) : file_(file)
{
    scene_.add(std::string(LUMI_VERSION));
    scene_.add(scene);
}

BakeStages::BakeStages(const std::filesystem::path& file, const Digest::Value& scene, SurfaceSettings settings)
    : BakeStages(file, scene)
{
    settings.threads = 0;
    ByteWriter bytes;
    put_settings(bytes, settings);
    scene_.add(bytes.bytes());
}

}  // namespace lumi::baker
