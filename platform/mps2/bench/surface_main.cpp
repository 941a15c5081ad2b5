// SPDX-License-Identifier: MIT
// Counts what drawing a surface field costs, one line per view and mode:
//     view generic mode one-sample covered 42272 instructions 2345678 palette 8000 vertices 345678 lists 145678
//     lights 123456 edges 345678 samples 1345678 outlines 0 resolve 245678 order 0 blends 0 tall 2234567 stack 600
//     ram 46000 weigh 0 halves 345678 crc 1234abcd
// Parts add up to the instructions: the palette's colours and the camera's numbers; vertices on the image's grid; the
// triangles' lists; what vertices show to the eye; triangles and rows without their samples; samples; outlines; pixels.
// Then see-through triangles: their order, lights and palette; what they add to drawing; or what gloss maps add to
// both. "tall" are all instructions again, in stripes of kTallStripeHeight, "weigh" those of another weight of a light
// state, and "halves" those of preparing on two cores, as the longer half of each step takes. The field is loaded to
// the start of the board's PSRAM. Arguments: names of views (none: all), then of modes (none: all). With `poses` in
// place of views, a line for each of them and mode, in stripes of kTallStripeHeight:
//     pose 17 mode antialiased covered 42272 instructions 2345678 crc 1234abcd
// With `stripes`, a line for each height in kStripeHeights, view and mode:
//     stripes 4 view generic mode antialiased covered 42272 instructions 2345678 crc 1234abcd
#include "loaded_view.h"
#include "lumi/bench/views.h"
#include "lumi/detail/crc32.h"
#include "lumi/mps2/meters.h"
#include "surface_instance.h"
#include "text_line.h"

