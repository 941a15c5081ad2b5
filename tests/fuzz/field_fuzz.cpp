// SPDX-License-Identifier: MIT
// Fuzz target: a field from a stranger, opened and drawn by every renderer. The last bytes of an input choose camera,
// stripe and renderer, the others are the file, whose checksums are made right.
#include <cstdint>
#include <cstring>
#include <vector>

#include "draw_field.h"
#include "lumi/detail/crc32.h"

namespace
{

using namespace lumi;
using namespace lumi::detail;
using fuzz::Scene;

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
    namespace at = detail::format::header;
    if (file.size() < detail::format::kHeaderBytes) return;
    std::memcpy(file.data(), detail::format::kMagic, sizeof detail::format::kMagic);
    store32(file.data() + at::kFileBytesAt, static_cast<uint32_t>(file.size()));
    const size_t sections = file[at::kSectionCountAt] | static_cast<size_t>(file[at::kSectionCountAt + 1]) << 8;
    const size_t table = sections * detail::format::kEntryBytes;
    if (detail::format::kHeaderBytes + table <= file.size())
        store32(file.data() + at::kTableCrcAt, crc32(0, file.data() + detail::format::kHeaderBytes, table));
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
    // Now and then as long as there is.
    int32_t image_side()
    {
        const bool is_longest = *at_ == 255;
        const int32_t v = side();
        return is_longest ? kMaxImageSide : v;
    }

private:
    const uint8_t* at_;
};

Scene scene_of(Controls c)
{
    Scene s{};
    const uint32_t azimuth = c.word(), distance = c.word();
    const int32_t elevation = static_cast<int32_t>(c.word() >> 1) - (1 << 30);
    // Mostly near by; far away now and then.
    const int32_t reach = (distance & 7) != 0 ? kOneQ20 / 2 : kMaxEyeDistanceQ20 - kOneQ20;
    s.pose = orbit(azimuth, elevation, kOneQ20 + static_cast<int32_t>((distance >> 3) % static_cast<uint32_t>(reach)));
    s.image = {c.image_side(), c.image_side(), kMinFovTurns32 + c.word() % (kMaxFovTurns32 - kMinFovTurns32), 0, 0};
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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    if (size < kControlBytes) return 0;
    std::vector<uint8_t> file(data, data + size - kControlBytes);
    file.shrink_to_fit();
    reseal(file);
    const Scene scene = scene_of(Controls(data + size - kControlBytes));
    fuzz::draw_field(file.data(), file.size(), scene);
    static_cast<void>(verify_field(file.data(), file.size()));
    return 0;
}
