// SPDX-License-Identifier: MIT
// The whole measurement: builds, bakes, runs, judges.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "bench/fields.h"
#include "bench/matrix.h"

namespace lumi::bench
{

struct Settings {
    std::filesystem::path source;  // the project's tree
    std::filesystem::path work;    // builds and fields; kept between runs
    FieldSettings field;
    std::filesystem::path surface_file;  // drawn in place of a surface field baked here; may be empty
    Matrix matrix;
};

// Told what is done next.
using Announce = std::function<void(const std::string&)>;

// Of chord fields: one result per existing combination of the matrix, in its order. Throws tools::Failure, also where a
// board draws other bits than this machine.
Results measure(const Settings& settings, const Announce& announce);

}  // namespace lumi::bench
