// SPDX-License-Identifier: MIT
// The network of network.h as libtorch computes it. Headers of this folder belong to module.cpp, the only file that
// sees libtorch.
#pragma once

#include <torch/torch.h>

#include <algorithm>
#include <vector>

#include "filter/network.h"

namespace lumi::filter
{

using torch::Tensor;

constexpr float kLevels = 255;
// Pads to sides that three halvings divide.
constexpr int64_t kGrain = 8;

inline Tensor tensor_of(const Planes& planes)
{
    const Tensor bytes = torch::from_blob(const_cast<uint8_t*>(planes.values.data()),
                                          {1, planes.count, planes.height_px, planes.width_px}, torch::kUInt8);
    return (bytes.to(torch::kFloat) / kLevels).contiguous(at::MemoryFormat::ChannelsLast);
}

inline Planes planes_of(const Tensor& picture)
{
    const Tensor bytes = (picture.clamp(0, 1) * kLevels).round().to(torch::kUInt8).contiguous();
    Planes planes(static_cast<int>(bytes.size(1)), static_cast<int>(bytes.size(3)), static_cast<int>(bytes.size(2)));
    std::copy_n(bytes.data_ptr<uint8_t>(), planes.values.size(), planes.values.data());
    return planes;
}

inline Tensor picture_of(const Tensor& inputs)
{
    return inputs.slice(1, 0, kPicturePlanes);
}

// 1 where the filter may change a pixel.
inline Tensor reach(const Tensor& inputs)
{
    const Tensor coverage = inputs.slice(1, kCoveragePlane, kCoveragePlane + 1);
    return torch::max_pool2d(coverage, 2 * kReachPx + 1, 1, kReachPx).gt(0).to(torch::kFloat);
}

class UNet
{
public:
    UNet(uint32_t input_planes, bool learns)
    {
        for (const Layer& layer : layers(input_planes)) {
            const auto inputs = static_cast<int64_t>(layer.inputs), outputs = static_cast<int64_t>(layer.outputs);
            weights_.push_back(torch::zeros({outputs, inputs, 3, 3}));
            if (learns) torch::nn::init::kaiming_normal_(weights_.back());
            biases_.push_back(torch::zeros({outputs}));
            strides_.push_back(layer.stride);
        }
        if (learns) torch::nn::init::zeros_(weights_.back());
        for (const Tensor& parameter : parameters()) parameter.set_requires_grad(learns);
    }

    std::vector<Tensor> parameters() const
    {
        std::vector<Tensor> all;
        for (size_t k = 0; k < weights_.size(); ++k) {
            all.push_back(weights_[k]);
            all.push_back(biases_[k]);
        }
        return all;
    }

    Tensor filtered(const Tensor& inputs) const
    {
        const int64_t height = inputs.size(2), width = inputs.size(3);
        const auto missing = [](int64_t side) { return (kGrain - side % kGrain) % kGrain; };
        const Tensor padded = torch::constant_pad_nd(inputs, {0, missing(width), 0, missing(height)});
        const Tensor change = residual(padded).slice(2, 0, height).slice(3, 0, width);
        return picture_of(inputs) + change * reach(inputs);
    }

private:
    Tensor convolved(size_t k, const Tensor& x) const
    {
        return torch::conv2d(x, weights_[k], biases_[k], static_cast<int64_t>(strides_[k]), 1);
    }
    Tensor layer(size_t k, const Tensor& x) const { return torch::relu(convolved(k, x)); }
    // Goes up to the level of `beside`.
    Tensor up(size_t k, const Tensor& x, const Tensor& beside) const
    {
        const Tensor wide = torch::upsample_nearest2d(layer(k, x), {beside.size(2), beside.size(3)});
        return layer(k + 1, wide + beside);
    }
    Tensor residual(const Tensor& inputs) const
    {
        const Tensor whole = layer(0, inputs), half = layer(1, whole), quarter = layer(2, half);
        const Tensor up_quarter = up(4, layer(3, quarter), quarter);
        return convolved(10, up(8, up(6, up_quarter, half), whole));
    }

    std::vector<Tensor> weights_, biases_;
    std::vector<uint32_t> strides_;
};

}  // namespace lumi::filter
