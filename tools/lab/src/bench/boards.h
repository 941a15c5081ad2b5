// SPDX-License-Identifier: MIT
// The bench's firmware for one core: built by the project's own toolchain files, run on an emulated board.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/matrix.h"

namespace lumi::bench
{

class Board
{
public:
    // `core` is one of kCores. Configures a build of `source`, the project's tree, below `work`.
    Board(const std::string& core, const std::filesystem::path& source, const std::filesystem::path& work);

    // Builds the programs of these renderers ("spans_nearest_rgb565", …) and that of none.
    void build(const std::vector<std::string>& renderers) const;

    // Flash that the renderer takes: instructions, constants and library routines.
    uint32_t code_bytes(const std::string& renderer) const;

    // Draws these views with every span, counting instructions.
    std::vector<Count> count(const std::string& renderer, const std::filesystem::path& field,
                             const std::vector<std::string>& views, const std::vector<int>& spans) const;

    // Draws a surface field in these views and modes.
    std::vector<SurfaceCount> count_surface(const std::string& renderer, const std::filesystem::path& field,
                                            const std::vector<std::string>& views,
                                            const std::vector<std::string>& modes) const;

private:
    std::string run(const std::string& renderer, const std::filesystem::path& field,
                    const std::vector<std::string>& words) const;
    std::filesystem::path program(const std::string& name) const;

    std::filesystem::path folder_;
    std::string machine_, field_address_;
};

// Reads the lines of the bench firmware, as its main.cpp states them; throws tools::Failure on anything else.
std::vector<Count> parse_counts(const std::string& text);
// The same of its surface_main.cpp.
std::vector<SurfaceCount> parse_surface_counts(const std::string& text);

}  // namespace lumi::bench
