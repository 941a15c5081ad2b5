// SPDX-License-Identifier: MIT
#include "bench/fields.h"

#include <stdexcept>

#include "lumi/baker/scene.h"
#include "lumi/chord/texel.h"
#include "terminal/failure.h"
#include "terminal/progress_printer.h"

namespace lumi::bench
{
namespace
{

std::string file_name(const FieldSettings& settings, const std::string& texel)
{
    return settings.scene.stem().string() + "-" + std::to_string(settings.origins) + "x" +
           std::to_string(settings.directions) + "-" + std::to_string(settings.samples) + "." + texel + ".lumi";
}

void bake(const FieldSettings& settings, const std::string& texel, const std::filesystem::path& path)
{
    std::vector<std::string> warnings;
    const baker::Scene scene = baker::load_scene(settings.scene, {}, warnings);
    baker::BakeSettings bake;
    bake.origins = settings.origins;
    bake.directions = settings.directions;
    bake.samples = settings.samples;
    bake.texel = texel_format(texel);
    tools::ProgressPrinter printer(stderr, tools::stderr_is_terminal());
    try {
        baker::bake_field(scene, bake, path, tools::watch(printer));
    } catch (const baker::Cancelled&) {
        throw tools::Interrupted();
    }
}

}  // namespace

format::TexelFormat texel_format(const std::string& texel)
{
    for (const format::TexelFormat format : AllTexels::kFormats)
        if (texel == texel_name(format)) return format;
    throw std::logic_error("no texel format is called " + texel);
}

std::filesystem::path require_field(const FieldSettings& settings, const std::string& texel,
                                    const std::filesystem::path& work)
{
    const std::filesystem::path path = work / file_name(settings, texel);
    if (!std::filesystem::exists(path)) bake(settings, texel, path);
    return path;
}

}  // namespace lumi::bench
