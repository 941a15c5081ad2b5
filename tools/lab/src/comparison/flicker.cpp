// SPDX-License-Identifier: MIT
#include "comparison/flicker.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lumi::quality
{

namespace
{

constexpr std::array kModes = {SurfaceMode::one_sample, SurfaceMode::antialiased, SurfaceMode::two_by_two};
constexpr int kFiner = 4;  // by 2×2 samples: 64 a pixel

using Levels = std::vector<double>;

tools::Eye eye_at(double distance, int side_px)
{
    constexpr double kAzimuthDeg = 30, kElevationDeg = 20, kFovDeg = 42;
    return {host::make_pose({kAzimuthDeg, kElevationDeg, distance}), host::make_image(side_px, side_px, kFovDeg), {}};
}

Levels levels_of(const tools::Picture& picture)
{
    return {picture.rgb.begin(), picture.rgb.end()};
}

// What a pixel should show, up to rounding.
Levels ideal_of(const SurfaceField& field, double distance, int side_px)
{
    const tools::Picture fine = tools::draw_surface(field, eye_at(distance, kFiner * side_px));
    Levels mean(3 * static_cast<size_t>(side_px) * static_cast<size_t>(side_px));
    for (int y = 0; y < fine.height_px; ++y)
        for (int x = 0; x < fine.width_px; ++x)
            for (size_t k = 0; k < 3; ++k)
                mean[3 * (static_cast<size_t>(y / kFiner) * static_cast<size_t>(side_px) +
                          static_cast<size_t>(x / kFiner)) +
                     k] += fine.pixel(x, y)[k] / (1.0 * kFiner * kFiner);
    return mean;
}

class Restlessness
{
public:
    // The change from `before` to `now` beyond that of the ideal.
    void add(const Levels& before, const Levels& now, const Levels& ideal_before, const Levels& ideal_now)
    {
        for (size_t i = 0; i < now.size(); ++i) {
            if (before[i] + now[i] + ideal_before[i] + ideal_now[i] <= 0) continue;
            const double beyond = now[i] - before[i] - (ideal_now[i] - ideal_before[i]);
            sum_ += beyond * beyond;
            ++count_;
        }
    }
    double rms() const { return count_ > 0 ? std::sqrt(sum_ / static_cast<double>(count_)) : 0; }

private:
    double sum_ = 0;
    uint64_t count_ = 0;
};

}  // namespace

std::vector<Flicker> zoom_flicker(const SurfaceField& field, int frames, int side_px)
{
    std::array<Restlessness, kModes.size()> restlessness;
    std::array<Levels, kModes.size()> before;
    Levels ideal_before;
    for (int frame = 0; frame < frames; ++frame) {
        const double distance = kZoomNearest * std::pow(kZoomFarthest / kZoomNearest, 1.0 * frame / (frames - 1));
        Levels ideal = ideal_of(field, distance, side_px);
        for (size_t m = 0; m < kModes.size(); ++m) {
            Levels now = levels_of(tools::draw_surface(field, eye_at(distance, side_px), {kModes[m]}));
            if (frame > 0) restlessness[m].add(before[m], now, ideal_before, ideal);
            before[m] = std::move(now);
        }
        ideal_before = std::move(ideal);
    }
    const double least = restlessness.back().rms();
    std::vector<Flicker> all;
    for (size_t m = 0; m < kModes.size(); ++m)
        all.push_back({kModes[m], restlessness[m].rms(), least > 0 ? restlessness[m].rms() / least : 1});
    return all;
}

}  // namespace lumi::quality
