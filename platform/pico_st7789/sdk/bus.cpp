// SPDX-License-Identifier: MIT
// The Pico SDK does what bus.h says.
#include "bus.h"

#include <hardware/dma.h>
#include <hardware/gpio.h>
#include <hardware/spi.h>

namespace
{

constexpr uint kChipSelect = 17, kClock = 18, kTransmit = 19, kData = 20, kReset = 21, kBaud = 62500000;
uint channel;

void start_output(uint pin, bool value)
{
    gpio_init(pin);
    gpio_put(pin, value);
    gpio_set_dir(pin, GPIO_OUT);
}

}  // namespace

void bus::start()
{
    spi_init(spi0, kBaud);
    gpio_set_function(kClock, GPIO_FUNC_SPI);
    gpio_set_function(kTransmit, GPIO_FUNC_SPI);
    start_output(kChipSelect, false);
    start_output(kData, true);
    start_output(kReset, true);
    channel = static_cast<uint>(dma_claim_unused_channel(true));
    dma_channel_config config = dma_channel_get_default_config(channel);
    channel_config_set_transfer_data_size(&config, DMA_SIZE_8);
    channel_config_set_dreq(&config, spi_get_dreq(spi0, true));
    dma_channel_configure(channel, &config, &spi_get_hw(spi0)->dr, nullptr, 0, false);
}

void bus::take_command()
{
    gpio_put(kData, false);
}

void bus::take_data()
{
    gpio_put(kData, true);
}

void bus::put(uint8_t byte)
{
    spi_write_blocking(spi0, &byte, 1);
}

void bus::send(const uint8_t* bytes, uint32_t count)
{
    dma_channel_wait_for_finish_blocking(channel);
    dma_channel_transfer_from_buffer_now(channel, bytes, count);
}

void bus::wait()
{
    dma_channel_wait_for_finish_blocking(channel);
    while (spi_is_busy(spi0)) tight_loop_contents();
}
