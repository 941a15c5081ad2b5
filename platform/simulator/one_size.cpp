// SPDX-License-Identifier: MIT
// Programs that draw for one display alone link these.
#include "simulator.h"

int firmware_main();

int (*simulator::main_of_size(const char* name))()
{
    return name == size_names() ? firmware_main : nullptr;
}

std::string simulator::size_names()
{
    return "240x240";
}
