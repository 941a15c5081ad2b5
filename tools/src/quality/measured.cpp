// SPDX-License-Identifier: MIT
#include "quality/measured.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

#include "draw/draw.h"
#include "draw/draw_surface.h"
#include "files/field_report.h"
#include "lumi/detail/lattice.h"
#include "quality/references.h"

namespace lumi::quality
{

namespace
{

using tools::DrawSettings;
using tools::Mode;

bool set_reconstruction(std::string_view word, DrawSettings& settings)
{
    for (const Mode mode : {Mode::nearest, Mode::linear})
        if (word == name_of(mode)) {
            settings.mode = mode;
            return true;
        }
    const std::string_view paper = name_of(Mode::paper);
    if (word.size() != paper.size() + 1 || word.substr(0, paper.size()) != paper) return false;
    settings.mode = Mode::paper;
    settings.neighbours = static_cast<uint32_t>(word.back() - '0');
    return word.back() >= '1' && settings.neighbours <= detail::kMaxNeighbours;
}

bool set_span(std::string_view word, DrawSettings& settings)
{
    constexpr std::pair<std::string_view, int32_t> kSpans[] = {{"2", 2}, {"4", 4}, {"8", 8}, {"16", 16}};
    for (const auto& [name, span] : kSpans)
        if (word == name) settings.span_px = span;
    return settings.span_px > 0 && settings.mode != Mode::paper;
}

}  // namespace

std::optional<DrawMode> parse_draw_mode(std::string_view text)
{
    DrawMode mode = {std::string(text), {}};
    const size_t slash = text.find('/');
    if (!set_reconstruction(text.substr(0, slash), mode.settings)) return std::nullopt;
    if (slash != std::string_view::npos && !set_span(text.substr(slash + 1), mode.settings)) return std::nullopt;
    return mode;
}

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
        const tools::Picture picture = draw(views[v]);
        result.draw_ms += (processor_ms() - begin) / static_cast<double>(views.size());
        result.figures.push_back(figures_of(picture, references[v]));
        result.pictures.push_back(picture);
    }
    result.mean = mean_of(result.figures);
    return result;
}

size_t worst_view(const Measured& m)
{
    const auto less = [](const Figures& a, const Figures& b) { return a.psnr_db < b.psnr_db; };
    return static_cast<size_t>(std::min_element(m.figures.begin(), m.figures.end(), less) - m.figures.begin());
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

Measured measured_field(const tools::FieldFile& file, const Yardstick& by)
{
    const auto draw = [&](const HeldOutView& view) { return drawn(file, view, by.way); };
    Measured result = measured(file.path(), layout_of(file), file.size(), draw, by.views, by.references);
    result.way = by.way;
    result.sections = file.sections();
    if (file.is_surface()) result.triangles = tools::triangles_of(file.surface());
    return result;
}

std::vector<Measured> measured_variants(const tools::FieldFile& file, const std::vector<DrawMode>& modes,
                                        const Yardstick& by)
{
    std::vector<Measured> variants;
    const auto add = [&](const std::string& name, const Way& variant) {
        variants.push_back(measured_field(file, {by.views, by.references, variant}));
        variants.back().layout = name;
        variants.back().sections.clear();
    };
    Way variant = by.way;
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
        variant.chord.display = by.way.chord.display;
        add(mode.name, variant);
    }
    return variants;
}

namespace
{

constexpr int kSidePx = 240;
constexpr uint32_t kSamples = 2;  // light paths a pixel of either reference

double squared_error(const tools::Picture& x, const tools::Picture& a, const tools::Picture& b)
{
    double sum = 0;
    for (size_t i = 0; i < x.rgb.size(); ++i) sum += (1.0 * x.rgb[i] - a.rgb[i]) * (1.0 * x.rgb[i] - b.rgb[i]);
    return sum / static_cast<double>(x.rgb.size());
}

double decibels(double squared_error)
{
    constexpr double kWhite = 255;
    if (squared_error <= 0) return kIdenticalDb;
    return std::min(kIdenticalDb, 10 * std::log10(kWhite * kWhite / squared_error));
}

}  // namespace

QuickMeasure::QuickMeasure(const baker::Scene& scene, int side_px, double cap, unsigned threads,
                           const baker::ProgressCallback& progress)
    : views_(held_out_views(ViewSet::all, kQuickViews, side_px, cap))
{
    const auto half = [&](uint64_t seed) { return baker::ReferenceSettings{kSamples, seed, threads}; };
    const uint64_t rays = rays_of(views_, half(1));
    baker::JobSeries series(progress, 2 * rays);
    for (const uint64_t seed : {uint64_t{1}, uint64_t{2}})
        halves_[seed - 1] = references_of(scene, views_, half(seed), {}, series.next(rays));
}

double QuickMeasure::psnr_db(const DrawView& draw) const
{
    double sum = 0;
    for (size_t v = 0; v < views_.size(); ++v)
        sum += decibels(squared_error(draw(views_[v]), halves_[0][v].picture, halves_[1][v].picture));
    return sum / static_cast<double>(views_.size());
}

double quick_psnr_db(const baker::Scene& scene, const tools::FieldFile& field, double cap, unsigned threads,
                     const baker::ProgressCallback& progress)
{
    const QuickMeasure measure(scene, kSidePx, cap, threads, progress);
    return measure.psnr_db([&](const HeldOutView& view) { return drawn(field, view); });
}

}  // namespace lumi::quality
