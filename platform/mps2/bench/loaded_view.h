// SPDX-License-Identifier: MIT
// Every program that counts needs these: the field that the emulator has loaded, and the views that the command line
// names.
#pragma once

#include <cstring>

#include "lumi/bench/views.h"
#include "lumi/chord/detail/sphere.h"
#include "lumi/field.h"
#include "lumi/mps2/board.h"

namespace lumi::bench
{

// Opens the field at the start of the board's PSRAM as `open` does, and says why if that fails.
template <class AnyField>
bool open_loaded(FieldError (*open)(const uint8_t*, size_t, AnyField&), AnyField& field)
{
    const mps2::LoadedField file = mps2::loaded_field(0);
    const FieldError error = open(file.bytes, file.size, field);
    if (error == FieldError::none) return true;
    mps2::write("error: ");
    mps2::write(describe(error));
    mps2::write("\n");
    return false;
}

// Holds words of the command line. None at all stand for every view.
struct Words {
    const char* const* begin;
    const char* const* end;

    bool contain(const char* wanted) const
    {
        for (const char* const* word = begin; word != end; ++word)
            if (std::strcmp(*word, wanted) == 0) return true;
        return begin == end;
    }
};

// All but the program's name.
inline Words words_of(int argc, char** argv)
{
    return {argv + (argc > 0 ? 1 : 0), argv + argc};
}

// Pixels of the bench's picture whose rays meet the sphere.
inline uint32_t covered_pixels(const Camera& camera)
{
    uint32_t count = 0;
    for (int32_t y = 0; y < kSidePx; ++y) {
        const detail::Extent span = detail::covered_extent(camera, y, 0, kSidePx);
        count += static_cast<uint32_t>(span.end - span.begin);
    }
    return count;
}

}  // namespace lumi::bench
