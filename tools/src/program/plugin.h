// SPDX-License-Identifier: MIT
// A plug-in adds this to the program. It lies in a folder of its own, registers itself, and nothing else includes it.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <vector>

#include "draw/draw.h"
#include "draw/draw_surface.h"
#include "draw/views.h"
#include "files/field_file.h"
#include "lumi/baker/scene.h"

namespace lumi::tools
{

// `lumi render` was asked for this.
struct RenderOptions {
    std::string field, output;
    ViewOptions views;
    std::string mode = "best";
    DrawSettings drawing;  // its mode is that of a chord field
    std::vector<PartPose> parts;
    std::vector<baker::StateOption> states, base_colours;  // of light states, and of tints
};

// Changes pictures after they are drawn, where its options ask for it.
class PictureStage
{
public:
    virtual ~PictureStage() = default;
    virtual void add_options(CLI::App& render) = 0;
    // `drawer`, or what draws changed pictures. Throws UsageError for options that do not go together, Failure for
    // files.
    virtual Drawer changed(const RenderOptions& options, const FieldFile& file, Drawer drawer) const = 0;
};

struct Plugin {
    void (*add_subcommand)(CLI::App& lumi);
    std::shared_ptr<PictureStage> (*make_stage)();
};

// Those that the program was linked with. A plug-in adds itself before main begins:
//     const bool kRegistered = (plugins().push_back({add_this, make_that}), true);
inline std::vector<Plugin>& plugins()
{
    static std::vector<Plugin> all;
    return all;
}

}  // namespace lumi::tools
