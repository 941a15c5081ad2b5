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

Way finest(tools::DisplayFormat display)
{
    Way way;
    way.surface.display = way.chord.display = display;
    return way;
}

tools::Picture drawn(const tools::FieldFile& file, const HeldOutView& view, const Way& way)
{
    return file.is_surface() ? tools::draw_surface(file.surface(), view.eye, way.surface)
                             : tools::draw(file.field(), view.eye.camera, way.chord);
}

const char* layout_of(const tools::FieldFile& file)
{
    if (!file.is_surface()) return "chord";
    return file.surface().viewed_count == 0 ? "mean alone" : "surface";
}

Measured measured_field(const tools::FieldFile& file, const std::vector<HeldOutView>& views,
                        const std::vector<Reference>& references, const Way& way)
{
    const auto draw = [&](const HeldOutView& view) { return drawn(file, view, way); };
    Measured result = measured(file.path(), layout_of(file), file.size(), draw, views, references);
    result.way = way;
    result.sections = file.sections();
    if (file.is_surface()) result.triangles = tools::triangles_of(file.surface());
    return result;
}

std::vector<Measured> measured_variants(const tools::FieldFile& file, const std::vector<DrawMode>& modes,
                                        const std::vector<HeldOutView>& views, const std::vector<Reference>& references,
                                        const Way& way)
{
    std::vector<Measured> variants;
    const auto add = [&](const std::string& name, const Way& variant) {
        variants.push_back(measured_field(file, views, references, variant));
        variants.back().layout = name;
        variants.back().sections.clear();
    };
    Way variant = way;
    if (file.is_surface()) {
        for (const auto& [mode, name] :
             {std::pair(SurfaceMode::antialiased, "antialiased"), {SurfaceMode::one_sample, "one sample"}}) {
            variant.surface.mode = mode;
            add(name, variant);
        }
        return variants;
    }
    for (const DrawMode& mode : modes) {
        variant.chord = mode.settings;
        variant.chord.display = way.chord.display;
        add(mode.name, variant);
    }
    return variants;
}

}  // namespace lumi::quality
