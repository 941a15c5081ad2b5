// SPDX-License-Identifier: MIT
#include "lumi/baker/bake.h"

#include "field_rays.h"
#include "field_writer.h"
#include "job.h"
#include "texel_encoder.h"

namespace lumi::baker
{
namespace
{

// Texels that the palette is fitted to: some hundred for each entry; traced twice, at most a few percent of a bake.
constexpr uint64_t kPaletteSamples = 32768;
constexpr uint32_t kPaletteTasks = 64;
constexpr uint64_t kPaletteSeedOffset = 0x50414C54;  // its choice of texels is independent of their paths

void require(bool good, const std::string& message)
{
    if (!good) {
        throw BakeError(message);
    }
}

std::string lattice_range(const char* name)
{
    return std::string("the number of ") + name + " must lie in 1 to " + std::to_string(kMaxLatticeSize);
}

FieldLayout checked_layout(const BakeSettings& s)
{
    require(s.origins >= 1 && s.origins <= kMaxLatticeSize, lattice_range("origins"));
    require(s.directions >= 1 && s.directions <= kMaxLatticeSize, lattice_range("directions"));
    require(s.used_origins <= s.origins, "the cap holds " + std::to_string(s.used_origins) + " origins of " +
                                             std::to_string(s.origins) + "; choose at most all of them, or 0 for all");
    require(s.samples >= 1, "the number of samples must be at least 1");
    require(static_cast<uint32_t>(s.texel) < format::kTexelFormats, "there is no such texel format");
    const FieldLayout layout = {s.origins, s.directions, s.used_origins ? s.used_origins : s.origins, s.texel, {}, 1};
    require(file_bytes(layout) <= UINT32_MAX, "the field would have " + std::to_string(file_bytes(layout)) +
                                                  " bytes, and a field file holds less than 4 GiB; choose fewer "
                                                  "origins or directions, a smaller cap or a smaller texel format");
    return layout;
}

class Baker
{
public:
    Baker(const Scene& scene, const BakeSettings& settings, const ProgressCallback& progress)
        : settings_(settings),
          layout_(checked_layout(settings)),
          rays_(settings.origins, settings.directions),
          tone_(scene.data().tone),
          tracer_(scene.data()),
          job_(rays_total(), settings.threads, progress)
    {
        layout_.centre = scene.centre();
        layout_.radius = scene.radius();
    }

    void bake_into(PartFile& out)
    {
        if (layout_.texel == format::TexelFormat::palette8) {
            fit();
        }
        texels_.resize(layout_.texel_bytes());
        job_.run(layout_.used_origins, [this](uint32_t i) { bake_row(i); });
        write_field(layout_, texels_, palette_, out);
        job_.finish();
    }

private:
    uint64_t texel_count() const { return uint64_t{layout_.used_origins} * layout_.directions; }

    uint64_t palette_samples() const
    {
        return layout_.texel == format::TexelFormat::palette8 ? std::min(kPaletteSamples, texel_count()) : 0;
    }

    uint64_t rays_total() const { return (texel_count() + palette_samples()) * settings_.samples; }

    Estimate estimate(const OriginDisc& disc, uint32_t i, uint32_t j)
    {
        Estimate result(tone_);
        const Vec3 target = rays_.direction_point(j);
        Sampler sampler(settings_.seed, i, j);
        for (uint32_t s = 0; s < settings_.samples; ++s) {
            sampler.start(s);
            const std::optional<Ray> ray = FieldRays::ray(disc.at(sampler.next_2d()), target);
            result.add(ray ? tracer_.trace(*ray, sampler) : PathResult{});
        }
        job_.add_rays(settings_.samples);
        return result;
    }

    void bake_row(uint32_t i)
    {
        uint8_t* row = texels_.data() + size_t{layout_.row_stride()} * i;
        const OriginDisc disc = rays_.disc(i);
        for (uint32_t j = 0; j < layout_.directions && !job_.stopping(); ++j) {
            encode_texel(layout_.texel, palette_, estimate(disc, i, j), row, j);
        }
    }

    // Texel k of the palette's samples: all of a small field, a random choice from a large one.
    uint64_t palette_texel(uint64_t k) const
    {
        if (palette_samples() == texel_count()) {
            return k;
        }
        Sampler sampler(settings_.seed + kPaletteSeedOffset, static_cast<uint32_t>(k), 0);
        const Vec2 u = sampler.next_2d();
        const uint64_t i = static_cast<uint64_t>(static_cast<double>(u.x) * layout_.used_origins);
        const uint64_t j = static_cast<uint64_t>(static_cast<double>(u.y) * layout_.directions);
        return i * layout_.directions + j;
    }

    void fit()
    {
        std::vector<Rgba8> samples(palette_samples());
        job_.run(kPaletteTasks, [&](uint32_t task) {
            for (uint64_t k = task; k < samples.size() && !job_.stopping(); k += kPaletteTasks) {
                const uint64_t texel = palette_texel(k);
                const uint32_t i = static_cast<uint32_t>(texel / layout_.directions);
                const uint32_t j = static_cast<uint32_t>(texel % layout_.directions);
                samples[k] = estimate(rays_.disc(i), i, j).covered_colour();
            }
        });
        palette_ = fit_palette(samples);
    }

    BakeSettings settings_;
    FieldLayout layout_;
    FieldRays rays_;
    ToneCurve tone_;
    PathTracer tracer_;
    Job job_;
    Palette palette_{};
    std::vector<uint8_t> texels_;
};

}  // namespace

uint64_t field_file_bytes(const BakeSettings& settings)
{
    return file_bytes(checked_layout(settings));
}

void bake_field(const Scene& scene, const BakeSettings& settings, const std::filesystem::path& output,
                const ProgressCallback& progress)
{
    checked_layout(settings);
    PartFile out(output);
    Baker(scene, settings, progress).bake_into(out);
    out.commit();
}

}  // namespace lumi::baker
