// SPDX-License-Identifier: MIT
#include "program/plugin.h"

namespace lumi::tools
{

std::vector<Plugin>& plugins()
{
    static std::vector<Plugin> all;
    return all;
}

}  // namespace lumi::tools
