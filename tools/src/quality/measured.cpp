// SPDX-License-Identifier: MIT
#include "quality/measured.h"

#include "draw/draw.h"
#include "draw/draw_surface.h"

namespace lumi::quality
{

Measured measured(const std::string& name, const std::string& layout, uint64_t flash_bytes, const DrawView& draw,
                  const std::vector<HeldOutView>& views, const std::vector<Truth>& truths)
{
    Measured result = {name, layout, flash_bytes, {}, {}, {}, {}};
    for (size_t v = 0; v < views.size(); ++v) {
        result.pictures.push_back(draw(views[v]));
        result.figures.push_back(figures_of(result.pictures.back(), truths[v]));
    }
    result.mean = mean_of(result.figures);
    return result;
}

tools::Picture drawn(const tools::FieldFile& file, const HeldOutView& view)
{
    return file.is_surface() ? tools::draw_surface(file.surface(), view.eye)
                             : tools::draw(file.field(), view.eye.camera, {});
}

Measured measured_field(const tools::FieldFile& file, const std::vector<HeldOutView>& views,
                        const std::vector<Truth>& truths)
{
    const auto draw = [&](const HeldOutView& view) { return drawn(file, view); };
    Measured result = measured(file.path(), file.is_surface() ? "surface" : "chord", file.size(), draw, views, truths);
    result.sections = file.sections();
    return result;
}

}  // namespace lumi::quality
