// SPDX-License-Identifier: MIT
// Files of weights: read back as they were written, and refused when they are damaged. None of it needs libtorch.
#include "filter/weights_file.h"

#include <catch2/catch.hpp>
#include <limits>

#include "support/temporary_folder.h"
#include "support/test_field.h"
#include "terminal/failure.h"

namespace lumi::filter
{

namespace
{

Weights idle_weights()
{
    Weights weights;
    weights.subject = {{1, 2}, {3, 4}, {5, 6, 7, 8}};
    return weights;
}

Weights learned_weights(uint32_t planes)
{
    Weights weights = idle_weights();
    weights.input_planes = planes;
    weights.gains = true;
    for (size_t k = 0; k < number_count(planes); ++k) weights.numbers.push_back(static_cast<float>(k) / 1024);
    return weights;
}

bool is_refused(const std::string& bytes)
{
    try {
        decode(bytes, "w");
        return false;
    } catch (const tools::Failure&) {
        return true;
    }
}

std::string problem_of(const std::string& bytes)
{
    try {
        decode(bytes, "w");
        return "";
    } catch (const tools::Failure& failure) {
        return failure.what();
    }
}

}  // namespace

TEST_CASE("weights are read as they were written")
{
    for (const uint32_t planes : {uint32_t{kPicturePlanes}, uint32_t{kSurfacePlanes}}) {
        const Weights written = learned_weights(planes), read = decode(encode(written), "w");
        CHECK(read.subject == written.subject);
        CHECK(read.input_planes == planes);
        CHECK(read.gains);
        CHECK((read.numbers == written.numbers));
    }
    const Weights idle = decode(encode(idle_weights()), "w");
    CHECK_FALSE(idle.gains);
    CHECK(idle.numbers.empty());
}

TEST_CASE("weights that are cut short or too long are refused")
{
    const std::string idle = encode(idle_weights());
    int accepted = 0;
    for (size_t size = 0; size < idle.size(); ++size) accepted += !is_refused(std::string(idle.data(), size));
    CHECK(accepted == 0);
    CHECK(is_refused(idle + '\0'));
    const std::string learned = encode(learned_weights(kPicturePlanes));
    constexpr size_t kStep = 40009;  // each length would take a CRC of megabytes
    for (size_t size = learned.size() % kStep; size < learned.size(); size += kStep)
        accepted += !is_refused(learned.substr(0, size));
    CHECK(accepted == 0);
}

TEST_CASE("weights from a device that has no end are refused")
{
    CHECK_THROWS_WITH(read_weights("/dev/zero"),
                      Catch::Contains("/dev/zero: is larger than any weights of a filter; "));
}

TEST_CASE("weights with any byte changed are refused")
{
    const std::string idle = encode(idle_weights());
    int accepted = 0;
    for (size_t at = 0; at < idle.size(); ++at) {
        std::string changed = idle;
        changed[at] = static_cast<char>(changed[at] ^ 1);
        accepted += !is_refused(changed);
    }
    CHECK(accepted == 0);
}

TEST_CASE("weights that hold something else than their network takes are refused, and the message says what")
{
    Weights few = learned_weights(kPicturePlanes), infinite = few;
    few.numbers.pop_back();
    CHECK_THAT(problem_of(encode(few)), Catch::Contains("not as many as its network takes"));
    infinite.numbers.back() = std::numeric_limits<float>::infinity();
    CHECK_THAT(problem_of(encode(infinite)), Catch::Contains("not finite"));
    Weights odd = idle_weights();
    odd.input_planes = 5;
    CHECK_THAT(problem_of(encode(odd)), Catch::Contains("none that this lumi writes"));
    CHECK_THAT(problem_of(tools::test::field_bytes({})), Catch::Contains("holds no weights of a filter"));
    CHECK_THAT(problem_of("hello"), Catch::Contains("lumi filter train"));
}

TEST_CASE("a filter is refused for another field than its own unless it is forced")
{
    const tools::test::TemporaryFolder folder;
    tools::test::write_content(folder / "a.lumi", tools::test::field_bytes({}));
    tools::test::write_content(folder / "b.lumi", tools::test::field_bytes({41, 60, 40}));
    const tools::FieldFile a(folder / "a.lumi"), b(folder / "b.lumi");
    Weights weights = idle_weights();
    weights.subject = subject_of(a);
    CHECK_NOTHROW(require_fitting(weights, "w", a, false));
    CHECK_THROWS_WITH(require_fitting(weights, "w", b, false), Catch::Contains("another field") &&
                                                                   !Catch::Contains("another scene") &&
                                                                   Catch::Contains("--force-filter"));
    CHECK_NOTHROW(require_fitting(weights, "w", b, true));
    weights.subject.sphere[0] ^= 1;
    CHECK_THROWS_WITH(require_fitting(weights, "w", b, false), Catch::Contains("of another scene"));
    weights.input_planes = kSurfacePlanes;
    CHECK_THROWS_WITH(require_fitting(weights, "w", a, true), Catch::Contains("is a chord field"));
}

}  // namespace lumi::filter
