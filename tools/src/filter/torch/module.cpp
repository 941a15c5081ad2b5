// SPDX-License-Identifier: MIT
// The only file that sees libtorch: the networks, how they learn, and the module's entry.
#include <stdexcept>
#include <string>

#include "filter/torch/losses.h"
#include "filter/torch/unet.h"

namespace
{

using namespace lumi::filter;

// Every call makes the same additions in the same order.
void use_one_thread()
{
    at::set_num_threads(1);
    at::globalContext().setDeterministicAlgorithms(true, true);
}

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

struct Examples {
    Tensor inputs, reference, where;
};

Examples examples_of(const std::vector<Pair>& batch)
{
    std::vector<Tensor> inputs, references;
    for (const Pair& pair : batch) {
        inputs.push_back(tensor_of(pair.inputs));
        references.push_back(tensor_of(pair.reference));
    }
    const auto joined = [](const std::vector<Tensor>& all) {
        return torch::cat(all).contiguous(at::MemoryFormat::ChannelsLast);
    };
    Examples examples = {joined(inputs), joined(references), {}};
    examples.where = reach(examples.inputs);
    return examples;
}

class TorchTrainer : public Trainer
{
public:
    explicit TorchTrainer(uint32_t input_planes)
        : net_(input_planes, true), adam_(net_.parameters(), torch::optim::AdamOptions(1e-3))
    {
    }

    Planes filtered(const Planes& inputs) override { return filtered_by(net_, inputs); }
    std::vector<float> numbers() const override { return numbers_of(net_); }
    void set_numbers(const std::vector<float>& numbers) override { set_numbers_of(net_, numbers); }

    double step(const std::vector<Pair>& batch, double rate) override
    {
        return without_backtrace([&] { return learned(batch, rate); });
    }

private:
    double learned(const std::vector<Pair>& batch, double rate)
    {
        const Examples examples = examples_of(batch);
        const Tensor picture = net_.filtered(examples.inputs);
        const Tensor loss = likeness_loss(examples, picture);
        advance(loss, rate);
        return loss.item<double>();
    }

    static Tensor likeness_loss(const Examples& examples, const Tensor& picture)
    {
        constexpr double kErrorScale = 100, kUnlikenessScale = 0.5;  // both losses begin between 0.01 and 1
        const auto colours = [](const Tensor& t) { return t.slice(1, 0, 3); };
        return kErrorScale * squared_error(picture, examples.reference, examples.where) +
               kUnlikenessScale * unlikeness(colours(picture), colours(examples.reference), examples.where);
    }

    void advance(const Tensor& loss, double rate)
    {
        constexpr double kLongestGradient = 1;
        adam_.zero_grad();
        loss.backward();
        torch::nn::utils::clip_grad_norm_(net_.parameters(), kLongestGradient);
        static_cast<torch::optim::AdamOptions&>(adam_.param_groups().front().options()).lr(rate);
        adam_.step();
    }

    UNet net_;
    torch::optim::Adam adam_;
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
