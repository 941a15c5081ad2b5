// SPDX-License-Identifier: MIT
#include "proxy/proxy_cache.h"

namespace lumi::baker
{

ProxyCache::ProxyCache() : contents_(std::make_unique<Contents>()) {}

ProxyCache::~ProxyCache() = default;

}  // namespace lumi::baker
