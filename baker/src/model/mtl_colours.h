// SPDX-License-Identifier: MIT
// Colours of MTL files that were stated as a display shows them, encoded as sRGB, in place of linear light.
//
// MTL does not say which. Blender and the PBR extension write linear numbers. 3ds Max, SketchUp, Java3D and others
// write the numbers of a colour picker.
#pragma once

#include <string_view>
#include <vector>

#include "model/mtl_reader.h"

namespace lumi::baker
{

// Kd, Ks, Ke and Tf become linear light.
void linearise(MtlMaterial& material);

// A comment names a program that writes colours for displays, or nearly all numbers are whole steps of 1/255. Numbers
// that people also write by hand, whole fifths, say nothing.
bool look_displayed(std::string_view mtl_text, const std::vector<MtlMaterial>& materials);

}  // namespace lumi::baker
