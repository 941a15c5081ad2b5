// SPDX-License-Identifier: MIT
// Bad input gets this on a board, in C++ and in C: an error that has a text, no hang and no read past the field's end,
// which faults here (guarded_memory.h). LUMI_C_TEXEL tells a build for chord fields from one for surface fields. The
// emulator has loaded a field of the build's kind, and one of the other kind a MiB later. With the argument "wild" the
// program reads behind the guarded memory itself.
#include <cstring>
#include <initializer_list>

#include "guarded_memory.h"
#include "lumi/attitude.h"
#include "lumi/chord/view.h"
#include "lumi/detail/crc32.h"
#include "lumi/lumi.h"
#include "lumi/mps2/board.h"
#include "lumi/surface/view.h"

namespace
{

using namespace lumi;
using namespace lumi::detail;
using mps2::LoadedField;

constexpr int32_t kWidth = 48, kHeight = 37, kRows = 8;
constexpr uint32_t kStride = 2 * kWidth;
constexpr Orbit kOrbit = {degrees(30), degrees(20), radii(3)};
constexpr Quaternion kTurn = {9000, -4000, 11000, 2500};
using TestScreen = Screen<kWidth, kHeight, kRows>;

#ifdef LUMI_C_TEXEL
constexpr bool kDrawsSurfaces = false;
constexpr uint8_t kMode = 16, kOtherMode = 4;
using Drawing = ChordDrawing<LUMI_C_TEXEL>;
#else
constexpr bool kDrawsSurfaces = true;
constexpr uint8_t kMode = LUMI_ANTIALIASED, kOtherMode = LUMI_ONE_SAMPLE;
using Drawing = SurfaceDrawing<98, 128>;
#endif

struct InCpp {
    static constexpr const char* kName = "C++: ";
    View<Drawing, TestScreen> view;

    ViewError open(const uint8_t* bytes, size_t size) { return view.open(bytes, size); }
    ViewError verify(const uint8_t* bytes, size_t size)
    {
        const ViewError error = view.open(bytes, size);
        return error == ViewError::none ? view.verify() : error;
    }
    ViewError look(const Orbit& orbit) { return view.look(orbit); }
    ViewError look(const Quaternion& turn, uint8_t mode)
    {
        const uint32_t fov_turns32 = fit_sphere(kWidth, kHeight, kOrbit.distance_q20);
        const Pose pose = held_pose(turn, kOrbit.distance_q20);
        return view.look(pose, fov_turns32, static_cast<decltype(view)::Mode>(mode));
    }
    ViewError draw(const Stripe& stripe) { return view.draw(stripe); }
    static const char* text(ViewError error) { return error_text(error); }
};

struct InC {
    static constexpr const char* kName = "C: ";
    static constexpr lumi_screen kScreen = {kWidth, kHeight, kRows, kMode};
    uint64_t memory[LUMI_MEMORY(98, 128, kWidth, kHeight, kRows) / 8 + 1];
    lumi_view* view;

