// SPDX-License-Identifier: MIT
#include "st7789.h"

#include "bus.h"
#include "rp2040.h"

namespace st7789
{
namespace
{

void command(uint8_t code)
{
    bus::wait();
    bus::take_command();
    bus::put(code);
    bus::wait();
    bus::take_data();
}

enum Command : uint8_t {
    kSoftwareReset = 0x01,
    kSleepOut = 0x11,
    kInvert = 0x21,  // these panels are made inverted
    kDisplayOn = 0x29,
    kColumns = 0x2A,
    kRows = 0x2B,
    kWritePixels = 0x2C,
    kScanOrder = 0x36,
    kPixelFormat = 0x3A,
};

void command(Command code, uint8_t value)
{
    command(code);
    bus::put(value);
}

void set_range(Command code, uint8_t last)
{
    const uint8_t bytes[] = {0, 0, 0, last};
    command(code);
    for (const uint8_t byte : bytes) bus::put(byte);
}

}  // namespace

void start()
{
    constexpr uint32_t kAfterReset = 120000, kAfterSleep = 5000;  // microseconds, of the controller's datasheet
    bus::start();
    command(kSoftwareReset);
    bus::wait();
    rp2040::wait_microseconds(kAfterReset);
    command(kSleepOut);
    rp2040::wait_microseconds(kAfterSleep);
    command(kPixelFormat, 0x55);  // 16 bits
    command(kScanOrder, 0);
    command(kInvert);
    set_range(kColumns, 239);
    set_range(kRows, 239);
    command(kDisplayOn);
}

void begin_picture()
{
    command(kWritePixels);
}

void send(const uint8_t* bytes, uint32_t count)
{
    bus::send(bytes, count);
}

void wait()
{
    bus::wait();
}

}  // namespace st7789
