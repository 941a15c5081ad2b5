// SPDX-License-Identifier: MIT
// Fuzz target: a field from a stranger, opened and drawn by every renderer. The last bytes of an input choose camera,
// stripe and renderer, the others are the file, whose checksums are made right.
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include "lumi/chord/render_spans_paper.h"
#include "lumi/detail/crc32.h"
#include "lumi/surface/render.h"

namespace
{

using namespace lumi;

constexpr size_t kControlBytes = 48;
constexpr uint32_t kSmallSide = 12, kLargeSide = 48;  // most pictures are small: more of them a second

uint32_t load32(const uint8_t* p)
{
    return static_cast<uint32_t>(p[0]) | static_cast<uint32_t>(p[1]) << 8 | static_cast<uint32_t>(p[2]) << 16 |
           static_cast<uint32_t>(p[3]) << 24;
}

void store32(uint8_t* p, uint32_t v)
{
    for (int k = 0; k < 4; ++k) p[k] = static_cast<uint8_t>(v >> (8 * k));
}

// Length, table and header as a writer would have made them; sections stay as they are.
void reseal(std::vector<uint8_t>& file)
{
    namespace at = format::header;
    if (file.size() < format::kHeaderBytes) return;
    std::memcpy(file.data(), format::kMagic, sizeof format::kMagic);
    store32(file.data() + at::kFileBytesAt, static_cast<uint32_t>(file.size()));
    const size_t sections = file[at::kSectionCountAt] | static_cast<size_t>(file[at::kSectionCountAt + 1]) << 8;
    const size_t table = sections * format::kEntryBytes;
    if (format::kHeaderBytes + table <= file.size())
        store32(file.data() + at::kTableCrcAt, crc32(0, file.data() + format::kHeaderBytes, table));
    store32(file.data() + at::kHeaderCrcAt, crc32(0, file.data(), at::kHeaderCrcAt));
}

// Reads numbers from the input's end.
class Controls
{
public:
    explicit Controls(const uint8_t* bytes) : at_(bytes) {}

    uint32_t word()
    {
        const uint32_t v = load32(at_);
        at_ += 4;
        return v;
    }
    int32_t number() { return static_cast<int32_t>(word()); }
    int32_t side()
    {
        const uint32_t v = word();
        return 1 + static_cast<int32_t>(v % ((v >> 16 & 15) != 0 ? kSmallSide : kLargeSide));
    }

private:
    const uint8_t* at_;
};

// How many inputs got as far as a picture; said at the end.
struct Drawn {
    uint64_t chords = 0, surfaces = 0;
    ~Drawn()
    {
        std::fprintf(stderr, "drawn: %llu chord fields, %llu surface fields\n", static_cast<unsigned long long>(chords),
                     static_cast<unsigned long long>(surfaces));
    }
} drawn;

struct Scene {
    Pose pose;
    Image image;
    int32_t x, y, width, height;
    uint32_t choice;
};

Scene scene_of(Controls c)
{
    Scene s{};
    const uint32_t azimuth = c.word(), distance = c.word();
    const int32_t elevation = static_cast<int32_t>(c.word() >> 1) - (1 << 30);
    // Mostly near by; far away now and then.
    const int32_t reach = (distance & 7) != 0 ? kOneQ20 / 2 : kMaxEyeDistanceQ20 - kOneQ20;
    s.pose = orbit(azimuth, elevation, kOneQ20 + static_cast<int32_t>((distance >> 3) % static_cast<uint32_t>(reach)));
    s.image = {c.side(), c.side(), kMinFovTurns32 + c.word() % (kMaxFovTurns32 - kMinFovTurns32), 0, 0};
    s.image.shift_x_q8 = c.number() % (256 * s.image.width_px);
    // Somewhere around the image, or anywhere at all.
    const uint32_t where = c.word();
    s.x = (where & 3) != 0 ? static_cast<int32_t>((where >> 2) % 128) - 64 : static_cast<int32_t>(where);
    s.y = (where & 12) != 0 ? static_cast<int32_t>((where >> 9) % 128) - 64 : static_cast<int32_t>(~where);
    s.width = c.side();
    s.height = c.side();
    s.choice = c.word();
    return s;
}

// A stripe in memory of its very size.
struct Canvas {
    explicit Canvas(const Scene& s, uint32_t pixel_bytes)
        : stride(static_cast<uint32_t>(s.width) * pixel_bytes),
          pixels(new uint8_t[stride * static_cast<size_t>(s.height)]())
    {
        stripe = {pixels.get(), s.x, s.y, s.width, s.height, stride};
    }

