// SPDX-License-Identifier: MIT
// The network learns by these.
#pragma once

#include "filter/torch/unet.h"

namespace lumi::filter
{

// The mean of 1 - SSIM of the luma over the windows around covered pixels (metrics/metrics.h).
inline Tensor unlikeness(const Tensor& a, const Tensor& b, const Tensor& where)
{
    constexpr int64_t kWindow = 11;
    constexpr double kSigma = 1.5, kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;
    const Tensor x = torch::arange(kWindow) - static_cast<double>(kWindow / 2);
    Tensor gauss = torch::exp(-x * x / (2 * kSigma * kSigma));
    gauss = gauss / gauss.sum();
    const Tensor window = torch::outer(gauss, gauss).view({1, 1, kWindow, kWindow});
    const Tensor luma = torch::tensor({0.299f, 0.587f, 0.114f}).view({1, 3, 1, 1});
    const auto mean = [&](const Tensor& t) { return torch::conv2d(t, window); };
    const Tensor p = (a * luma).sum(1, true), q = (b * luma).sum(1, true);
    const Tensor mp = mean(p), mq = mean(q);
    const Tensor vp = mean(p * p) - mp * mp, vq = mean(q * q) - mq * mq, cov = mean(p * q) - mp * mq;
    const Tensor ssim = (2 * mp * mq + kC1) * (2 * cov + kC2) / ((mp * mp + mq * mq + kC1) * (vp + vq + kC2));
    const int64_t edge = kWindow / 2;
    const Tensor counts = where.slice(2, edge, where.size(2) - edge).slice(3, edge, where.size(3) - edge);
    return ((1 - ssim) * counts).sum() / counts.sum().clamp_min(1);
}

inline Tensor squared_error(const Tensor& a, const Tensor& b, const Tensor& where)
{
    return ((a - b).square() * where).sum() / (where.sum().clamp_min(1) * kPicturePlanes);
}

}  // namespace lumi::filter
