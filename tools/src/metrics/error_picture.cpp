// SPDX-License-Identifier: MIT
#include "metrics/error_picture.h"

#include <algorithm>
#include <cstdlib>

namespace lumi::tools
{

Picture error_picture(const Picture& a, const Picture& b)
{
    check_precondition(same_size(a, b), "pictures of two sizes cannot be compared");
    Picture errors = a;
    for (size_t i = 0; i < errors.rgb.size(); ++i)
        errors.rgb[i] = static_cast<uint8_t>(std::min(255, kErrorGain * std::abs(a.rgb[i] - b.rgb[i])));
    return errors;
}

}  // namespace lumi::tools
