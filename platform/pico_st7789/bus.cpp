// SPDX-License-Identifier: MIT
#include "bus.h"

#include "rp2040.h"

namespace bus
{
namespace
{

using namespace rp2040;

constexpr uint32_t kChipSelect = 1u << 17, kData = 1u << 20, kNoReset = 1u << 21;
constexpr uint32_t kSpiData = kSpi0 + 0x08, kSpiStatus = kSpi0 + 0x0C;
constexpr uint32_t kDmaControl = kDma + 0x0C, kBusy = 1u << 24;

void set_pins(uint32_t pins)
{
    at(kSio + 0x14) = pins;
}
void clear_pins(uint32_t pins)
{
    at(kSio + 0x18) = pins;
}

}  // namespace

void start()
{
    at(kSpi0 + 0x10) = 2;  // 125 MHz / 2
    at(kSpi0) = 7;         // 8 bits, mode 0
    at(kSpi0 + 0x24) = 2;  // asks DMA for more
    at(kSpi0 + 0x04) = 2;  // on
    set_function(18, kSpiFunction);
    set_function(19, kSpiFunction);
    set_function(17, kSioFunction);
    set_function(20, kSioFunction);
    set_function(21, kSioFunction);
    at(kSio + 0x24) = kChipSelect | kData | kNoReset;  // outputs
    clear_pins(kChipSelect);
    set_pins(kNoReset | kData);
}

void take_command()
{
    clear_pins(kData);
}

void take_data()
{
    set_pins(kData);
}

void put(uint8_t byte)
{
    constexpr uint32_t kRoom = 1u << 1;
    while ((at(kSpiStatus) & kRoom) == 0) {
    }
    at(kSpiData) = byte;
}

void send(const uint8_t* bytes, uint32_t count)
{
    constexpr uint32_t kOn = 1u, kStepThroughMemory = 1u << 4, kAskedBySpi0 = 16u << 15;
    while ((at(kDmaControl) & kBusy) != 0) {
    }
    at(kDma) = reinterpret_cast<uint32_t>(bytes);
    at(kDma + 0x04) = kSpiData;
    at(kDma + 0x08) = count;
    at(kDmaControl) = kOn | kStepThroughMemory | kAskedBySpi0;
}

void wait()
{
    constexpr uint32_t kSending = 1u << 4;
    while ((at(kDmaControl) & kBusy) != 0) {
    }
    while ((at(kSpiStatus) & kSending) != 0) {
    }
}

}  // namespace bus
