/* SPDX-License-Identifier: MIT
 * A display's DMA that is as slow as it may be: a transfer ends when it is waited for, not before. What was started is
 * written to standard output at once; then noise lies in its place, of which a write leaves traces. */
#ifndef SLOW_DMA_H
#define SLOW_DMA_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Ends the program with 1 if a transfer is running. */
void dma_start(const uint8_t* pixels, uint32_t bytes);
/* Ends the running transfer, if there is one. Ends the program with 1 if its pixels were written meanwhile. */
void dma_wait(void);

#ifdef __cplusplus
}
#endif

#endif
