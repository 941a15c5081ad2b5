// SPDX-License-Identifier: MIT
// The learned filter as the tools see it: planes of bytes in and out, and a list of numbers that it has learned. What
// computes it is a module of its own (torch), made with libtorch and loaded when it is asked for (training.h), so that
// nothing else depends on libtorch, nor waits for it to start.
//
// A small U-Net: three times half the size on the way down, nearest upsampling on the way up, each level added to what
// the way down left there. Every layer is a 3×3 convolution with a bias. What comes out is added to the drawn picture,
// and the last layer begins as zeros: a network that has learned nothing returns what it was given.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace lumi::filter
{

// Holds planes of bytes, one after the other, top row first.
struct Planes {
    int count = 0, width_px = 0, height_px = 0;
    std::vector<uint8_t> values;

    Planes() = default;
    Planes(int planes, int width, int height)
        : count(planes), width_px(width), height_px(height), values(static_cast<size_t>(planes) * size())
    {
    }
    size_t size() const { return static_cast<size_t>(width_px) * static_cast<size_t>(height_px); }  // pixels a plane
    uint8_t* plane(int k) { return values.data() + static_cast<size_t>(k) * size(); }
    const uint8_t* plane(int k) const { return values.data() + static_cast<size_t>(k) * size(); }
};

// These planes come out, and are the first of what goes in: red, green and blue, encoded and premultiplied; coverage.
inline constexpr int kPicturePlanes = 4;
inline constexpr int kCoveragePlane = 3;
// For surface fields the mean colour (3), depth (1) and how depth changes to the right and down (2) follow.
inline constexpr int kSurfacePlanes = 10;

// The filter changes pixels that are covered or at most so far from a covered one.
inline constexpr int kReachPx = 2;

struct Layer {
    uint32_t inputs, outputs, stride;

    constexpr size_t weights() const { return size_t{9} * inputs * outputs; }
    constexpr size_t numbers() const { return weights() + outputs; }
};

inline constexpr std::array<uint32_t, 4> kWidths = {24, 48, 96, 96};
inline constexpr size_t kLayers = 11;

// In the order in which they are computed, and stored: weights (output, input, row, column), then biases.
constexpr std::array<Layer, kLayers> layers(uint32_t input_planes)
{
    constexpr auto w = kWidths;
    return {{{input_planes, w[0], 1},
             {w[0], w[1], 2},
             {w[1], w[2], 2},
             {w[2], w[3], 2},
             {w[3], w[2], 1},  // on the way up: to the width of the level above, then one layer there
             {w[2], w[2], 1},
             {w[2], w[1], 1},
             {w[1], w[1], 1},
             {w[1], w[0], 1},
             {w[0], w[0], 1},
             {w[0], kPicturePlanes, 1}}};
}

constexpr size_t number_count(uint32_t input_planes)
{
    size_t count = 0;
    for (const Layer& layer : layers(input_planes)) count += layer.numbers();
    return count;
}

class Network
{
public:
    virtual ~Network() = default;
    // Returns kPicturePlanes of the size of `inputs`.
    virtual Planes filtered(const Planes& inputs) = 0;
};

// A pair holds what is drawn, and the path-traced reference of it (kPicturePlanes).
struct Pair {
    Planes inputs, reference;
};

class Trainer : public Network
{
public:
    // One step of gradient descent over pairs of one size: squared error, and 1 - SSIM. Returns the mean loss.
    virtual double step(const std::vector<Pair>& batch, double rate) = 0;
    virtual std::vector<float> numbers() const = 0;
    virtual void set_numbers(const std::vector<float>& numbers) = 0;
};

// Equal calls give equal bits: everything is computed by one thread.
class Module
{
public:
    virtual ~Module() = default;
    // Precondition: number_count(input_planes) numbers.
    virtual std::unique_ptr<Network> network(uint32_t input_planes, const std::vector<float>& numbers) = 0;
    virtual std::unique_ptr<Trainer> trainer(uint32_t input_planes, uint64_t seed) = 0;
};

}  // namespace lumi::filter
