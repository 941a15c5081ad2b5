// SPDX-License-Identifier: MIT
// Holds the files of page/ as texts: page_sources.cpp.in.
#pragma once

namespace lumi::tools
{

extern const char kPageHtml[], kPageCss[], kPageScript[];

}  // namespace lumi::tools
