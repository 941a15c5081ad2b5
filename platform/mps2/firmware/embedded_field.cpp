// SPDX-License-Identifier: MIT
#include "field_source.h"

// embedded_field.S defines both.
extern "C" const uint8_t lumi_field_start[];
extern "C" const uint8_t lumi_field_end[];

namespace lumi::firmware
{

FieldBytes firmware_field()
{
    return {lumi_field_start, static_cast<size_t>(lumi_field_end - lumi_field_start)};
}

}  // namespace lumi::firmware
