// SPDX-License-Identifier: MIT
#include "bench/surface_reads.h"

#include <algorithm>

#include "draw/draw_surface.h"

namespace lumi::bench
{
namespace
{

constexpr uint32_t kNothing = UINT32_MAX;

// Levels of a picture whose texels are grey levels of their own.
tools::Picture levels(SurfaceField field, const std::vector<uint8_t>& texels, const tools::Eye& eye)
{
    std::vector<uint8_t> grey(3 * detail::format::kPaletteEntries);
    for (size_t k = 0; k < grey.size(); ++k) grey[k] = static_cast<uint8_t>(k / 3);
    field.texels = texels.data();
    field.palette = grey.data();
    field.lit_count = 0;
    return tools::draw_surface(field, eye, {SurfaceMode::one_sample, tools::DisplayFormat::rgb888, {0, 0, 0}});
}

// Each sample's texel, or kNothing: pictures of the texels' numbers, 7 bits at a time beside a bit that is set.
std::vector<uint32_t> texels_seen(const SurfaceField& field, const tools::Eye& eye)
{
    constexpr uint32_t kBits = 7, kSet = 1u << kBits;
    std::vector<uint32_t> seen;
    std::vector<uint8_t> texels(field.texel_bytes);
    for (uint32_t shift = 0; shift < 3 * kBits; shift += kBits) {
        for (uint32_t k = 0; k < field.texel_bytes; ++k)
            texels[k] = static_cast<uint8_t>(kSet | ((k >> shift) & (kSet - 1)));
        const tools::Picture picture = levels(field, texels, eye);
        seen.resize(picture.rgb.size() / 3);
        for (size_t k = 0; k < seen.size(); ++k) {
            const uint32_t level = picture.rgb[3 * k];
            seen[k] = level < kSet ? kNothing : seen[k] | (level & (kSet - 1)) << shift;
        }
    }
    return seen;
}

// Samples of 2×2 lie as the only ones of a picture twice as wide do.
tools::Eye eye_of_samples(const View& view, SurfaceMode mode)
{
    tools::Eye eye = {view_pose(view), view_image(view), {}};
    const int32_t side = mode == SurfaceMode::two_by_two ? 2 : 1;
    eye.image.width_px *= side;
    eye.image.height_px *= side;
    return eye;
}

class Reader
{
public:
    explicit Reader(const tools::FieldFile& file) : file_(file.bytes()), field_(file.surface())
    {
        for (uint32_t k = 0; k < field_.patch_count; ++k)
            begins_.push_back({detail::surface_patch(field_, k).texels, k});
        std::sort(begins_.begin(), begins_.end());
    }

    void prepare()
    {
        for (uint32_t k = 0; k < field_.vertex_count; ++k)
            read(field_.vertices + k * detail::format::kVertexBytes, detail::format::kVertexBytes);
        std::vector<bool> is_lit(field_.vertex_count);
        for (uint32_t k = 0; k < field_.patch_count; ++k) {
            read_patch(k);
            for (const uint32_t corner : detail::surface_patch(field_, k).corner) {
                if (corner >= field_.viewed_count || is_lit[corner]) continue;
                is_lit[corner] = true;
                const uint32_t bytes = detail::format::view_bytes(field_.code_bits);
                read(field_.views + corner * bytes, bytes);
            }
        }
    }

    // One patch after the other: rectangles lie in the order of patches.
    void stripe(std::vector<uint32_t> texels)
    {
        std::stable_sort(texels.begin(), texels.end(),
                         [&](uint32_t a, uint32_t b) { return rectangle_of(a) < rectangle_of(b); });
        size_t last = begins_.size();
        for (const uint32_t texel : texels) {
            const size_t rectangle = rectangle_of(texel);
            if (rectangle != last) read_patch(begins_[rectangle].second);
            last = rectangle;
            read(field_.texels + texel, 1);
        }
    }

    std::vector<Read> take() { return std::move(reads_); }

private:
    void read(const uint8_t* at, uint32_t bytes) { reads_.push_back({static_cast<uint32_t>(at - file_), bytes}); }
    void read_patch(uint32_t k) { read(field_.patches + k * detail::format::kPatchBytes, detail::format::kPatchBytes); }

    size_t rectangle_of(uint32_t texel) const
    {
        const auto after = std::upper_bound(begins_.begin(), begins_.end(), std::pair(texel, kNothing));
        return static_cast<size_t>(after - begins_.begin()) - (after == begins_.begin() ? 0 : 1);
    }

    const uint8_t* file_;
    const SurfaceField& field_;
    std::vector<std::pair<uint32_t, uint32_t>> begins_;  // each rectangle's first texel, and its patch
    std::vector<Read> reads_;
};

}  // namespace

std::vector<Read> reads_of(const tools::FieldFile& file, const View& view, SurfaceMode mode)
{
    const tools::Eye eye = eye_of_samples(view, mode);
    const std::vector<uint32_t> seen = texels_seen(file.surface(), eye);
    Reader reader(file);
    reader.prepare();
    const auto stripe = static_cast<std::ptrdiff_t>(seen.size()) / (kSidePx / kSurfaceStripeHeight);
    for (auto at = seen.begin(); at != seen.end(); at += stripe) {
        std::vector<uint32_t> texels(at, at + stripe);
        texels.erase(std::remove(texels.begin(), texels.end(), kNothing), texels.end());
        reader.stripe(std::move(texels));
    }
    return reader.take();
}

}  // namespace lumi::bench