    ViewError open_in(void* at, size_t memory_bytes, const uint8_t* bytes, size_t size)
    {
        return static_cast<ViewError>(lumi_open(at, memory_bytes, bytes, size, kScreen, &view));
    }
    ViewError open(const uint8_t* bytes, size_t size) { return open_in(memory, sizeof memory, bytes, size); }
    static ViewError verify(const uint8_t* bytes, size_t size)
    {
        return static_cast<ViewError>(lumi_verify(bytes, size));
    }
    ViewError look(const Orbit& o)
    {
        const lumi_orbit orbit = {o.azimuth_turns32, o.elevation_turns32, o.distance_q20, o.fov_turns32, o.zoom_q16};
        return static_cast<ViewError>(lumi_look(view, orbit));
    }
    ViewError look(const Quaternion& turn, uint8_t mode)
    {
        const lumi_orbit orbit = {0, 0, kOrbit.distance_q20, LUMI_FIT_SPHERE, LUMI_NO_ZOOM};
        const lumi_pose pose = lumi_held_pose({turn.w, turn.x, turn.y, turn.z}, orbit.distance_q20);
        return static_cast<ViewError>(lumi_look_pose(view, pose, lumi_fov_of(view, orbit), mode));
    }
    ViewError draw(const Stripe& s)
    {
        const lumi_stripe stripe = {s.pixels, s.x_px, s.y_px, s.width_px, s.height_px, s.stride_bytes};
        return static_cast<ViewError>(lumi_draw(view, stripe));
    }
    static const char* text(ViewError error) { return lumi_error_text(static_cast<lumi_error>(error)); }
};

InCpp in_cpp;
InC in_c;
alignas(4) uint8_t frame[kStride * kHeight];
uint32_t failures;

void report(const char* language, const char* what, const char* text, bool is_right)
{
    for (const char* part : {is_right ? "passed: " : "FAILED: ", language, what, ": ", text, "\n"}) mps2::write(part);
    failures += is_right ? 0 : 1;
}

template <class Api>
void expect(const char* what, ViewError found, ViewError expected)
{
    const char* const text = Api::text(found);
    report(Api::kName, what, text, found == expected && std::strcmp(text, "unknown error") != 0);
}

// The whole frame by stripes, as one looks at it; 0 if that or a stripe was refused.
template <class Api, class... Look>
uint32_t drawn_frame(Api& api, const Look&... look)
{
    if (api.look(look...) != ViewError::none) return 0;
    std::memset(frame, 0xA5, sizeof frame);
    for (int32_t y = 0; y < kHeight; y += kRows) {
        const int32_t rows = kHeight - y < kRows ? kHeight - y : kRows;
        uint8_t* const pixels = frame + static_cast<uint32_t>(y) * kStride;
        if (api.draw({pixels, 0, y, kWidth, rows, kStride}) != ViewError::none) return 0;
    }
    return crc32(0, frame, sizeof frame);
}

template <class Api>
void try_wrong_addresses(Api& api, test::GuardedMemory& flash, const LoadedField& field)
{
    constexpr uint32_t kErased = 4096;
    uint8_t* const erased = flash.end() - kErased;
    std::memset(erased, 0xFF, kErased);
    expect<Api>("wrong section, erased flash", api.open(erased, field.size), view_error(FieldError::bad_magic));
    std::memset(erased, 0, kErased);
    expect<Api>("wrong section, zeros", api.open(erased, field.size), view_error(FieldError::bad_magic));
    expect<Api>("wrong section, no address", api.open(nullptr, field.size), ViewError::bad_argument);
    const uint8_t* const whole = flash.put(field.bytes, field.size);
    expect<Api>("wrong section, a section too late", api.open(whole + 8, field.size - 8),
                view_error(FieldError::bad_magic));
}

// Bytes that were not flashed are not there at all: to read one faults.
template <class Api>
void try_cut_off(Api& api, test::GuardedMemory& flash, const LoadedField& field)
{
    ViewError error = ViewError::none;
    bool is_refused = true;
    for (size_t count = 0; count < field.size; count += count < 512 ? 1 : 997) {
        error = api.open(flash.put(field.bytes, count), count);
        is_refused = is_refused && error == view_error(FieldError::truncated);
    }
    report(Api::kName, "truncated flash, every length", Api::text(error), is_refused);
}

// Bytes that were not flashed read as ones. Opened or not, nothing beside the field is read; to verify tells.
template <class Api>
void try_unwritten(Api& api, test::GuardedMemory& flash, const LoadedField& field)
{
    uint32_t opened = 0, told = 0, tried = 0;
    for (size_t count = 100; count < field.size; count += field.size / 50, ++tried) {
        uint8_t* const bytes = flash.put(field.bytes, field.size);
        std::memset(bytes + count, 0xFF, field.size - count);
        if (api.open(bytes, field.size) == ViewError::none && drawn_frame(api, kOrbit) != 0) ++opened;
        if (api.verify(bytes, field.size) != ViewError::none) ++told;
    }
    report(Api::kName, "truncated flash that reads as ones", "draws within the field, or is refused", opened < tried);
    report(Api::kName, "truncated flash that reads as ones", "is told by verify", told == tried);
}

template <class Api>
void try_unaligned(Api& api, test::GuardedMemory& flash, const LoadedField& field, uint32_t whole_crc)
{
    uint8_t* const odd = flash.end() - field.size - 1;
    std::memcpy(odd, field.bytes, field.size);
    const ViewError error = api.open(odd, field.size);
    expect<Api>("unaligned field", error, kDrawsSurfaces ? ViewError::none : ViewError::unaligned_field);
    if (kDrawsSurfaces)
        report(Api::kName, "unaligned field", "draws the same bits", drawn_frame(api, kOrbit) == whole_crc);
}

template <class Api>
void try_stripes(Api& api, const LoadedField& field)
{
    const bool is_ready = api.open(field.bytes, field.size) == ViewError::none && api.look(kOrbit) == ViewError::none;
    report(Api::kName, "a field as it should be", "opens", is_ready);
    expect<Api>("unaligned pixels", api.draw({frame + 1, 0, 0, kWidth, kRows, kStride}), ViewError::unaligned_pixels);
    expect<Api>("buffer too small, no memory", api.draw({nullptr, 0, 0, kWidth, kRows, kStride}), ViewError::no_pixels);
    expect<Api>("buffer too small, short rows", api.draw({frame, 0, 0, kWidth, kRows, kStride - 2}),
                ViewError::short_stride);
    if (kDrawsSurfaces) {
        expect<Api>("buffer too small for so many rows", api.draw({frame, 0, 0, kWidth, kRows + 1, kStride}),
                    ViewError::stripe_too_large);
    }
    for (const Stripe& stripe :
         {Stripe{frame, 0, kHeight, kWidth, kRows, kStride}, Stripe{frame, -kWidth, INT32_MIN, kWidth, kRows, kStride}})
        expect<Api>("stripe beside the image", api.draw(stripe), ViewError::none);
    expect<Api>("stripe too far", api.draw({frame, INT32_MAX, 0, kWidth, kRows, kStride}), ViewError::stripe_too_far);
}

// CRCs of frames of two eyes and modes.
struct Crcs {
    uint32_t orbit, held;