    uint32_t stride;
    std::unique_ptr<uint8_t[]> pixels;
    Stripe stripe{};
};

template <class Reconstruction, class Texel>
void draw_chord(const Field& field, const Camera& camera, const Scene& s)
{
    Canvas canvas(s, PixelRgb888::kBytes);
    const OverColour background{{1, 2, 3}};
    if ((s.choice & 8) != 0) {
        static_cast<void>(render<Reconstruction, Texel, PixelRgb888>(field, camera, background, canvas.stripe));
    } else {
        static_cast<void>(render_spans<Reconstruction, Texel, PixelRgb888>(field, camera, background, canvas.stripe,
                                                                           1 << (s.choice >> 4 & 7)));
    }
}

template <class Texel>
void draw_chord(const Field& field, const Camera& camera, const Scene& s)
{
    switch (s.choice & 7) {
        case 0:
            return draw_chord<Nearest, Texel>(field, camera, s);
        case 1:
            return draw_chord<Dither, Texel>(field, camera, s);
        case 2:
            return draw_chord<Paper<5>, Texel>(field, camera, s);
        case 3:
            return draw_chord<NearestVoronoi, Texel>(field, camera, s);
        default:
            return draw_chord<Linear, Texel>(field, camera, s);
    }
}

void draw_chord(const Field& field, const Scene& s)
{
    Camera camera;
    if (make_camera(s.pose, s.image, camera) != CameraError::none) return;
    if ((s.choice & 0x100) != 0) camera = interlaced_half(camera, static_cast<int32_t>(s.choice >> 9 & 1));
    ++drawn.chords;
    with_texel(field.texel_format, [&](auto texel) { draw_chord<decltype(texel)>(field, camera, s); });
}

void draw_surface(const SurfaceField& field, const Scene& s)
{
    SurfaceCamera camera;
    if (make_surface_camera(s.pose, s.image, camera) != CameraError::none) return;
    ++drawn.surfaces;
    const auto mode = static_cast<SurfaceMode>(s.choice % 3);
    const uint32_t band_log2 = s.choice >> 4 & 7;
    const std::unique_ptr<SurfaceVertex[]> vertices(new SurfaceVertex[field.vertex_count]);
    const std::unique_ptr<uint16_t[]> links(new uint16_t[surface_links(field.patch_count)]);
    const std::unique_ptr<uint16_t[]> bands(new uint16_t[surface_bands(s.image.height_px, band_log2)]);
    SurfaceFrame frame;
    prepare_surface<PixelRgb565>(field, camera, mode, {vertices.get(), links.get(), bands.get(), band_log2}, frame);
    Canvas canvas(s, PixelRgb565::kBytes);
    const std::unique_ptr<uint32_t[]> samples(new uint32_t[(surface_stripe_bytes(s.width, s.height, mode) + 3) / 4]);
    render_surface<PixelRgb565>(frame, OverColour{{1, 2, 3}}, canvas.stripe, samples.get());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    if (size < kControlBytes) return 0;
    std::vector<uint8_t> file(data, data + size - kControlBytes);
    file.shrink_to_fit();
    reseal(file);
    const Scene scene = scene_of(Controls(data + size - kControlBytes));
    Field chord;
    if (open_field(file.data(), file.size(), chord) == FieldError::none) draw_chord(chord, scene);
    SurfaceField surface;
    if (open_surface(file.data(), file.size(), surface) == FieldError::none) draw_surface(surface, scene);
    static_cast<void>(verify_field(file.data(), file.size()));
    return 0;
}
