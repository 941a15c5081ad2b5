// SPDX-License-Identifier: MIT
// Several pictures in one.
#pragma once

#include "image/picture.h"

namespace lumi::tools
{

// Left and right eye next to each other, without a gap. Precondition: equal heights.
Picture side_by_side(const Picture& left, const Picture& right);

// `factor` × `factor` pixels become one, by their rounded mean; what is left over at the right and bottom is dropped.
// Precondition: 1 <= factor <= both sides.
Picture shrunk(const Picture& picture, int factor);

inline constexpr int kSheetGap = 4;
inline constexpr int kSheetMaxWidth = 2400;

// A grid of `count` equal pictures, row by row, about as wide as high, kSheetGap apart on the background; every picture
// is shrunk by a whole factor while the sheet would be wider than kSheetMaxWidth. Holds the sheet alone, not the
// pictures.
class ContactSheet
{
public:
    // Precondition: count, width and height are at least 1.
    ContactSheet(int count, int width_px, int height_px, const Rgb8& background);

    // Puts the next picture in place. Precondition: of the announced size, at most `count` of them.
    void add(const Picture& picture);
    const Picture& picture() const { return sheet_; }

private:
    int columns_, factor_, added_ = 0;
    Picture sheet_;
};

}  // namespace lumi::tools
