// SPDX-License-Identifier: MIT
// The only file that sees libtorch: the network of network.h, what it learns by, and the module's entry.
#include <algorithm>
#include <array>

#include <torch/torch.h>

#include "filter/network.h"

namespace
{

using namespace lumi::filter;
using torch::Tensor;

constexpr float kLevels = 255;
// Sides that three halvings divide.
constexpr int64_t kGrain = 8;

// The same additions in the same order every time.
void use_one_thread()
{
    at::set_num_threads(1);
    at::globalContext().setDeterministicAlgorithms(true, true);
}

Tensor tensor_of(const Planes& planes)
{
    const Tensor bytes = torch::from_blob(const_cast<uint8_t*>(planes.values.data()),
                                          {1, planes.count, planes.height_px, planes.width_px}, torch::kUInt8);
    return (bytes.to(torch::kFloat) / kLevels).contiguous(at::MemoryFormat::ChannelsLast);
}

Planes planes_of(const Tensor& picture)
{
    const Tensor bytes = (picture.clamp(0, 1) * kLevels).round().to(torch::kUInt8).contiguous();
    Planes planes(static_cast<int>(bytes.size(1)), static_cast<int>(bytes.size(3)), static_cast<int>(bytes.size(2)));
    std::copy_n(bytes.data_ptr<uint8_t>(), planes.values.size(), planes.values.data());
    return planes;
}

Tensor picture_of(const Tensor& inputs)
{
    return inputs.slice(1, 0, kPicturePlanes);
}

// 1 where the filter may change a pixel.
Tensor reach(const Tensor& inputs)
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
    // Up to the level of `beside`.
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

std::vector<float> numbers_of(const UNet& net)
{
    std::vector<float> numbers;
    for (const Tensor& parameter : net.parameters()) {
        const Tensor flat = parameter.detach().contiguous();
        numbers.insert(numbers.end(), flat.data_ptr<float>(), flat.data_ptr<float>() + flat.numel());
    }
    return numbers;
}

void set_numbers_of(const UNet& net, const std::vector<float>& numbers)
{
    const torch::NoGradGuard no_grad;
    size_t at = 0;
    for (Tensor parameter : net.parameters()) {
        const auto values = torch::from_blob(const_cast<float*>(numbers.data() + at), parameter.sizes());
        parameter.copy_(values);
        at += static_cast<size_t>(parameter.numel());
    }
}

// libtorch's own errors as people can read them.
template <class Work>
auto without_backtrace(const Work& work)
{
    try {
        return work();
    } catch (const c10::Error& error) {
        throw std::runtime_error(std::string("libtorch: ") + error.what_without_backtrace());
    }
}

Planes filtered_by(const UNet& net, const Planes& inputs)
{
    return without_backtrace([&] {
        const torch::NoGradGuard no_grad;
        return planes_of(net.filtered(tensor_of(inputs)));
    });
}

class TorchNetwork : public Network
{
public:
    TorchNetwork(uint32_t input_planes, const std::vector<float>& numbers) : net_(input_planes, false)
    {
        set_numbers_of(net_, numbers);
    }
    Planes filtered(const Planes& inputs) override { return filtered_by(net_, inputs); }

private:
    UNet net_;
};

// The mean of 1 - SSIM of the luma over the windows around covered pixels (metrics/ssim.h).
Tensor unlikeness(const Tensor& a, const Tensor& b, const Tensor& where)
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

Tensor squared_error(const Tensor& a, const Tensor& b, const Tensor& where)
{
    return ((a - b).square() * where).sum() / (where.sum().clamp_min(1) * kPicturePlanes);
}

// Tells drawings from truths, each beside what was drawn: seven blocks of a convolution, dropout and average pooling.
struct DiscriminatorImpl : torch::nn::Module {
    DiscriminatorImpl()
    {
        constexpr std::array<int64_t, 7> kBlockWidths = {16, 32, 48, 64, 64, 64, 64};
        constexpr double kDropout = 0.2;
        int64_t before = 2 * kPicturePlanes;
        for (const int64_t width : kBlockWidths) {
            blocks->push_back(torch::nn::Conv2d(torch::nn::Conv2dOptions(before, width, 3).padding(1)));
            blocks->push_back(torch::nn::LeakyReLU(torch::nn::LeakyReLUOptions().negative_slope(0.2)));
            blocks->push_back(torch::nn::Dropout2d(kDropout));
            blocks->push_back(torch::nn::AvgPool2d(torch::nn::AvgPool2dOptions(2).ceil_mode(true)));
            before = width;
        }
        blocks->push_back(torch::nn::Conv2d(torch::nn::Conv2dOptions(before, 1, 1)));
        register_module("blocks", blocks);
    }
    Tensor forward(const Tensor& drawn, const Tensor& picture)
    {
        return blocks->forward(torch::cat({drawn, picture}, 1)).mean({1, 2, 3});
    }
    torch::nn::Sequential blocks;
};
TORCH_MODULE(Discriminator);

// The relativistic average loss with squares: `better` is to be above the mean of `worse` by 1, and the reverse.
Tensor relativistic(const Tensor& better, const Tensor& worse)
{
    return (better - worse.mean() - 1).square().mean() + (worse - better.mean() + 1).square().mean();
}

struct Examples {
    Tensor inputs, truth, where;
};

Examples examples_of(const std::vector<Pair>& batch)
{
    std::vector<Tensor> inputs, truths;
    for (const Pair& pair : batch) {
        inputs.push_back(tensor_of(pair.inputs));
        truths.push_back(tensor_of(pair.truth));
    }
    const auto joined = [](const std::vector<Tensor>& all) {
        return torch::cat(all).contiguous(at::MemoryFormat::ChannelsLast);
    };
    Examples examples = {joined(inputs), joined(truths), {}};
    examples.where = reach(examples.inputs);
    return examples;
}

class TorchTrainer : public Trainer
{
public:
    explicit TorchTrainer(uint32_t input_planes)
        : net_(input_planes, true),
          adam_(net_.parameters(), torch::optim::AdamOptions(1e-3)),
          judge_adam_(judge_->parameters(), torch::optim::AdamOptions(1e-3).betas({0.5, 0.999}))
    {
    }

