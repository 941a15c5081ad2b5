// SPDX-License-Identifier: MIT
// Compiled with a core in a namespace of its own: `lumi` is a macro here, and LUMI_COUNT_WORK is defined.
#include "planner/counted.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <vector>

#include "lumi/chord/render_spans.h"
#include "lumi/surface/render.h"

namespace lumi::planner
{

namespace
{

// Returns what core of the other namespace holds, as this one names it.
template <class T>
T same_bytes(const void* of)
{
    static_assert(std::is_trivially_copyable_v<T>);
    T copy;
    std::memcpy(static_cast<void*>(&copy), of, sizeof copy);
    return copy;
}

// Adds what is counted while it lives.
class Tally
{
public:
    explicit Tally(uint64_t* work) : work_(work) { std::fill_n(detail::work_done, detail::kWorks, 0); }
    Tally(const Tally&) = delete;
    Tally& operator=(const Tally&) = delete;
    ~Tally() { add_to(work_); }

    // Adds what has been done up to now.
    static void add_to(uint64_t* work)
    {
        for (uint32_t k = 0; k < detail::kWorks; ++k) work[k] += detail::work_done[k];
    }

private:
    uint64_t* work_;
};

template <class Draw>
void draw_stripes(int32_t width, int32_t height, int32_t rows, const Draw& draw)
{
    const uint32_t stride = static_cast<uint32_t>(width) * PixelRgb565::kBytes;
    std::vector<uint32_t> pixels(static_cast<size_t>(stride) * static_cast<size_t>(rows) / sizeof(uint32_t) + 1);
    auto* const first = reinterpret_cast<uint8_t*>(pixels.data());
    for (int32_t y = 0; y < height; y += rows) draw(Stripe{first, 0, y, width, std::min(rows, height - y), stride});
}

// Where texels are read.
struct Trace {
    const uint8_t* first = nullptr;
    lumi_note_read note = nullptr;
    void* reads = nullptr;

    void read(const uint8_t* at, uint32_t bytes) const { note(reads, static_cast<uint32_t>(at - first), bytes); }
};
thread_local Trace trace;

// Behaves like Texel and tells what it reads.
template <class Texel>
struct Traced : Texel {
    static void note(const Field& field, const uint8_t* texel)
    {
        constexpr uint32_t kEntryBytes = 4;
        trace.read(texel, detail::format::bytes_per_texel(Texel::kFormat));
        if (Texel::kFormat == TexelFormat::palette8) trace.read(field.palette + kEntryBytes * *texel, kEntryBytes);
    }
    static detail::Rgba8 load(const Field& field, const uint8_t* row, uint32_t j)
    {
        note(field, row + detail::format::bytes_per_texel(Texel::kFormat) * j);
        return Texel::load(field, row, j);
    }
};

}  // namespace
}  // namespace lumi::planner

// The sums of spans read texels by themselves.
template <class Texel, bool kCoverage>
struct lumi::detail::TexelSum<lumi::planner::Traced<Texel>, kCoverage> : lumi::detail::TexelSum<Texel, kCoverage> {
    struct Row : detail::TexelSum<Texel, kCoverage>::Row {
        void add(const Field& field, const uint8_t* texel, uint32_t weight)
        {
            planner::Traced<Texel>::note(field, texel + detail::TexelSum<Texel, kCoverage>::kBefore);
            detail::TexelSum<Texel, kCoverage>::Row::add(field, texel, weight);
        }
    };
};

namespace lumi::planner
{

namespace
{

template <class Reconstruction, bool kHasSpans>
void draw_chord(const Field& field, const Camera& camera, int32_t span_px, int32_t rows)
{
    detail::with_texel(
        field.texel_format,
        [&](auto texel) {
            using Texel = Traced<decltype(texel)>;
            draw_stripes(
                camera.width_px(), camera.height_px(), rows,
                [&](const Stripe& stripe) {
                    RenderError error = RenderError::unfit_for_spans;
                    if constexpr (kHasSpans)
                        if (span_px != 0)
                            error = render_spans<Reconstruction, Texel, PixelRgb565>(field, camera, OverBlack(), stripe,
                                                                                     span_px);
                    if (error != RenderError::none)
                        static_cast<void>(
                            render<Reconstruction, Texel, PixelRgb565>(field, camera, OverBlack(), stripe));
                });
        });
}

}  // namespace

}  // namespace lumi::planner

void lumi_count_surface(const void* of_field, const void* of_camera, int of_mode, int32_t stripe_rows, uint64_t* work,
                        uint64_t* preparing)
{
    using namespace lumi;
    const auto field = planner::same_bytes<SurfaceField>(of_field);
    const auto camera = planner::same_bytes<SurfaceCamera>(of_camera);
    const auto mode = static_cast<SurfaceMode>(of_mode);
    const uint32_t band_log2 = surface_band_log2(stripe_rows);
    std::vector<SurfaceVertex> vertices(field.vertex_count);
    std::vector<uint16_t> links(surface_links(field.patch_count)), bands(surface_bands(camera.height_px, band_log2));
    std::vector<uint32_t> features(feature_words(field)),
        samples(surface_stripe_bytes(camera.width_px, stripe_rows, mode) / sizeof(uint32_t) + 1);
    SurfaceFrame frame;
    const planner::Tally tally(work);
    prepare_surface<PixelRgb565, SurfaceMode::two_by_two, SurfaceFeatures::all>(
        field, camera, mode, {vertices.data(), links.data(), bands.data(), band_log2, features.data()}, frame);
    planner::Tally::add_to(preparing);
    planner::draw_stripes(camera.width_px, camera.height_px, stripe_rows, [&](const Stripe& stripe) {
        render_surface<PixelRgb565, SurfaceMode::two_by_two, SurfaceFeatures::all>(frame, OverBlack(), stripe,
                                                                                   samples.data());
    });
}

void lumi_count_chord(const void* of_field, const void* of_camera, int mode, int32_t span_px, int32_t stripe_rows,
                      uint64_t* work, lumi_note_read note, void* reads)
{
    using namespace lumi;
    const auto field = planner::same_bytes<Field>(of_field);
    const auto camera = planner::same_bytes<Camera>(of_camera);
    planner::trace = {field.texels, note, reads};
    const planner::Tally tally(work);
    enum { kNearest, kLinear, kPaper };
    if (mode == kNearest) planner::draw_chord<Nearest, true>(field, camera, span_px, stripe_rows);
    if (mode == kLinear) planner::draw_chord<Linear, true>(field, camera, span_px, stripe_rows);
    if (mode == kPaper) planner::draw_chord<Paper<5>, false>(field, camera, span_px, stripe_rows);
}
