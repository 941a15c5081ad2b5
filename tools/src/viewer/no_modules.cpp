// SPDX-License-Identifier: MIT
// In place of modules.cpp, in a program that was built without clang and lld.
#include "viewer/modules.h"

namespace lumi::tools
{

std::string_view surface_module()
{
    return {};
}

std::string_view chord_module()
{
    return {};
}

}  // namespace lumi::tools