    Planes filtered(const Planes& inputs) override { return filtered_by(net_, inputs); }
    std::vector<float> numbers() const override { return numbers_of(net_); }
    void set_numbers(const std::vector<float>& numbers) override { set_numbers_of(net_, numbers); }

    double step(const std::vector<Pair>& batch, Lesson lesson, double rate) override
    {
        return without_backtrace([&] { return learned(batch, lesson, rate); });
    }

private:
    double learned(const std::vector<Pair>& batch, Lesson lesson, double rate)
    {
        const Examples examples = examples_of(batch);
        const Tensor picture = net_.filtered(examples.inputs);
        Tensor loss = likeness_loss(examples, picture);
        if (lesson == Lesson::adversarial) loss = loss + adversarial_loss(examples, picture, rate);
        advance(adam_, net_.parameters(), loss, rate);
        return loss.item<double>();
    }

    static Tensor likeness_loss(const Examples& examples, const Tensor& picture)
    {
        constexpr double kErrorScale = 100, kUnlikenessScale = 0.5;  // both losses begin between 0.01 and 1
        const auto colours = [](const Tensor& t) { return t.slice(1, 0, 3); };
        return kErrorScale * squared_error(picture, examples.truth, examples.where) +
               kUnlikenessScale * unlikeness(colours(picture), colours(examples.truth), examples.where);
    }

    // The judge learns first; then what it says of the picture.
    Tensor adversarial_loss(const Examples& examples, const Tensor& picture, double rate)
    {
        constexpr double kScale = 0.01;
        const Tensor drawn = picture_of(examples.inputs);
        const Tensor judged = relativistic(judge_->forward(drawn, examples.truth), judge_->forward(drawn, picture.detach()));
        advance(judge_adam_, judge_->parameters(), judged, rate);
        return kScale *
               relativistic(judge_->forward(drawn, picture), judge_->forward(drawn, examples.truth).detach());
    }

    static void advance(torch::optim::Adam& adam, const std::vector<Tensor>& parameters, const Tensor& loss, double rate)
    {
        constexpr double kLongestGradient = 1;
        adam.zero_grad();
        loss.backward();
        torch::nn::utils::clip_grad_norm_(parameters, kLongestGradient);
        static_cast<torch::optim::AdamOptions&>(adam.param_groups().front().options()).lr(rate);
        adam.step();
    }

    UNet net_;
    Discriminator judge_;
    torch::optim::Adam adam_, judge_adam_;
};

class TorchModule : public Module
{
public:
    std::unique_ptr<Network> network(uint32_t input_planes, const std::vector<float>& numbers) override
    {
        use_one_thread();
        return std::make_unique<TorchNetwork>(input_planes, numbers);
    }
    std::unique_ptr<Trainer> trainer(uint32_t input_planes, uint64_t seed) override
    {
        use_one_thread();
        torch::manual_seed(seed);
        return std::make_unique<TorchTrainer>(input_planes);
    }
};

}  // namespace

extern "C" __attribute__((visibility("default"))) lumi::filter::Module* lumi_filter_module();
lumi::filter::Module* lumi_filter_module()
{
    static TorchModule module;
    return &module;
}
