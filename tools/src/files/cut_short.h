// SPDX-License-Identifier: MIT
// A mapped file that another program cuts short: reading what is gone raises SIGBUS. This gives it words and exit
// code 1.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace lumi::tools
{

// While one lives, a fault in these bytes ends the process with a message that names the file. Nothing half-written can
// be left: outputs get their names when they are whole.
class CutShortWatch
{
public:
    CutShortWatch(const std::string& path, const uint8_t* bytes, size_t size);
    ~CutShortWatch();
    CutShortWatch(const CutShortWatch&) = delete;
    CutShortWatch& operator=(const CutShortWatch&) = delete;

private:
    size_t place_;
};

}  // namespace lumi::tools
