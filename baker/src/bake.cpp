// SPDX-License-Identifier: MIT
#include "lumi/baker/bake.h"

#include "checkpoint.h"
#include "job.h"
#include "texel_encoder.h"
#include "texel_tracer.h"

namespace lumi::baker
{
namespace
{

namespace fs = std::filesystem;

// Texels that the palette is fitted to: some hundred for each entry; traced twice, at most a few percent of a bake.
constexpr uint64_t kPaletteSamples = 32768;
constexpr uint32_t kPaletteTasks = 64;
constexpr uint64_t kPaletteSeedOffset = 0x50414C54;  // its choice of texels is independent of their paths

// Traces the rows that a checkpoint lacks.
class Baker
{
public:
    Baker(const Scene& scene, const BakeSettings& settings, Checkpoint& checkpoint, const ProgressCallback& progress)
        : settings_(settings),
          checkpoint_(checkpoint),
          layout_(checkpoint.rows().layout()),
          tracer_(scene.data(), settings),
          missing_(checkpoint.missing_slots()),
          has_palette_(checkpoint.rows().read_palette(palette_)),
          job_(rays_total(), settings.threads, progress, rays_done())
    {
    }

    void bake()
    {
        if (!has_palette_) {
            fit();
            checkpoint_.rows().write_palette(palette_);
        }
        job_.run(static_cast<uint32_t>(missing_.size()), [this](uint32_t k) { bake_slot(missing_[k]); });
        checkpoint_.sync();
        job_.finish();
    }

    // The rows, read back and checked, as a field.
    void write(const fs::path& output)
    {
        NewFile out(output);
        write_field(
            layout_, [this](uint32_t i, std::vector<uint8_t>& row) { read_back(i, row); }, palette_, out);
        out.commit();
    }

private:
    uint64_t texel_count() const { return uint64_t{layout_.used_origins} * layout_.directions; }

    uint64_t palette_samples() const
    {
        return layout_.texel == format::TexelFormat::palette8 ? std::min(kPaletteSamples, texel_count()) : 0;
    }

    uint64_t rays_of_rows(uint64_t rows) const { return rows * layout_.directions * settings_.samples; }

    uint64_t rays_total() const
    {
        return rays_of_rows(checkpoint_.rows().slot_count()) + palette_samples() * settings_.samples;
    }

    uint64_t rays_done() const
    {
        return rays_of_rows(checkpoint_.rows().slot_count() - missing_.size()) +
               (has_palette_ ? palette_samples() * settings_.samples : 0);
    }

    Estimate estimate(const OriginDisc& disc, uint32_t i, uint32_t j)
    {
        const Estimate result = tracer_.estimate(disc, i, j);
        job_.add_rays(settings_.samples, settings_.samples - result.samples());
        return result;
    }

    void bake_slot(uint32_t slot)
    {
        std::vector<uint8_t> row(layout_.row_stride());
        const uint32_t i = checkpoint_.rows().row_of(slot);
        const OriginDisc disc = tracer_.disc(i);
        for (uint32_t j = 0; j < layout_.directions; ++j) {
            if (job_.stopping()) {
                return;
            }
            encode_texel(layout_.texel, palette_, estimate(disc, i, j), row.data(), j);
        }
        checkpoint_.store(slot, row);
    }

    void read_back(uint32_t slot, std::vector<uint8_t>& row) const
    {
        const RowFile& rows = checkpoint_.rows();
        if (!rows.read_row(slot, row)) {
            throw BakeError(rows.path().string() +
                            ": a row changed after it was written; check the disk, then bake again, which traces that "
                            "row only");
        }
    }

    // Texel k of the palette's samples: all of a small field, a random choice from a large one. The same for every
    // shard.
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
                samples[k] = estimate(tracer_.disc(i), i, j).covered_colour();
            }
        });
        palette_ = fit_palette(samples);
    }

    const BakeSettings settings_;
    Checkpoint& checkpoint_;
    const FieldLayout layout_;
    const TexelTracer tracer_;
    Palette palette_{};
    const std::vector<uint32_t> missing_;
    const bool has_palette_;
    Job job_;
};

fs::path checkpoint_of(const fs::path& output)
{
    std::error_code ignored;
    if (fs::is_directory(output, ignored)) {
        throw BakeError(output.string() + ": this is a folder; name a file in it");
    }
    fs::path path = output;
    path += ".part";
    return path;
}

enum class Finished : uint8_t { none, complete, damaged };

// Whether `output` is a shard of this very bake already.
Finished find_finished(const fs::path& output, const BakeIdentity& identity)
{
    std::error_code ignored;
    if (!fs::is_regular_file(output, ignored)) {
        return Finished::none;
    }
    try {
        const RowFile rows(std::make_unique<PosixFile>(output, PosixFile::Mode::read));
        if (!difference(rows.identity(), identity).empty() || rows.identity().shard.index != identity.shard.index) {
            return Finished::none;
        }
        return missing_slots(rows).empty() && rows.has_intact_palette() ? Finished::complete : Finished::damaged;
    } catch (const BakeError&) {
        return Finished::none;  // anything else gets replaced, as any earlier output
    }
}

}  // namespace

uint64_t field_file_bytes(const BakeSettings& settings)
{
    return file_bytes(checked_layout(settings));
}

uint32_t shard_rows(const BakeSettings& settings, const Shard& shard)
{
    check_shard(shard);
    return ShardRows(checked_layout(settings).used_origins, shard).size();
}

void bake_field(const Scene& scene, const BakeSettings& settings, const fs::path& output,
                const ProgressCallback& progress, Earlier earlier)
{
    const BakeIdentity identity = identity_of(scene, settings, {});
    Checkpoint checkpoint(checkpoint_of(output), identity, earlier);
    Baker baker(scene, settings, checkpoint, progress);
    baker.bake();
    baker.write(output);
    checkpoint.remove();
}

void bake_shard(const Scene& scene, const BakeSettings& settings, const Shard& shard, const fs::path& output,
                const ProgressCallback& progress, Earlier earlier)
{
    const BakeIdentity identity = identity_of(scene, settings, shard);
    const fs::path part = checkpoint_of(output);
    if (earlier == Earlier::resume) {
        const Finished finished = find_finished(output, identity);
        if (finished == Finished::complete) {
            return;
        }
        std::error_code ignored;
        if (finished == Finished::damaged && !fs::exists(part, ignored)) {
            fs::rename(output, part, ignored);
        }
    }
    Checkpoint checkpoint(part, identity, earlier);
    Baker baker(scene, settings, checkpoint, progress);
    baker.bake();
    checkpoint.rename_to(output);
}

}  // namespace lumi::baker
