// SPDX-License-Identifier: MIT
#include "lumi/pack.h"

#include "c/types.h"

using namespace lumi::detail;

void lumi_pack_grey4(lumi_stripe grey, uint8_t* out, uint32_t out_stride_bytes)
{
    lumi::pack_grey4(in_cpp(grey), out, out_stride_bytes);
}

void lumi_pack_mono1(lumi_stripe grey, uint8_t* out, uint32_t out_stride_bytes)
{
    lumi::pack_mono1(in_cpp(grey), out, out_stride_bytes);
}

void lumi_pack_pages(lumi_stripe grey, uint8_t* out, uint32_t out_stride_bytes)
{
    lumi::pack_pages(in_cpp(grey), out, out_stride_bytes);
}
