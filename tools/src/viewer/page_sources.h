// SPDX-License-Identifier: MIT
// The files of page/, as texts: page_sources.cpp.in.
#pragma once

namespace lumi::tools
{

extern const char kPageHtml[], kPageCss[], kPageScript[];

}  // namespace lumi::tools
