// SPDX-License-Identifier: MIT
#include "filter/training.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "filter/drawing.h"
#include "lumi/baker/plug_in.h"
#include "lumi/baker/progress.h"
#include "math/pi.h"
#include "metrics/metrics.h"
#include "terminal/failure.h"

namespace lumi::filter
{

namespace
{

Planes part_of(const Planes& planes, int x, int y, int width, int height)
{
    Planes part(planes.count, width, height);
    for (int k = 0; k < planes.count; ++k)
        for (int row = 0; row < height; ++row) {
            const uint8_t* const from = planes.plane(k) + static_cast<ptrdiff_t>(y + row) * planes.width_px + x;
            std::copy(from, from + width, part.plane(k) + static_cast<ptrdiff_t>(row) * width);
        }
    return part;
}

bool shows_something(const Planes& inputs)
{
    const uint8_t* const coverage = inputs.plane(kCoveragePlane);
    return std::any_of(coverage, coverage + inputs.size(), [](uint8_t c) { return c != 0; });
}

class Training
{
public:
    Training(Trainer& trainer, const std::vector<Pair>& training, const std::vector<Pair>& validation,
             const TrainingSettings& settings, const TrainingWatch& watch)
        : trainer_(trainer),
          training_(training),
          validation_(validation),
          settings_(settings),
          watch_(watch),
          random_(settings.seed),
          pairs_left_(training.size() * static_cast<uint64_t>(settings.epochs))
    {
        result_.drawn_db = result_.filtered_db = mean_psnr_db(validation, nullptr);
        result_.numbers = trainer.numbers();
    }

    TrainingResult run()
    {
        int without_gain = 0;
        for (int k = 0; k < settings_.epochs && without_gain < settings_.patience; ++k) {
            const double db = epoch(static_cast<double>(k) / settings_.epochs);
            ++without_gain;
            if (db > result_.filtered_db) {
                keep(db);
                without_gain = 0;
            }
            tell(db);
        }
        return result_;
    }

private:
    void keep(double db)
    {
        result_.gains = true;
        result_.filtered_db = db;
        result_.numbers = trainer_.numbers();
    }

    void tell(double db) const
    {
        if (watch_.epoch) watch_.epoch({result_.epochs, settings_.epochs, db, result_.filtered_db, result_.drawn_db});
    }

    // Returns the validation pairs' PSNR after it.
    double epoch(double time)
    {
        const double rate =
            settings_.last_rate + (settings_.first_rate - settings_.last_rate) * (1 + std::cos(tools::kPi * time)) / 2;
        std::vector<size_t> order(training_.size());
        for (size_t i = 0; i < order.size(); ++i) order[i] = i;
        for (size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random_() % i]);
        const size_t batch_size = static_cast<size_t>(settings_.batch);
        for (size_t from = 0; from < order.size(); from += batch_size) {
            std::vector<Pair> batch;
            for (size_t i = from; i < std::min(order.size(), from + batch_size); ++i)
                batch.push_back(random_part(training_[order[i]]));
            trainer_.step(batch, rate);
            pairs_seen_ += batch.size();
            if (watch_.step && !watch_.step(pairs_seen_, pairs_left_)) throw baker::Cancelled();
        }
        ++result_.epochs;
        return mean_psnr_db(validation_, &trainer_);
    }

    Pair random_part(const Pair& pair)
    {
        constexpr int kTries = 8;
        const int width = std::min(settings_.part_px, pair.reference.width_px);
        const int height = std::min(settings_.part_px, pair.reference.height_px);
        Pair part;
        for (int k = 0; k < kTries; ++k) {
            const int x = below(pair.reference.width_px - width + 1), y = below(pair.reference.height_px - height + 1);
            part = {part_of(pair.inputs, x, y, width, height), part_of(pair.reference, x, y, width, height)};
            if (shows_something(part.inputs)) break;
        }
        return part;
    }

    int below(int count) { return static_cast<int>(random_() % static_cast<uint64_t>(count)); }

    Trainer& trainer_;
    const std::vector<Pair>&training_, &validation_;
    const TrainingSettings& settings_;
    const TrainingWatch& watch_;
    std::mt19937_64 random_;
    uint64_t pairs_seen_ = 0;
    const uint64_t pairs_left_;
    TrainingResult result_;
};

}  // namespace

double mean_psnr_db(const std::vector<Pair>& pairs, Network* network)
{
    double sum = 0;
    for (const Pair& pair : pairs) {
        const tools::Picture picture = over(network != nullptr ? network->filtered(pair.inputs) : pair.inputs);
        sum += std::min(quality::kIdenticalDb, tools::psnr_db(picture, over(pair.reference)));
    }
    return sum / static_cast<double>(pairs.size());
}

TrainingResult train(Trainer& trainer, const std::vector<Pair>& training, const std::vector<Pair>& validation,
                     const TrainingSettings& settings, const TrainingWatch& watch)
{
    return Training(trainer, training, validation, settings, watch).run();
}

namespace
{

Module& open_module()
{
    using Entry = Module* (*)();
    try {
        return *reinterpret_cast<Entry>(
            baker::symbol_of_plug_in("lumi_filter.so", kModuleSymbol, "its learned filter"))();
    } catch (const baker::NoPlugIn& none) {
        throw tools::Failure(none.path, none.problem,
                             "install libtorch (Debian: libtorch-dev), then configure and build lumi again");
    }
}

}  // namespace

Module& load_module()
{
    static Module& module = open_module();
    return module;
}

}  // namespace lumi::filter
