// SPDX-License-Identifier: MIT
#include "baking/measurements.h"

#include <unistd.h>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "chord/texel_tracer.h"
#include "scene/scene_data.h"
#include "util/job.h"

namespace lumi::baker::bench
{

namespace
{

// The benchmarks trace whole rows of a field, as a bake does, at origins all over the sphere.
struct Rows {
    BakeSettings settings;
    uint32_t count;  // how many rows

    uint64_t texels() const { return uint64_t{count} * settings.directions; }
    uint64_t paths() const { return texels() * settings.samples; }
    uint32_t origin(uint32_t row) const
    {
        return static_cast<uint32_t>((2 * uint64_t{row} + 1) * settings.origins / (2 * count));
    }
};

// The encoded colours of texels; none where most rays miss.
using Colours = std::vector<std::optional<Rgb8>>;

inline std::optional<Rgb8> colour_of(const Estimate& estimate)
{
    return estimate.mostly_covered() ? std::optional(estimate.colour()) : std::nullopt;
}

// Differences in steps of 255 over all channels of texels that both sides cover.
struct Difference {
    double rms = 0, mean = 0;
};

// Calls take(estimate) for every texel of the rows, on the calling thread.
template <class Take>
void trace_rows(const Scene& scene, const Rows& rows, const Take& take)
{
    const TexelTracer tracer(scene.data(), rows.settings);
    for (uint32_t row = 0; row < rows.count; ++row) {
        const uint32_t i = rows.origin(row);
        const OriginDisc disc = tracer.disc(i);
        for (uint32_t j = 0; j < rows.settings.directions; ++j) take(tracer.estimate(disc, i, j));
    }
}

Scene load(const char* file)
{
    std::vector<std::string> warnings;
    Scene scene = load_scene(file, {}, warnings);
    for (const std::string& warning : warnings) std::fprintf(stderr, "lumi-lab: warning: %s\n", warning.c_str());
    return scene;
}

Difference difference(const Colours& found, const Colours& truth)
{
    double squares = 0, sum = 0;
    size_t count = 0;
    for (size_t k = 0; k < found.size(); ++k) {
        const auto &a = found[k], &b = truth[k];
        if (!a || !b) continue;
        for (const int d : {a->r - b->r, a->g - b->g, a->b - b->b}) {
            squares += d * d;
            sum += d;
            ++count;
        }
    }
    const double n = static_cast<double>(count);
    return {std::sqrt(squares / n), sum / n};
}

constexpr uint32_t kTruth = 4096;  // light paths of a texel that count as its true colour
constexpr uint64_t kTruthSeed = 2, kChoiceSeed = 3;

struct Setup {
    uint32_t paths;
    float levels;
};
constexpr Setup kSetups[] = {{64, 1}, {256, 1}, {256, 2}};

struct Texels {
    Colours colours;
    uint64_t paths = 0;
};

// Draws texels of a field by lot; all settings get the same ones.
Texels traced(const Scene& scene, unsigned count, uint32_t paths, float levels, uint64_t seed)
{
    BakeSettings settings;
    settings.origins = settings.directions = 1448;
    settings.samples = paths;
    settings.max_error_levels = levels;
    settings.seed = seed;
    const TexelTracer tracer(scene.data(), settings);
    Texels result;
    for (uint32_t k = 0; k < count; ++k) {
        const Vec2 u = Sampler(kChoiceSeed, k, 0).next_2d();
        const uint32_t i = static_cast<uint32_t>(u.x * static_cast<float>(settings.origins));
        const uint32_t j = static_cast<uint32_t>(u.y * static_cast<float>(settings.directions));
        const Estimate estimate = tracer.estimate(tracer.disc(i), i, j);
        result.colours.push_back(colour_of(estimate));
        result.paths += estimate.samples();
    }
    return result;
}

}  // namespace

Json adaptive(const char* scene_file, unsigned count)
{
    const Scene scene = load(scene_file);
    const std::string name = std::filesystem::path(scene_file).filename();
    const Texels truth = traced(scene, count, kTruth, 0, kTruthSeed);
    Json rows = Json::array();
    for (const Setup& setup : kSetups) {
        const Texels all = traced(scene, count, setup.paths, 0, 1);
        const Texels some = traced(scene, count, setup.paths, setup.levels, 1);
        rows.push_back({{"scene", name},
                        {"paths", setup.paths},
                        {"levels", setup.levels},
                        {"error_all", difference(all.colours, truth.colours).rms},
                        {"error_adaptive", difference(some.colours, truth.colours).rms},
                        {"paths_taken", static_cast<double>(some.paths) / count},
                        {"shift", difference(some.colours, all.colours).mean}});
    }
    return rows;
}

namespace
{

constexpr uint32_t kSteps[] = {4, 16, 64, 256};

Colours colours(const Scene& scene, Rows rows, uint32_t samples, uint64_t seed)
{
    rows.settings.samples = samples;
    rows.settings.seed = seed;
    rows.settings.max_error_levels = 0;
    Colours result;
    trace_rows(scene, rows, [&](const Estimate& estimate) { result.push_back(colour_of(estimate)); });
    return result;
}

}  // namespace

Json convergence(const char* scene_file, unsigned count)
{
    const Scene scene = load(scene_file);
    Rows rows = {{}, count};
    rows.settings.origins = 4096;
    rows.settings.directions = 64;
    const Colours truth = colours(scene, rows, kTruth, kTruthSeed);
    std::vector<double> errors;
    for (const uint32_t paths : kSteps) errors.push_back(difference(colours(scene, rows, paths, 1), truth).rms);
    const double slope = std::log(errors.back() / errors.front()) / std::log(1.0 * *std::rbegin(kSteps) / kSteps[0]);
    const Json row = {{"scene", std::filesystem::path(scene_file).filename()},
                      {"paths", kSteps},
                      {"errors", errors},
                      {"exponent", slope}};
    return Json::array({row});
}

namespace
{

// A number of /proc/self/status, in bytes.
double status_bytes(const std::string& name)
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.rfind(name + ":", 0) == 0) return 1024 * std::stod(line.substr(name.size() + 1));
    return 0;
}

