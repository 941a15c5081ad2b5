// SPDX-License-Identifier: MIT
// The WebAssembly modules that pages run (platform/wasm), compressed by gzip. They are in the program where it was
// built with clang and lld.
#pragma once

#include <string_view>

namespace lumi::tools
{

// Empty where the program was built without them.
std::string_view surface_module();
std::string_view chord_module();

}  // namespace lumi::tools
