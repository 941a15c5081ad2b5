// SPDX-License-Identifier: MIT
#include "files/embed_purpose.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "files/output_file.h"
#include "terminal/failure.h"
#include "terminal/text.h"

namespace lumi::tools
{

namespace
{

namespace fs = std::filesystem;

constexpr char kServes[] = ". For ";

// The endings of the outputs that one form of a header serves.
const char* endings_of(EmbedKind kind)
{
    switch (kind) {
        case EmbedKind::assembler:
        case EmbedKind::cpp:
            return ".S .s .cpp";
        case EmbedKind::array:
            return ".c";
        case EmbedKind::flashed:
            return ".bin .uf2";
    }
    return "";
}

// The first output that a header's purpose names and that lies beside it, but for `output` itself; empty: there is
// none.
fs::path served_by(const fs::path& header, const std::string& purpose, const fs::path& output)
{
    const size_t at = purpose.rfind(kServes);
    if (at == std::string::npos) return {};
    std::istringstream endings(purpose.substr(at + sizeof kServes - 1));
    for (std::string ending; endings >> ending;) {
        const fs::path other = fs::path(header).replace_extension(ending);
        std::error_code ignored;
        if (other.filename() != output.filename() && fs::exists(other, ignored)) return other;
    }
    return {};
}

}  // namespace

std::string embed_purpose(const std::string& field, const std::string& symbol, EmbedKind kind,
                          std::optional<uint32_t> address)
{
    std::string text = "Field " + field + ", symbol " + symbol;
    if (address) text += ", flashed at " + address_text(*address);
    return text + kServes + endings_of(kind);
}

void require_same_purpose(const std::string& header, const std::string& output, const std::string& purpose)
{
    std::error_code ignored;
    if (fs::exists(header, ignored) && !fs::is_regular_file(header, ignored))
        throw Failure(header, "is a folder, a device or a pipe", "choose another name for " + output);
    std::ifstream file(header);
    std::string first, old_purpose;
    if (!std::getline(file, first)) return;
    if (first.rfind(kSourceMark, 0) != 0)
        throw Failure(header, "`lumi embed` did not write it and would replace it",
                      "choose another name for " + output + ", or remove that header");
    std::getline(file, old_purpose);
    if (old_purpose.find(purpose + " */") != std::string::npos) return;
    const fs::path other = served_by(header, old_purpose.substr(0, old_purpose.rfind(" */")), output);
    if (!other.empty())
        throw Failure(header, "serves " + other.string() + ", which it would no longer fit",
                      "choose another name for " + output + ", or remove " + other.string());
}

}  // namespace lumi::tools