// A wavy square of about that many triangles, with texture coordinates and normals for smoothing.
void write_waves(const std::filesystem::path& file, unsigned triangles)
{
    const auto side = static_cast<unsigned>(std::sqrt(triangles / 2));
    std::ofstream out(file);
    out << "s 1\n";
    for (unsigned y = 0; y <= side; ++y) {
        for (unsigned x = 0; x <= side; ++x) {
            const double u = 1.0 * x / side, v = 1.0 * y / side;
            out << "v " << u << ' ' << 0.05 * std::sin(20 * u) * std::sin(30 * v) << ' ' << v << "\nvt " << u << ' '
                << v << '\n';
        }
    }
    for (unsigned y = 0; y < side; ++y) {
        for (unsigned x = 0; x < side; ++x) {
            const unsigned a = y * (side + 1) + x + 1, b = a + side + 1;
            out << "f " << a << '/' << a << ' ' << b << '/' << b << ' ' << b + 1 << '/' << b + 1 << ' ' << a + 1 << '/'
                << a + 1 << '\n';
        }
    }
}

}  // namespace

Json memory(unsigned triangles)
{
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("lumi-bench-" + std::to_string(getpid()) + ".obj");
    write_waves(file, triangles);
    const double before = status_bytes("VmRSS"), bytes_of_file = static_cast<double>(std::filesystem::file_size(file));
    const Scene scene = load(file.c_str());
    std::filesystem::remove(file);
    const double millions = 1e-6 * static_cast<double>(scene.triangle_count());
    const Json row = {{"triangles", scene.triangle_count()},
                      {"file_bytes", bytes_of_file},
                      {"held_bytes_a_million", (status_bytes("VmRSS") - before) / millions},
                      {"most_bytes_a_million", (status_bytes("VmHWM") - before) / millions}};
    return Json::array({row});
}

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
