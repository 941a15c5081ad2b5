// SPDX-License-Identifier: MIT
#include "quality/measured.h"

#include <algorithm>
#include <ctime>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "draw/draw.h"
#include "draw/draw_surface.h"
#include "files/field_report.h"
#include "files/output_file.h"
#include "image/picture_file.h"
#include "lumi/detail/lattice.h"
#include "util/digest.h"

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

// A picture of a field, and how good it is.
struct View {
    tools::Picture picture;
    Figures figures;
    tools::Block worst;
    double draw_ms;
};

View measured_view(const HeldOutView& view, const Reference& reference, const DrawView& draw)
{
    const double begin = processor_ms();
    View result = {draw(view), {}, {}, 0};
    result.draw_ms = processor_ms() - begin;
    result.figures = figures_of(result.picture, reference);
    result.worst = tools::worst_block(result.picture, reference.picture);
    return result;
}

using Json = nlohmann::ordered_json;

Json json_of(const View& v)
{
    const Figures& f = v.figures;
    return {{"figures", {f.psnr_db, f.ssim, f.cw_ssim, f.flip, f.mask_psnr_db, f.mask_ssim}},
            {"worst", {v.worst.x, v.worst.y, v.worst.psnr_db}},  // infinity becomes null
            {"draw_ms", v.draw_ms}};
}

bool lies_in(double value, double least, double most)
{
    constexpr double kRounding = 1e-9;
    return value >= least - kRounding && value <= most + kRounding;  // no NaN does
}

bool are_figures(const Figures& f)
{
    return lies_in(f.psnr_db, 0, kIdenticalDb) && lies_in(f.mask_psnr_db, 0, kIdenticalDb) && lies_in(f.ssim, -1, 1) &&
           lies_in(f.mask_ssim, -1, 1) && lies_in(f.cw_ssim, -1, 1) && lies_in(f.flip, 0, 1);
}

// Nothing where a number cannot be measured on that picture.
std::optional<View> view_of(const Json& json, tools::Picture picture)
{
    const Json &f = json.at("figures"), &worst = json.at("worst");
    const double block_db = worst.at(2).is_null() ? std::numeric_limits<double>::infinity() : worst.at(2).get<double>();
    View view = {std::move(picture),
                 {f.at(0), f.at(1), f.at(2), f.at(3), f.at(4), f.at(5)},
                 {worst.at(0), worst.at(1), block_db},
                 json.at("draw_ms")};
    constexpr double kDayMs = 24 * 3600e3;
    const bool is_block = lies_in(view.worst.x, 0, view.picture.width_px - 1) &&
                          lies_in(view.worst.y, 0, view.picture.height_px - 1) && view.worst.psnr_db >= 0;
    if (!is_block || !are_figures(view.figures) || !lies_in(view.draw_ms, 0, kDayMs)) return std::nullopt;
    return view;
}

std::string_view bytes_of(const std::vector<uint8_t>& bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// The struct holds nothing but numbers of one size, so that it has no padding.
template <class T>
std::string_view bytes_of(const T& numbers)
{
    static_assert(std::has_unique_object_representations_v<T>);
    return {reinterpret_cast<const char*>(&numbers), sizeof numbers};
}

// Reads what was kept, whole and of this size; whatever else lies there is measured again.
std::optional<View> view_in(const Kept& kept, const std::string& stem, const tools::Picture& reference)
{
    const std::string png = kept_bytes(stem + ".png").value_or("");
    const std::optional<std::string> text = kept.read(stem + ".json", png);
    if (!text) return std::nullopt;
    std::optional<tools::Picture> picture = kept_picture(png, reference.width_px, reference.height_px);
    if (!picture) return std::nullopt;
    try {
        return view_of(Json::parse(*text), std::move(*picture));
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

// Measures a view, or takes what was kept for `field`: the key of a file and a way to draw it.
View kept_view(const Kept& kept, const std::string& field, const HeldOutView& view, const Reference& reference,
               const DrawView& draw)
{
    if (!kept.keeps()) return measured_view(view, reference, draw);
    const std::string stem = kept.stem({"view", field, bytes_of(view.eye.pose), bytes_of(view.eye.image),
                                        bytes_of(reference.picture.rgb), bytes_of(reference.mask.values)});
    if (std::optional<View> earlier = view_in(kept, stem, reference.picture)) return std::move(*earlier);
    View result = measured_view(view, reference, draw);
    const std::string png = tools::png_bytes(result.picture);
    tools::write_output(stem + ".png", png);
    kept.write(stem + ".json", json_of(result).dump(), png);  // last: it says that both are there
    return result;
}

Measured named(const std::string& name, const std::string& layout, uint64_t flash_bytes)
{
    Measured result;
    result.name = name;
    result.layout = layout;
    result.flash_bytes = flash_bytes;
    return result;
}

void add_view(Measured& result, View view)
{
    result.pictures.push_back(std::move(view.picture));
    result.figures.push_back(view.figures);
    result.worst.push_back(view.worst);
    result.draw_ms += view.draw_ms;
}

void finish(Measured& result)
{
    result.mean = mean_of(result.figures);
    result.draw_ms /= static_cast<double>(result.figures.size());
}

}  // namespace

Measured measured(const std::string& name, const std::string& layout, uint64_t flash_bytes, const DrawView& draw,
                  const std::vector<HeldOutView>& views, const std::vector<Reference>& references)
{
    Measured result = named(name, layout, flash_bytes);
    for (size_t v = 0; v < views.size(); ++v) add_view(result, measured_view(views[v], references[v], draw));
    finish(result);
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

std::string key_of(const tools::FieldFile& file, const Way& way)
{
    baker::Digest digest;
    digest.add_bytes(file.bytes(), file.size());
    if (file.is_surface()) {
        digest.add(way.surface.mode);
        digest.add(way.surface.display);
        digest.add(way.surface.background);
    } else {
        digest.add(way.chord.mode);
        digest.add(way.chord.neighbours);
        digest.add(way.chord.span_px);
        digest.add(way.chord.display);
        digest.add(way.chord.background);
    }
    return std::string(bytes_of(digest.value()));
}

Measured measured_field(const tools::FieldFile& file, const Yardstick& by)
{
    const auto draw = [&](const HeldOutView& view) { return drawn(file, view, by.way); };
    const std::string field = by.kept.keeps() ? key_of(file, by.way) : "";
    Measured result = named(file.path(), layout_of(file), file.size());
    for (size_t v = 0; v < by.views.size(); ++v)
        add_view(result, kept_view(by.kept, field, by.views[v], by.references[v], draw));
    finish(result);
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
        variants.push_back(measured_field(file, {by.views, by.references, variant, by.kept}));
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

}  // namespace lumi::quality
