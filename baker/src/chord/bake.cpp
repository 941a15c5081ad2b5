// SPDX-License-Identifier: MIT
#include "lumi/baker/chord.h"

#include "chord/field_writer.h"
#include "chord/texel_tracer.h"
#include "store/checkpoint.h"
#include "trace/path_tracer.h"
#include "util/job.h"

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
          rows_(checkpoint.blocks()),
          layout_(rows_.layout()),
          missing_(reserved(checkpoint, rows_)),
          tracer_(scene.data(), settings),
          has_palette_(rows_.read_palette(palette_)),
          job_(rays_total(), settings.threads, progress, rays_done())
    {
    }

    void bake()
    {
        if (!has_palette_) {
            fit();
            rows_.write_palette(palette_);
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
    // The missing slots of a checkpoint that now takes its whole size.
    static std::vector<uint32_t> reserved(Checkpoint& checkpoint, const RowFile& rows)
    {
        std::vector<uint32_t> missing = missing_slots(rows);
        checkpoint.reserve(rows.complete_bytes(), missing.size() == rows.slot_count());
        return missing;
    }

    uint64_t texel_count() const { return uint64_t{layout_.used_origins} * layout_.directions; }

    uint64_t palette_samples() const
    {
        return layout_.texel == TexelFormat::palette8 ? std::min(kPaletteSamples, texel_count()) : 0;
    }

    uint64_t rays_of_rows(uint64_t rows) const { return rows * layout_.directions * settings_.samples; }

    uint64_t rays_total() const { return rays_of_rows(rows_.slot_count()) + palette_samples() * settings_.samples; }

    uint64_t rays_done() const
    {
        return rays_of_rows(rows_.slot_count() - missing_.size()) +
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
        const uint32_t i = rows_.row_of(slot);
        const OriginDisc disc = tracer_.disc(i);
        for (uint32_t j = 0; j < layout_.directions; ++j) {
            if (job_.stopping()) return;
            encode_texel(layout_.texel, palette_, estimate(disc, i, j), row.data(), j);
        }
        rows_.write_row(slot, row);
        checkpoint_.sync_now_and_then();
    }

    void read_back(uint32_t slot, std::vector<uint8_t>& row) const
    {
        if (!rows_.read_row(slot, row)) {
            throw BakeError(rows_.path().string() +
                            ": a row changed after it was written; check the disk, then bake again, which traces that "
                            "row only");
        }
    }

    // Texel k of the palette's samples: all of a small field, a random choice from a large one. The same for every
    // shard.
    uint64_t palette_texel(uint64_t k) const
    {
        if (palette_samples() == texel_count()) return k;
        Sampler sampler(settings_.seed + kPaletteSeedOffset, static_cast<uint32_t>(k), 0);
        const Vec2 u = sampler.next_2d();
        const uint64_t i = static_cast<uint64_t>(static_cast<double>(u.x) * layout_.used_origins);
        const uint64_t j = static_cast<uint64_t>(static_cast<double>(u.y) * layout_.directions);
        return i * layout_.directions + j;
    }

    void fit()
    {
        std::vector<detail::Rgba8> samples(palette_samples());
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
    RowFile rows_;
    const FieldLayout layout_;
    const std::vector<uint32_t> missing_;
    const TexelTracer tracer_;
    Palette palette_{};
    const bool has_palette_;
    Job job_;
};

bool has_all_rows(BlockFile& file)
{
    const RowFile rows(file);
    return missing_slots(rows).empty() && rows.has_intact_palette();
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
    require_partial_coverage(scene.data(), settings.texel == TexelFormat::palette8);
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
    require_partial_coverage(scene.data(), settings.texel == TexelFormat::palette8);
    const BakeIdentity identity = identity_of(scene, settings, shard);
    if (earlier == Earlier::resume && is_finished_shard(output, identity, has_all_rows)) return;
    Checkpoint checkpoint(checkpoint_of(output), identity, earlier);
    Baker baker(scene, settings, checkpoint, progress);
    baker.bake();
    checkpoint.rename_to(output);
}

}  // namespace lumi::baker
