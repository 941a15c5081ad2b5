// SPDX-License-Identifier: MIT
// Bytes at an address divisible by 4 in an allocation of their own, so that a sanitizer sees a read past the end.
#pragma once

#include <cstring>
#include <memory>

#include "field_bytes.h"

namespace lumi::test
{

class AlignedCopy
{
public:
    explicit AlignedCopy(const Bytes& bytes) : memory_(new uint8_t[bytes.size()]), size_(bytes.size())
    {
        std::memcpy(memory_.get(), bytes.data(), bytes.size());
    }

    const uint8_t* data() const { return memory_.get(); }
    size_t size() const { return size_; }

private:
    std::unique_ptr<uint8_t[]> memory_;
    size_t size_;
};

}  // namespace lumi::test
