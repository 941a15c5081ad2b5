// SPDX-License-Identifier: MIT
#include "field_source.h"
#include "lumi/mps2/loaded_field.h"

namespace lumi::firmware
{

FieldBytes firmware_field()
{
    const mps2::LoadedField field = mps2::loaded_field(0);
    return {field.bytes, field.size};
}

}  // namespace lumi::firmware
