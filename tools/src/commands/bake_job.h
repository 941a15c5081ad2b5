// SPDX-License-Identifier: MIT
// What `lumi bake` bakes, and where to.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "lumi/baker/chord.h"
#include "lumi/baker/surface.h"

namespace lumi::tools
{

struct BakeJob {
    baker::BakeSettings settings;
    std::optional<baker::SurfaceSettings> surface;     // in place of them
    std::shared_ptr<const baker::SurfaceDraft> draft;  // the draft of `surface`, if there is one already
    std::optional<baker::Shard> shard;
    std::string name;    // the field or the shard file, as the caller names it
    std::string target;  // the file behind the name
    baker::Earlier earlier = baker::Earlier::resume;
};

struct BakeOutcome {
    baker::Progress last;
    std::optional<baker::SurfaceBake> surface;
    double rays = 0;  // light paths that the field was made of
};

// Throws Interrupted, telling what is kept of a bake of `output`.
[[noreturn]] void throw_interrupted(const std::string& output);

// Throws Interrupted.
BakeOutcome run_job(const baker::Scene& scene, const BakeJob& job, const baker::ProgressCallback& progress);

}  // namespace lumi::tools
