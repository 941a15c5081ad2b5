// SPDX-License-Identifier: MIT
#include "commands/bake_job.h"

#include <filesystem>

#include "terminal/failure.h"

namespace lumi::tools
{

namespace
{

void bake(const baker::Scene& scene, const BakeJob& job, const baker::ProgressCallback& progress, BakeOutcome& outcome)
{
    if (job.surface && job.shard)
        baker::bake_surface_shard(scene, *job.surface, *job.shard, job.target, progress, job.earlier);
    else if (job.surface)
        outcome.surface = baker::bake_surface(scene, *job.surface, job.target, progress, job.earlier, job.draft.get());
    else if (job.shard)
        baker::bake_shard(scene, job.settings, *job.shard, job.target, progress, job.earlier);
    else
        baker::bake_field(scene, job.settings, job.target, progress, job.earlier);
}

double chord_rays(const BakeJob& job)
{
    const double rows = baker::shard_rows(job.settings, job.shard.value_or(baker::Shard{}));
    return rows * job.settings.directions * job.settings.samples;
}

}  // namespace

void throw_interrupted(const std::string& output)
{
    const std::filesystem::path part = output + ".part", stages = baker::kept_stages(output);
    for (const std::filesystem::path& kept : {part, stages})
        if (!output.empty() && std::filesystem::exists(kept))
            throw Interrupted(kept.string() + " keeps what is done; the same command goes on from there");
    throw Interrupted();
}

BakeOutcome run_job(const baker::Scene& scene, const BakeJob& job, const baker::ProgressCallback& progress)
{
    BakeOutcome outcome;
    const double rays_of_texels = job.surface ? 0 : chord_rays(job);  // what may fail comes before the field is written
    const auto note = [&](const baker::Progress& report) {
        outcome.last = report;
        return progress(report);
    };
    try {
        bake(scene, job, note, outcome);
    } catch (const baker::Cancelled&) {
        throw_interrupted(job.target);
    }
    outcome.rays = outcome.surface ? static_cast<double>(outcome.surface->paths)
                   : job.surface   ? static_cast<double>(outcome.last.rays_total)
                                   : rays_of_texels;
    return outcome;
}

}  // namespace lumi::tools
