// SPDX-License-Identifier: MIT
// Runs programs as a shell would, and keeps what they say.
#pragma once

#include <catch2/catch.hpp>
#include <string>
#include <type_traits>
#include <vector>

namespace lumi::tools::test
{

struct Outcome {
    int code;  // exit code, or 128 + the signal that ended it
    std::string out, err;
};

using Arguments = std::vector<std::string>;

inline Arguments joined(Arguments a, const Arguments& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// A small scene that the command line can bake.
inline const std::string kScene = LUMI_TEST_SCENE;

// `arguments[0]` is the program, found along PATH. No shell sees the arguments.
Outcome run_program(const Arguments& arguments);

// The `lumi` that was built.
Outcome lumi(Arguments arguments);

// Requires that the call succeeded.
inline Outcome done(Outcome outcome)
{
    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.code == 0);
    return outcome;
}

// Checks that the call ended with `code` and said so: a text, or what a matcher takes.
template <class Said>
void check_refused(const Outcome& outcome, int code, const Said& said)
{
    INFO(outcome.err);
    CHECK(outcome.code == code);
    if constexpr (std::is_convertible_v<const Said&, std::string>)
        CHECK_THAT(outcome.err, Catch::Contains(std::string(said)));
    else
        CHECK_THAT(outcome.err, said);
}

// Checks that `lumi` failed and said `word`.
inline void check_told(const Arguments& arguments, const std::string& word)
{
    const Outcome outcome = lumi(arguments);
    CHECK(outcome.code != 0);
    CHECK_THAT(outcome.err, Catch::Contains(word));
}

// Starts `lumi`, sends SIGINT once it has written the progress of its work, waits for its end.
Outcome lumi_interrupted(Arguments arguments);

}  // namespace lumi::tools::test
