// SPDX-License-Identifier: MIT
// The numbers of a PLY file, one after the other.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "model/ply/header.h"

namespace lumi::baker
{

class PlyNumbers
{
public:
    // Begins behind the heading. `bytes` must live as long.
    PlyNumbers(const std::filesystem::path& file, const PlyHeader& header, std::string_view bytes);

    // Throws SceneError where the file ends, or holds what is no number of that type. Floats may be infinite or none.
    double next(PlyType type);
    // Throws SceneError where the file is too short for so many elements, or for so many numbers.
    void require(const PlyElement& element) const;
    void require(uint64_t numbers, PlyType type) const;

    // Whether all is read and no line end follows: then nobody can tell whether the last number is whole.
    bool ends_in_a_number() const { return text_ && rest_.empty(); }
    // For messages: where the next number stands.
    [[noreturn]] void fail(const std::string& text) const;

private:
    double next_word(PlyType type);
    void require_bytes(double bytes, const std::string& what) const;

    std::string file_;
    std::string_view rest_;
    bool text_, swapped_;
    uint32_t line_;
};

}  // namespace lumi::baker
