// SPDX-License-Identifier: MIT
#include "terminal/failure.h"

namespace lumi::tools
{
namespace
{

bool is_done = false;

}  // namespace

void work_is_done()
{
    is_done = true;
}

bool is_work_done()
{
    return is_done;
}

}  // namespace lumi::tools
