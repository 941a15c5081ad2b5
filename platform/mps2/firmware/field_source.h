// SPDX-License-Identifier: MIT
// Where lumi_demo_firmware finds its field. The build links one of two definitions: embedded_field.cpp, with the file
// that LUMI_FIRMWARE_FIELD names inside the program, or psram_field.cpp, for a field put into PSRAM by the loader.
#pragma once

#include "frame_list.h"

namespace lumi::firmware
{

FieldBytes firmware_field();

}  // namespace lumi::firmware
