// SPDX-License-Identifier: MIT
// Calls the flush loop of docs/firmware.md and writes two frames, while a transfer runs from each to the next.
#include "product.h"
#include "slow_dma.h"
using namespace lumi;

static product_view<Screen<240, 240, 16>> view;

#include "flush_loop.h"

int main()
{
    if (view.open(product, product_size()) != ViewError::none) return 1;
    if (!draw_frame(degrees(30)) || !draw_frame(degrees(30) + degrees(2))) return 1;
    dma_wait();
    return 0;
}
