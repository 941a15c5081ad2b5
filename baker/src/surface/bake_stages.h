// SPDX-License-Identifier: MIT
// What a surface bake's stages give, kept from one process to the next: mesh, pilot, solution. The light between pilot
// and solution has a checkpoint of its own (surface_file_store.h).
#pragma once

#include "lumi/baker/surface.h"
#include "proxy/proxy_outside.h"
#include "store/stage_file.h"
#include "surface/mesh_draft.h"
#include "surface/surface_solver.h"
#include "util/byte_stream.h"

namespace lumi::baker
{

using SampleBatches = std::vector<std::vector<SurfaceSample>>;

// Appends a result, and reads it back. False, with the result unspecified, where the bytes are none.
void put(ByteWriter& out, const Mesh& mesh);  // positions and corners
bool get(ByteReader& in, Mesh& mesh);
void put(ByteWriter& out, const Outside& outside);
bool get(ByteReader& in, Outside& outside);
void put(ByteWriter& out, const MeshDraft& draft);
bool get(ByteReader& in, MeshDraft& draft);
void put(ByteWriter& out, const SampleBatches& batches);
bool get(ByteReader& in, SampleBatches& batches);
void put(ByteWriter& out, const SurfaceModel& model);
bool get(ByteReader& in, SurfaceModel& model);
void put(ByteWriter& out, const ConjugateGradients& gradients);
bool get(ByteReader& in, ConjugateGradients& gradients);
void put(ByteWriter& out, const ProxyLoss& loss);
bool get(ByteReader& in, ProxyLoss& loss);

class BakeStages
{
public:
    // Of bakes of this scene, or of it with these settings, whatever their threads. An empty path keeps nothing.
    BakeStages(const std::filesystem::path& file, const Digest::Value& scene);
    BakeStages(const std::filesystem::path& file, const Digest::Value& scene, SurfaceSettings settings);

    // What make() returns, or what was kept of it under the same name and settings (numbers, or structs of nothing but
    // numbers of one size).
    template <class Result, class Make, class... Settings>
    Result get(const char* name, Make make, const Settings&... settings)
    {
        Digest digest = scene_;
        digest.add(std::string(name));
        (digest.add(settings), ...);
        const Digest::Value key = digest.value();
        Result result;
        if (std::vector<uint8_t> bytes; file_.find(key, bytes)) {
            ByteReader in(bytes.data(), bytes.size());
            if (baker::get(in, result)) return result;
        }
        result = make();
        ByteWriter out;
        put(out, result);
        file_.add(key, out.bytes());
        return result;
    }

    // Throws BakeError where what was kept is of another shape.
    void require_shape(const SurfaceModel& model, const SurfaceShape& shape) const;
    void require_shape(const ConjugateGradients& gradients, const SurfaceShape& shape) const;
    void require_shape(const SampleBatches& batches, const SurfaceShape& shape) const;

private:
    [[noreturn]] void fail_as_damaged() const;

    StageFile file_;
    Digest scene_;
};

}  // namespace lumi::baker
