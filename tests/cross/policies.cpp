// SPDX-License-Identifier: MIT
// Combinations of reconstruction × texel × pixel × background that core offers, and all of core's functions that
// firmware calls, for tests that read symbols and stack sizes. Never run. LUMI_POLICIES says which combinations: `all`;
// `pairs`: any two choices meet in one of them; `each`: every reconstruction is in one.
#include <tuple>
#include <type_traits>
#include <utility>

#include "lumi/chord/render_spans.h"
#include "lumi/surface/render.h"
#include "lumi/surface/view.h"

namespace lumi::policies
{

using Render = RenderError (*)(const Field&, const Camera&, const void* background, const Stripe&);

template <class Reconstruction, class Texel, class Pixel, class Background>
RenderError draw(const Field& field, const Camera& camera, const void* background, const Stripe& stripe)
{
    return render<Reconstruction, Texel, Pixel>(field, camera, *static_cast<const Background*>(background), stripe);
}

// A reconstruction drawn by spans.
template <class Reconstruction>
struct BySpans;

template <class Reconstruction, class Texel, class Pixel, class Background>
struct Policy {
    static constexpr Render kDraw = draw<Reconstruction, Texel, Pixel, Background>;
};

template <class Reconstruction, class Texel, class Pixel, class Background>
RenderError draw_spans(const Field& field, const Camera& camera, const void* background, const Stripe& stripe)
{
    constexpr int32_t kSpanPx = 16;
    return render_spans<Reconstruction, Texel, Pixel>(field, camera, *static_cast<const Background*>(background),
                                                      stripe, kSpanPx);
}

template <class Reconstruction, class Texel, class Pixel, class Background>
struct Policy<BySpans<Reconstruction>, Texel, Pixel, Background> {
    static constexpr Render kDraw = draw_spans<Reconstruction, Texel, Pixel, Background>;
};

// The paper's kernel occurs in its smallest, default and largest size.
using Reconstructions =
    std::tuple<Nearest, Linear, Paper<1>, Paper<5>, Paper<detail::kMaxNeighbours>, BySpans<Nearest>, BySpans<Linear>>;
template <class... Texel>
std::tuple<Texel...> tuple_of(detail::TexelList<Texel...>);
using Texels = decltype(tuple_of(detail::AllTexels()));
using Pixels = std::tuple<PixelRgb565, PixelRgb565Swapped, PixelRgb888, PixelGrey8>;
using Backgrounds = std::tuple<OverBlack, OverColour, OverStripe>;

constexpr size_t kReconstructions = std::tuple_size_v<Reconstructions>;
constexpr size_t kTexels = std::tuple_size_v<Texels>;
constexpr size_t kPixels = std::tuple_size_v<Pixels>;
constexpr size_t kBackgrounds = std::tuple_size_v<Backgrounds>;
constexpr size_t kCombinations = kReconstructions * kTexels * kPixels * kBackgrounds;

enum class Choice { all, pairs, each };
constexpr Choice kChoice = Choice::LUMI_POLICIES;

// A combination as the places of its parts in the lists above.
struct Combination {
    size_t reconstruction, texel, pixel, background;