    bool operator==(const Crcs& other) const { return orbit == other.orbit && held == other.held; }
};

template <class Api>
Crcs try_all(Api& api, test::GuardedMemory& flash, const LoadedField& field, const LoadedField& other)
{
    expect<Api>("wrong field", api.open(other.bytes, other.size), ViewError::other_renderer);
    try_wrong_addresses(api, flash, field);
    try_cut_off(api, flash, field);
    try_unwritten(api, flash, field);
    try_stripes(api, field);
    const Crcs crcs = {drawn_frame(api, kOrbit), drawn_frame(api, kTurn, kOtherMode)};
    try_unaligned(api, flash, field, crcs.orbit);
    return crcs;
}

// Memory of the caller is a matter of C; in C++ the view has it, and knows for which fields.
void try_memory(const LoadedField& field)
{
    const size_t enough = lumi_memory_size(field.bytes, field.size, InC::kScreen);
    uint8_t* const memory = reinterpret_cast<uint8_t*>(in_c.memory);
    expect<InC>("buffer too small for the view", in_c.open_in(memory, enough - 1, field.bytes, field.size),
                ViewError::memory_too_small);
    expect<InC>("unaligned memory", in_c.open_in(memory + 4, enough, field.bytes, field.size),
                ViewError::unaligned_memory);
    if (kDrawsSurfaces) {
        static View<SurfaceDrawing<97, 128>, TestScreen> small;
        expect<InCpp>("buffer too small for the view", small.open(field.bytes, field.size), ViewError::field_too_large);
    }
}

}  // namespace

int main(int count, char** arguments)
{
    test::GuardedMemory flash;
    if (count == 2 && std::strcmp(arguments[1], "wild") == 0) return *const_cast<volatile uint8_t*>(flash.end());
    const LoadedField field = mps2::loaded_field(0), other = mps2::loaded_field(test::GuardedMemory::kBytes);
    const Crcs by_cpp = try_all(in_cpp, flash, field, other), by_c = try_all(in_c, flash, field, other);
    report("", "after all that", "C and C++ draw the same bits",
           by_cpp == by_c && by_c.orbit != 0 && by_c.held != 0 && by_c.orbit != by_c.held);
    try_memory(field);
    return failures == 0 ? 0 : 1;
}
