// SPDX-License-Identifier: MIT
#include <chrono>
#include <filesystem>
#include <thread>

#include "baking/measurements.h"
#include "baking/texels.h"
#include "util/job.h"

namespace lumi::baker::bench
{
namespace
{

// Wall seconds for rows that `threads` threads share as a bake does.
double seconds_with(const Scene& scene, const Rows& rows, unsigned threads)
{
    const TexelTracer tracer(scene.data(), rows.settings);
    const ProgressCallback none;
    Job job(rows.paths(), threads, none);
    const auto start = std::chrono::steady_clock::now();
    job.run(rows.count, [&](uint32_t row) {
        const OriginDisc disc = tracer.disc(rows.origin(row));
        for (uint32_t j = 0; j < rows.settings.directions; ++j)
            job.add_rays(tracer.estimate(disc, rows.origin(row), j).samples());
    });
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Json thread_rates(const char* scene_file, unsigned count)
{
    const Scene scene = load(scene_file);
    Rows rows = {{}, count};
    rows.settings.origins = rows.settings.directions = 1448;
    const std::string name = std::filesystem::path(scene_file).filename();
    Json result = Json::array();
    for (unsigned threads = 1; threads <= std::max(std::thread::hardware_concurrency(), 1u); threads *= 2) {
        const double pace = static_cast<double>(rows.paths()) / seconds_with(scene, rows, threads);
        result.push_back({{"scene", name}, {"threads", threads}, {"paths_per_s", pace}});
    }
    return result;
}

}  // namespace lumi::baker::bench
