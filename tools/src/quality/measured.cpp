// SPDX-License-Identifier: MIT
#include "quality/measured.h"

#include <algorithm>
#include <ctime>

#include "draw/draw.h"
#include "draw/draw_surface.h"
#include "files/field_report.h"

namespace lumi::quality
{

namespace
{

// Processor time of this thread: other programs do not count.
double processor_ms()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

}  // namespace

Measured measured(const std::string& name, const std::string& layout, uint64_t flash_bytes, const DrawView& draw,
                  const std::vector<HeldOutView>& views, const std::vector<Reference>& references)
{
    Measured result;
    result.name = name;
    result.layout = layout;
    result.flash_bytes = flash_bytes;
    for (size_t v = 0; v < views.size(); ++v) {
        const double begin = processor_ms();
        result.pictures.push_back(draw(views[v]));
        result.draw_ms += (processor_ms() - begin) / static_cast<double>(views.size());
        result.figures.push_back(figures_of(result.pictures.back(), references[v]));
        result.worst.push_back(tools::worst_block(result.pictures.back(), references[v].picture));
    }
    result.mean = mean_of(result.figures);
    return result;
}

size_t worst_view(const Measured& m)
{
    const auto less = [](const Figures& a, const Figures& b) { return a.psnr_db < b.psnr_db; };
    return static_cast<size_t>(std::min_element(m.figures.begin(), m.figures.end(), less) - m.figures.begin());
}

size_t worst_block_view(const Measured& m)
{
    const auto less = [](const tools::Block& a, const tools::Block& b) { return a.psnr_db < b.psnr_db; };
    return static_cast<size_t>(std::min_element(m.worst.begin(), m.worst.end(), less) - m.worst.begin());
}

tools::Picture drawn(const tools::FieldFile& file, const HeldOutView& view)
{
    return file.is_surface() ? tools::draw_surface(file.surface(), view.eye)
                             : tools::draw(file.field(), view.eye.camera, {});
}

const char* layout_of(const tools::FieldFile& file)
{
    if (!file.is_surface()) return "chord";
    return file.surface().viewed_count == 0 ? "mean alone" : "surface";
}

Measured measured_field(const tools::FieldFile& file, const std::vector<HeldOutView>& views,
                        const std::vector<Reference>& references)
{
    const auto draw = [&](const HeldOutView& view) { return drawn(file, view); };
    Measured result = measured(file.path(), layout_of(file), file.size(), draw, views, references);
    result.sections = file.sections();
    if (file.is_surface()) result.triangles = tools::triangles_of(file.surface());
    return result;
}

namespace
{

std::vector<Measured> measured_modes(const tools::FieldFile& file, const std::vector<DrawMode>& modes,
                                     const std::vector<HeldOutView>& views, const std::vector<Reference>& references)
{
    std::vector<Measured> all;
    for (const DrawMode& mode : modes) {
        const auto draw = [&](const HeldOutView& view) {
            return tools::draw(file.field(), view.eye.camera, mode.settings);
        };
        all.push_back(measured(file.path(), mode.name, file.size(), draw, views, references));
    }
    return all;
}

}  // namespace

std::vector<Measured> measured_variants(const tools::FieldFile& file, const std::vector<DrawMode>& modes,
                                        const std::vector<HeldOutView>& views, const std::vector<Reference>& references)
{
    if (!file.is_surface()) return measured_modes(file, modes, views, references);
    std::vector<Measured> variants;
    for (const auto& [mode, name] :
         {std::pair(SurfaceMode::antialiased, "antialiased"), {SurfaceMode::one_sample, "one sample"}}) {
        const auto draw = [&, mode = mode](const HeldOutView& view) {
            return tools::draw_surface(file.surface(), view.eye, {mode});
        };
        variants.push_back(measured(file.path(), name, file.size(), draw, views, references));
        variants.back().triangles = tools::triangles_of(file.surface());
    }
    return variants;
}

}  // namespace lumi::quality
