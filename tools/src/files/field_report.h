// SPDX-License-Identifier: MIT
// This is all that `lumi inspect` says about a field file.
#pragma once

#include <string>

#include "files/field_file.h"

namespace lumi::tools
{

uint32_t triangles_of(const SurfaceField& field);

// For people, and for programs; both end with a line break. If `verify`, each section's bytes are compared with its
// CRC.
std::string report_text(const FieldFile& file, bool verify);
std::string report_json(const FieldFile& file, bool verify);

}  // namespace lumi::tools
