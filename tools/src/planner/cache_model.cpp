// SPDX-License-Identifier: MIT
#include "planner/cache_model.h"

#include <algorithm>

namespace lumi::planner
{
namespace
{

constexpr uint32_t kEmpty = 0xFFFFFFFF;  // no line has this number: addresses are bytes, lines hold several

}  // namespace

CacheModel::CacheModel(const CacheShape& shape) : shape_(shape), lines_(size_t{shape.bytes / shape.line_bytes}, kEmpty)
{
}

void CacheModel::read(const Read& read)
{
    const uint32_t last = (read.address + read.bytes - 1) / shape_.line_bytes;
    for (uint32_t line = read.address / shape_.line_bytes; line <= last; ++line) touch(line);
}

void CacheModel::touch(uint32_t line)
{
    const auto set = lines_.begin() + static_cast<std::ptrdiff_t>(size_t{line % shape_.sets()} * shape_.ways);
    const auto end = set + static_cast<std::ptrdiff_t>(shape_.ways);
    auto found = std::find(set, end, line);
    if (found == end) {
        ++misses_;
        touched_.insert(line);
        found = end - 1;
    }
    std::copy_backward(set, found, found + 1);
    *set = line;
}

AllTraffic traffic_of(const std::vector<Read>& reads)
{
    AllTraffic traffic;
    for (size_t i = 0; i < traffic.size(); ++i) {
        CacheModel cache(kChipList[i].cache);
        for (const Read& read : reads) cache.read(read);
        traffic[i] = {cache.lines_touched(), cache.misses()};
    }
    return traffic;
}

}  // namespace lumi::planner
