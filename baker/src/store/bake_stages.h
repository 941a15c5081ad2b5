// SPDX-License-Identifier: MIT
// What a surface bake's stages give, kept from one process to the next: mesh, pilot, solution. The light between pilot
// and solution has a checkpoint of its own (surface/surface_file_store.h).
#pragma once

#include <optional>

#include "lumi/baker/surface.h"
#include "store/stage_file.h"
#include "util/byte_stream.h"

namespace lumi::baker
{

class BakeStages
{
public:
    // Bakes of this scene (with these settings) share results, whatever their threads. An empty path keeps nothing.
    BakeStages(const std::filesystem::path& file, const Digest::Value& scene);
    BakeStages(const std::filesystem::path& file, const Digest::Value& scene, SurfaceSettings settings);

    // What make() returns, or what was kept of it under the same name and settings (numbers, or structs of nothing but
    // numbers of one size). byte_stream.h says how a result becomes bytes.
    template <class Result, class Make, class... Settings>
    Result once(const char* name, Make make, const Settings&... settings)
    {
        Digest digest = scene_;
        digest.add(std::string(name));
        (digest.add(settings), ...);
        const Digest::Value key = digest.value();
        if (std::vector<uint8_t> bytes; file_.find(key, bytes))
            if (std::optional<Result> kept = from_bytes<Result>(bytes)) return std::move(*kept);
        Result result = make();
        file_.add(key, to_bytes(result));
        return result;
    }

    // Throws BakeError unless what was kept has the shape that the bake needs.
    void require_shape(bool fits) const;

private:
    StageFile file_;
    Digest scene_;
};

}  // namespace lumi::baker
