// SPDX-License-Identifier: MIT
// When training stops and what it keeps, with a network whose quality after each epoch is told by a list. None of it
// needs libtorch.
#include "filter/training.h"

#include <catch2/catch.hpp>

#include "lumi/baker/progress.h"

namespace lumi::filter
{

namespace
{

constexpr int kSide = 8;
constexpr uint8_t kReference = 100;

Planes flat(uint8_t value)
{
    Planes planes(kPicturePlanes, kSide, kSide);
    std::fill(planes.values.begin(), planes.values.end(), value);
    std::fill_n(planes.plane(kCoveragePlane), planes.size(), uint8_t{255});
    return planes;
}

// Drawings are 10 levels off.
std::vector<Pair> pairs(size_t count)
{
    return std::vector<Pair>(count, {flat(kReference + 10), flat(kReference)});
}

// After epoch k its pictures are errors[k] levels off; its one number is k.
class ListedTrainer : public Trainer
{
public:
    ListedTrainer(std::vector<int> errors, size_t pairs) : errors_(std::move(errors)), pairs_(pairs) {}

    Planes filtered(const Planes&) override { return flat(static_cast<uint8_t>(kReference + errors_.at(epoch()))); }
    double step(const std::vector<Pair>& batch, double rate) override
    {
        seen_ += batch.size();
        rates.push_back(rate);
        return 0;
    }
    std::vector<float> numbers() const override { return {static_cast<float>(seen_ / pairs_)}; }
    void set_numbers(const std::vector<float>&) override {}

    std::vector<double> rates;

private:
    size_t epoch() const { return seen_ / pairs_ - 1; }

    std::vector<int> errors_;
    size_t pairs_, seen_ = 0;
};

TrainingSettings settings(int epochs, int patience)
{
    TrainingSettings settings;
    settings.epochs = epochs;
    settings.patience = patience;
    return settings;
}

}  // namespace

TEST_CASE("training keeps the numbers that are best on the validation pairs, and ends when they get no better")
{
    ListedTrainer trainer({9, 5, 6, 7, 8, 1}, 6);
    const TrainingResult result = train(trainer, pairs(6), pairs(1), settings(6, 3), {});
    CHECK(result.gains);
    CHECK(result.epochs == 5);
    CHECK((result.numbers == std::vector<float>{2}));
    CHECK(result.filtered_db - result.drawn_db == Approx(6.02).margin(0.01));
}

TEST_CASE("where no epoch makes pictures better, the drawn picture is kept")
{
    ListedTrainer trainer({11, 10, 12}, 3);
    const TrainingResult result = train(trainer, pairs(3), pairs(1), settings(3, 10), {});
    CHECK_FALSE(result.gains);
    CHECK(result.filtered_db == result.drawn_db);
    CHECK((result.numbers == std::vector<float>{0}));
}

TEST_CASE("the rate falls from first to last, and a batch holds what is left")
{
    ListedTrainer trainer({9, 8, 7}, 5);
    const TrainingSettings asked = settings(3, 10);
    train(trainer, pairs(5), pairs(1), asked, {});
    CHECK(trainer.rates.size() == 6);
    CHECK(trainer.rates.front() == Approx(asked.first_rate));
    CHECK(trainer.rates.back() < trainer.rates[2]);
    CHECK(trainer.rates.back() > asked.last_rate);
}

TEST_CASE("training that is told to stop throws")
{
    ListedTrainer trainer({9}, 2);
    TrainingWatch watch;
    watch.step = [](uint64_t seen, uint64_t all) { return seen == 0 || all == 0; };
    CHECK_THROWS_AS(train(trainer, pairs(2), pairs(1), settings(1, 1), watch), baker::Cancelled);
}

}  // namespace lumi::filter
