// SPDX-License-Identifier: MIT
#include "bench/host_renderer.h"

#include <stdexcept>

#include "lumi/bench/views.h"
#include "lumi/chord/render_spans.h"
#include "lumi/detail/crc32.h"

namespace lumi::bench
{
namespace
{

// Where a traced texel policy notes its reads.
struct Trace {
    const uint8_t* file = nullptr;
    std::vector<Read> reads;

    void note(const uint8_t* at, uint32_t bytes) { reads.push_back({static_cast<uint32_t>(at - file), bytes}); }
};

thread_local Trace trace;

// A texel policy that behaves like Texel and tells what it reads.
template <class Texel>
struct Traced : Texel {
    static void note(const Field& field, const uint8_t* texel)
    {
        constexpr uint32_t kBytes = detail::format::bytes_per_texel(Texel::kFormat);
        constexpr uint32_t kEntryBytes = 4;
        trace.note(texel, kBytes);
        if (Texel::kFormat == TexelFormat::palette8) trace.note(field.palette + kEntryBytes * *texel, kEntryBytes);
    }
    static detail::Rgba8 load(const Field& field, const uint8_t* row, uint32_t j)
    {
        note(field, row + detail::format::bytes_per_texel(Texel::kFormat) * j);
        return Texel::load(field, row, j);
    }
};

}  // namespace
}  // namespace lumi::bench

// The sums of spans read texels by themselves.
template <class Texel, bool kCoverage>
struct lumi::detail::TexelSum<lumi::bench::Traced<Texel>, kCoverage> : lumi::detail::TexelSum<Texel, kCoverage> {
    struct Row : detail::TexelSum<Texel, kCoverage>::Row {
        void add(const Field& field, const uint8_t* texel, uint32_t weight)
        {
            bench::Traced<Texel>::note(field, texel);
            detail::TexelSum<Texel, kCoverage>::Row::add(field, texel, weight);
        }
    };
};

namespace lumi::bench
{
namespace
{

struct Job {
    int span;
    const Field& field;
    const Camera& camera;
};

// The paper's kernel is drawn exactly alone.
template <class Reconstruction>
inline constexpr bool kHasSpans = true;
template <uint32_t kNeighbours>
inline constexpr bool kHasSpans<Paper<kNeighbours>> = false;

template <class Reconstruction, class Texel, class Pixel>
RenderError draw_stripe(const Job& job, const Stripe& stripe)
{
    if (job.span == 0) return render<Reconstruction, Texel, Pixel>(job.field, job.camera, kBackground, stripe);
    if constexpr (kHasSpans<Reconstruction>)
        return render_spans<Reconstruction, Texel, Pixel>(job.field, job.camera, kBackground, stripe, job.span);
    throw std::logic_error("this mode is drawn without spans");
}

template <class Reconstruction, class Texel, class Pixel>
std::vector<uint8_t> frame_bytes(const Job& job)
{
    constexpr uint32_t kStrideBytes = kSidePx * Pixel::kBytes;
    std::vector<uint8_t> pixels(kSidePx * kStrideBytes);
    const Stripe stripe = {pixels.data(), 0, 0, kSidePx, kSidePx, kStrideBytes};
    if (draw_stripe<Reconstruction, Texel, Pixel>(job, stripe) != RenderError::none)
        throw std::logic_error("the field's texels are not the policy's");
    return pixels;
}

template <class Reconstruction, class Texel>
HostFrame draw_frame(const Job& job)
{
    HostFrame frame;
    frame.picture = tools::Picture(kSidePx, kSidePx);
    frame.picture.rgb = frame_bytes<Reconstruction, Texel, PixelRgb888>(job);
    trace.reads.clear();
    frame_bytes<Reconstruction, Traced<Texel>, PixelRgb565>(job);
    frame.reads = std::move(trace.reads);
    const std::vector<uint8_t> shown = frame_bytes<Reconstruction, Texel, PixelRgb565>(job);
    frame.rgb565_crc = detail::crc32(0, shown.data(), shown.size());
    return frame;
}

template <class Reconstruction>
HostFrame choose_texel(const Job& job)
{
    return detail::with_texel(
        job.field.texel_format, [&](auto texel) { return draw_frame<Reconstruction, decltype(texel)>(job); });
}

}  // namespace

HostFrame draw_on_host(const std::string& mode, int span, const Field& field, const uint8_t* file, const Camera& camera)
{
    trace.file = file;
    const Job job = {span, field, camera};
    if (mode == "nearest") return choose_texel<Nearest>(job);
    if (mode == "linear") return choose_texel<Linear>(job);
    if (mode == "paper") return choose_texel<Paper<5>>(job);
    throw std::logic_error("no renderer is called " + mode);
}

}  // namespace lumi::bench