    constexpr explicit Combination(size_t index)
        : reconstruction(index / kBackgrounds / kPixels / kTexels),
          texel(index / kBackgrounds / kPixels % kTexels),
          pixel(index / kBackgrounds % kPixels),
          background(index % kBackgrounds)
    {
    }
};

// `pairs` has one combination of each reconstruction and texel. Pixel and background count on with a sum of both
// places, which takes all values modulo 12: 4 and 3 have no common divisor, so every pair of those meets, too.
constexpr bool is_chosen(const Combination& of, Choice choice)
{
    if (choice == Choice::all) return true;
    const size_t sum = 5 * of.reconstruction + of.texel;
    if (of.pixel != sum % kPixels || of.background != sum % kBackgrounds) return false;
    return choice == Choice::pairs || of.texel == of.reconstruction % kTexels;
}

// How many pairs of choices no chosen combination holds.
constexpr int missing_pairs(Choice choice)
{
    constexpr size_t kLists = 4;
    bool met[kLists][kLists][kReconstructions][kReconstructions] = {};
    for (size_t i = 0; i < kCombinations; ++i) {
        const Combination of(i);
        if (!is_chosen(of, choice)) continue;
        const size_t place[kLists] = {of.reconstruction, of.texel, of.pixel, of.background};
        for (size_t a = 0; a < kLists; ++a)
            for (size_t b = 0; b < kLists; ++b) met[a][b][place[a]][place[b]] = true;
    }
    constexpr size_t kSizes[kLists] = {kReconstructions, kTexels, kPixels, kBackgrounds};
    int missing = 0;
    for (size_t a = 0; a < kLists; ++a)
        for (size_t b = 0; b < a; ++b)
            for (size_t i = 0; i < kSizes[a]; ++i)
                for (size_t j = 0; j < kSizes[b]; ++j) missing += met[a][b][i][j] ? 0 : 1;
    return missing;
}
static_assert(missing_pairs(Choice::pairs) == 0, "any two choices meet");

template <size_t kIndex>
constexpr Render policy()
{
    constexpr Combination kOf(kIndex);
    if constexpr (is_chosen(kOf, kChoice)) {
        return Policy<std::tuple_element_t<kOf.reconstruction, Reconstructions>,
                      std::tuple_element_t<kOf.texel, Texels>, std::tuple_element_t<kOf.pixel, Pixels>,
                      std::tuple_element_t<kOf.background, Backgrounds>>::kDraw;
    } else {
        return nullptr;
    }
}

template <class Indices>
struct Policies;

template <size_t... kIndex>
struct Policies<std::index_sequence<kIndex...>> {
    Render draw[sizeof...(kIndex)] = {policy<kIndex>()...};
};
using ChosenPolicies = Policies<std::make_index_sequence<kCombinations>>;

extern const ChosenPolicies kChosenPolicies;
const ChosenPolicies kChosenPolicies = {};

// Surface fields. What firmware holds between stripes, the frame too, is not on its stack.
struct SurfaceView {
    SurfaceField field;
    SurfaceCamera camera;
    SurfaceMemory memory;
    SurfaceFrame frame;
    SurfaceHalves halves;
    void* samples;
};
using PrepareSurface = void (*)(SurfaceView&, SurfaceMode);
using DrawSurface = void (*)(const SurfaceView&, const void* background, const Stripe&);

template <class Pixel>
void prepare_surface_frame(SurfaceView& view, SurfaceMode mode)
{
    prepare_surface<Pixel>(view.field, view.camera, mode, view.memory, view.frame);
}

template <class Pixel>
void prepare_surface_by_halves(SurfaceView& view, SurfaceMode mode)
{
    prepare_surface<Pixel>(
        view.field, view.camera, mode, view.memory, view.frame, view.halves,
        [&](int32_t step) {
            prepare_half(view.halves, step, 0);
            prepare_half(view.halves, step, 1);
        });
}

template <class Pixel, class Background>
void draw_surface(const SurfaceView& view, const void* background, const Stripe& stripe)
{
    render_surface<Pixel>(view.frame, *static_cast<const Background*>(background), stripe, view.samples);
}

template <class Pixel>
struct SurfacePixels {
    PrepareSurface prepare = prepare_surface_frame<Pixel>;
    PrepareSurface prepare_by_halves = prepare_surface_by_halves<Pixel>;
    DrawSurface over_black = draw_surface<Pixel, OverBlack>;
    DrawSurface over_colour = draw_surface<Pixel, OverColour>;
    DrawSurface over_stripe = draw_surface<Pixel, OverStripe>;
};

// A view's calls, as a firmware makes them.
using PolicyView = View<SurfaceDrawing<1000, 1000>, Screen<>>;

ViewError draw_surface_view_open(PolicyView& view, const uint8_t* bytes, size_t size)
{
    return view.open(bytes, size);
}

ViewError draw_surface_view_look(PolicyView& view, const Orbit& orbit)
{
    return view.look(orbit);
}

ViewError draw_surface_view_look_by_halves(PolicyView& view, PolicyView::Halves& halves, const Orbit& orbit)
{
    return view.look(
        orbit, halves,
        [&](int32_t step) {
            halves.prepare(step, 0);
            halves.prepare(step, 1);
        });
}

ViewError draw_surface_view_draw(PolicyView& view, const Stripe& stripe)
{
    return view.draw(stripe);
}

ViewError draw_surface_view_over_nothing(PolicyView& view, const Stripe& stripe)
{
    return view.draw(stripe, OverNothing{});
}

// Views of fields with see-through parts.
constexpr SurfaceMode kAnyMode = SurfaceMode::two_by_two;
constexpr SurfaceFeatures kAllFeatures = SurfaceFeatures::all;

template <class Pixel>
void prepare_surface_see_through(SurfaceView& view, SurfaceMode mode)
{
    prepare_surface<Pixel, kAnyMode, kAllFeatures>(view.field, view.camera, mode, view.memory, view.frame);
}

template <class Pixel, class Background>
void draw_surface_see_through(const SurfaceView& view, const void* background, const Stripe& stripe)
{
    const Background& behind = *static_cast<const Background*>(background);
    render_surface<Pixel, kAnyMode, kAllFeatures>(view.frame, behind, stripe, view.samples);
}

FieldError draw_surface_open_see_through(SurfaceView& view, const uint8_t* bytes, size_t size)
{
    return open_surface<kAllFeatures>(bytes, size, view.field);
}

bool draw_surface_weigh(SurfaceView& view, uint32_t state, const StateWeight& weight)
{
    return set_state(view.field, view.memory, state, weight);
}

void draw_surface_see_through_coverage(const SurfaceView& view, const Stripe& stripe)
{
    render_coverage<kAllFeatures>(view.frame, stripe, view.samples);
}

template <class Pixel>
struct SeeThroughPixels {
    PrepareSurface prepare = prepare_surface_see_through<Pixel>;
    DrawSurface over_black = draw_surface_see_through<Pixel, OverBlack>;
    DrawSurface over_colour = draw_surface_see_through<Pixel, OverColour>;
    DrawSurface over_stripe = draw_surface_see_through<Pixel, OverStripe>;
    DrawSurface over_nothing = draw_surface_see_through<Pixel, OverNothing>;
};

struct EverySeeThrough {
    SeeThroughPixels<PixelRgb565> rgb565;
    SeeThroughPixels<PixelRgb565Swapped> rgb565_swapped;
    SeeThroughPixels<PixelRgb888> rgb888;
    SeeThroughPixels<PixelArgb8888> argb8888;
};
extern const EverySeeThrough kEverySeeThrough;
const EverySeeThrough kEverySeeThrough = {};

struct EverySurface {
    SurfacePixels<PixelRgb565> rgb565;
    SurfacePixels<PixelRgb565Swapped> rgb565_swapped;
    SurfacePixels<PixelRgb888> rgb888;
    SurfacePixels<PixelGrey8> grey8;
    SurfacePixels<PixelBgr555> bgr555;
    SurfacePixels<PixelArgb8888> argb8888;
};
extern const EverySurface kEverySurface;
const EverySurface kEverySurface = {};

}  // namespace lumi::policies
