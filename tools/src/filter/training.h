// SPDX-License-Identifier: MIT
// How a filter learns: in which order, how fast, when it stops, and whether what it has learned is worth keeping.
#pragma once

#include <functional>
#include <string>

#include "filter/network.h"

namespace lumi::filter
{

struct TrainingSettings {
    int epochs = 60;    // at most; in each, every pair is seen once, by a part of it
    int patience = 10;  // epochs without a gain on the validation pairs that end it
    int batch = 4;      // pairs of a step
    int part_px = 128;  // side of the part of a pair that a step sees; the whole where it is smaller
    double first_rate = 5e-4, last_rate = 2.5e-5;  // rate of learning; falls like half a cosine
    uint64_t seed = 1;
};

struct EpochReport {
    int epoch = 0, epochs = 0;  // done, at most
    double validation_db = 0, best_db = 0, drawn_db = 0;
};

// Both are called from train()'s thread; `pairs_seen` after each step. Returning false cancels: train() throws
// baker::Cancelled.
struct TrainingWatch {
    std::function<bool(uint64_t pairs_seen, uint64_t pairs_in_all)> step;
    std::function<void(const EpochReport&)> epoch;
};

struct TrainingResult {
    bool gains = false;  // else the drawn picture is the best that there is
    double drawn_db = 0, filtered_db = 0;
    int epochs = 0;
    std::vector<float> numbers;
};

// The mean of the pairs' PSNR over black, filtered by `network`, or as they are drawn where it is null.
double mean_psnr_db(const std::vector<Pair>& pairs, Network* network);

// Learns from `training`, keeps the numbers that are best on `validation`.
TrainingResult train(Trainer& trainer, const std::vector<Pair>& training, const std::vector<Pair>& validation,
                     const TrainingSettings& settings, const TrainingWatch& watch);

// Finds the module that computes filters, where this program was built with one.

// The module's one symbol: a function of no arguments that returns a Module, which lives as long as the program.
inline constexpr char kModuleSymbol[] = "lumi_filter_module";

// Loads the module from beside the program, or from where `cmake --install` puts it. Throws Failure where it is not
// there or does not load: it names libtorch's package. Cost: a second, the first time.
Module& load_module();

}  // namespace lumi::filter
