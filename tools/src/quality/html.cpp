// SPDX-License-Identifier: MIT
#include "quality/html.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "image/png.h"
#include "terminal/text.h"

namespace lumi::quality
{

std::string escaped(std::string text)
{
    for (const auto& [sign, word] : {std::pair("&", "&amp;"), {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}})
        text = tools::replaced(std::move(text), sign, word);
    return text;
}

std::string base64(std::string_view bytes)
{
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        const size_t count = std::min<size_t>(3, bytes.size() - i);
        uint32_t group = 0;
        for (size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? static_cast<uint32_t>(static_cast<uint8_t>(bytes[i + k])) : 0u);
        for (size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

std::string image_tag(const tools::Picture& picture, std::string_view alternative_text)
{
    return "<img loading=\"lazy\" width=\"" + std::to_string(picture.width_px) + "\" height=\"" +
           std::to_string(picture.height_px) + "\" alt=\"" + escaped(std::string(alternative_text)) +
           "\" src=\"data:image/png;base64," + base64(tools::png_bytes(picture)) + "\">";
}

}  // namespace lumi::quality