namespace lumi::bench
{
namespace
{

using firmware::TextLine;
uint8_t pixels[kSidePx * kSidePx * PixelRgb888::kBytes];

template <class Work>
__attribute__((noinline)) uint64_t instructions_of(const Work& work)
{
    const uint64_t begin = mps2::instructions();
    work();
    return mps2::instructions() - begin;
}

struct Parts {
    uint64_t palette, vertices, lists, lights, edges, samples, outlines, resolve, order, blends;
};

// Differences of next to nothing may come out below it: the counter ticks every few instructions.
uint64_t less(uint64_t count, uint64_t other)
{
    return count > other ? count - other : 0;
}

uint64_t count_frame(const SurfaceField& field, const SurfaceView& view, int32_t stripe_height)
{
    return instructions_of([&] { draw_surface(field, view, stripe_height, pixels); });
}

// Fields that lack a part tell what the part costs; gloss counts as see-through triangles do. `whole`: of a frame of
// the field.
Parts count_parts(const SurfaceField& field, const SurfaceView& view, uint64_t whole)
{
    const SurfaceField opaque = opaque_alone(field);
    SurfaceField unlit = opaque, bare = opaque, empty = opaque;
    unlit.lit_count = 0;
    unlit.state_count = 0;
    bare.patch_count = 0;
    empty.patch_count = empty.vertex_count = 0;
    const auto preparing = [&](const SurfaceField& f) {
        return instructions_of([&] { prepare_alone(f, view, kSurfaceStripeHeight); });
    };
    const uint64_t palette = preparing(empty), vertices = preparing(bare), lists = preparing(unlit);
    const uint64_t order = preparing(field), lights = preparing(opaque);
    const uint64_t edges = instructions_of([] { fill_alone(0, false); });
    const uint64_t samples = instructions_of([] { fill_alone(kSidePx, false); });
    const uint64_t all = instructions_of([] { fill_alone(kSidePx, true); });
    const uint64_t of_opaque = count_frame(opaque, view, kSurfaceStripeHeight);
    return {palette,
            less(vertices, palette),
            less(lists, vertices),
            less(lights, lists),
            edges,
            less(samples, edges),
            less(all, samples),
            less(of_opaque, lights + all),
            less(order, lights),
            less(whole, of_opaque + less(order, lights))};
}

void write_costs(TextLine& line, const Parts& parts, uint64_t whole, uint64_t tall)
{
    line.text(" instructions ").decimal(whole);
    line.text(" palette ").decimal(parts.palette).text(" vertices ").decimal(parts.vertices);
    line.text(" lists ").decimal(parts.lists).text(" lights ").decimal(parts.lights);
    line.text(" edges ").decimal(parts.edges).text(" samples ").decimal(parts.samples);
    line.text(" outlines ").decimal(parts.outlines);
    line.text(" resolve ").decimal(parts.resolve);
    line.text(" order ").decimal(parts.order).text(" blends ").decimal(parts.blends).text(" tall ").decimal(tall);
}

void report(const char* view_name, const char* mode_name, const SurfaceField& field, const SurfaceView& view,
            uint32_t covered, uint64_t weigh)
{
    const uint64_t tall = count_frame(field, view, kTallStripeHeight);
    mps2::StackMeter meter;
    meter.paint();
    const uint64_t whole = count_frame(field, view, kSurfaceStripeHeight);
    const uint32_t stack_bytes = meter.high_water_bytes();
    const uint32_t crc = detail::crc32(0, pixels, kSurfaceFrameBytes);
    const Parts parts = count_parts(field, view, whole);
    const uint64_t halves = prepare_by_halves(field, view, kSurfaceStripeHeight);
    TextLine line;
    line.text("view ").text(view_name).text(" mode ").text(mode_name).text(" covered ").decimal(covered);
    write_costs(line, parts, whole, tall);
    line.text(" stack ").decimal(stack_bytes).text(" ram ");
    line.decimal(surface_ram_bytes(field.vertex_count, field.patch_count, view.mode) + see_through_ram_bytes(field));
    line.text(" weigh ").decimal(weigh).text(" halves ").decimal(halves);
    mps2::write(line.text(" crc ").hex32(crc).text("\n").c_str());
}

bool is_mode(const char* word)
{
    for (const NamedSurfaceMode& mode : kSurfaceModes)
        if (std::strcmp(mode.name, word) == 0) return true;
    return false;
}

bool report_view(const View& view, const SurfaceField& field, const Words& modes, uint64_t weigh)
{
    SurfaceCamera camera;
    Camera rays;
    if (make_surface_camera(view_pose(view), view_image(view), camera) != CameraError::none) return false;
    if (make_view_camera(view, rays) != CameraError::none) return false;
    for (const NamedSurfaceMode& mode : kSurfaceModes)
        if (modes.contain(mode.name))
            report(view.name, mode.name, field, {camera, mode.mode}, covered_pixels(rays), weigh);
    return true;
}

bool report_pose(uint32_t number, const SurfaceField& field, const Words& modes)
{
    const PosedView view = posed_view(number);
    SurfaceCamera camera;
    Camera rays;
    if (make_surface_camera(view.pose, view.image, camera) != CameraError::none) return false;
    if (make_camera(view.pose, view.image, rays) != CameraError::none) return false;
    for (const NamedSurfaceMode& mode : kSurfaceModes) {
        if (!modes.contain(mode.name)) continue;
        TextLine line;
        line.text("pose ")
            .decimal(number)
            .text(" mode ")
            .text(mode.name)
            .text(" covered ")
            .decimal(covered_pixels(rays));
        line.text(" instructions ").decimal(count_frame(field, {camera, mode.mode}, kTallStripeHeight));
        mps2::write(line.text(" crc ").hex32(detail::crc32(0, pixels, kSurfaceFrameBytes)).text("\n").c_str());
    }
    return true;
}

bool report_poses(const SurfaceField& field, const Words& modes)
{
    for (uint32_t k = 0; k < kPoses; ++k)
        if (!report_pose(k, field, modes)) return false;
    return true;
}

constexpr int32_t kStripeHeights[] = {2, 4, 8, 12, 16, kTallStripeHeight};

bool report_stripes(const View& view, const SurfaceField& field, const Words& modes)
{
    SurfaceCamera camera;
    Camera rays;
    if (make_surface_camera(view_pose(view), view_image(view), camera) != CameraError::none) return false;
    if (make_view_camera(view, rays) != CameraError::none) return false;
    for (const NamedSurfaceMode& mode : kSurfaceModes) {
        if (!modes.contain(mode.name)) continue;
        for (const int32_t height : kStripeHeights) {
            TextLine line;
            line.text("stripes ").decimal(static_cast<uint32_t>(height)).text(" view ").text(view.name);
            line.text(" mode ").text(mode.name).text(" covered ").decimal(covered_pixels(rays));
            line.text(" instructions ").decimal(count_frame(field, {camera, mode.mode}, height));
            mps2::write(line.text(" crc ").hex32(detail::crc32(0, pixels, kSurfaceFrameBytes)).text("\n").c_str());
        }
    }
    return true;
}

bool report_all_stripes(const SurfaceField& field, const Words& modes)
{
    for (const View& view : kViews)
        if (!report_stripes(view, field, modes)) return false;
    return true;
}

bool report_views(const SurfaceField& field, const Words& words, uint64_t weigh)
{
    Words views = {words.begin, words.begin};
    while (views.end != words.end && !is_mode(*views.end)) ++views.end;
    for (const View& view : kViews)
        if (views.contain(view.name) && !report_view(view, field, {views.end, words.end}, weigh)) return false;
    return true;
}

}  // namespace
}  // namespace lumi::bench

int main(int argc, char** argv)
{
    using namespace lumi;
    SurfaceField field;
    if (!bench::open_loaded(open_surface<bench::kFeatures>, field)) return 1;
    mps2::start_instruction_counter();
    bench::weigh(field);
    const uint64_t weigh = bench::instructions_of([&] { bench::weigh(field); });
    const bench::Words words = bench::words_of(argc, argv);
    const auto begins_with = [&](const char* word) {
        return words.begin != words.end && std::strcmp(*words.begin, word) == 0;
    };
    const bench::Words modes = {words.begin + 1, words.end};
    const bool is_done = begins_with("poses")     ? bench::report_poses(field, modes)
                         : begins_with("stripes") ? bench::report_all_stripes(field, modes)
                                                  : bench::report_views(field, words, weigh);
    return is_done ? 0 : 1;
}
