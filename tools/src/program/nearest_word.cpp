// SPDX-License-Identifier: MIT
#include "program/nearest_word.h"

#include <algorithm>
#include <numeric>

namespace lumi::tools
{

namespace
{

// Wagner and Fischer's table, a row at a time.
size_t edits_between(const std::string& a, const std::string& b)
{
    std::vector<size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), size_t{0});
    for (size_t i = 0; i < a.size(); ++i) {
        size_t diagonal = row[0];
        row[0] = i + 1;
        for (size_t j = 0; j < b.size(); ++j) {
            const size_t exchanged = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({exchanged, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

std::string nearest_word(const std::string& typed, const std::vector<std::string>& words)
{
    constexpr size_t kLettersPerEdit = 3;
    size_t least = std::max<size_t>(1, typed.size() / kLettersPerEdit) + 1;
    std::string nearest;
    for (const std::string& word : words)
        if (const size_t edits = edits_between(typed, word); edits < least) {
            least = edits;
            nearest = word;
        }
    return nearest;
}

}  // namespace lumi::tools
