// SPDX-License-Identifier: MIT
// Which word a user may have meant.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace lumi::host
{

// Wagner and Fischer's table; letters that changed places are one edit, as Damerau counts them.
inline size_t edits_between(const std::string& a, const std::string& b)
{
    std::vector<std::vector<size_t>> edits(a.size() + 1, std::vector<size_t>(b.size() + 1));
    for (size_t i = 0; i <= a.size(); ++i) {
        for (size_t j = 0; j <= b.size(); ++j) {
            size_t& least = edits[i][j] = std::max(i, j);
            if (i == 0 || j == 0) continue;
            const size_t exchanged = edits[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            least = std::min({exchanged, edits[i][j - 1] + 1, edits[i - 1][j] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                least = std::min(least, edits[i - 2][j - 2] + 1);
        }
    }
    return edits.back().back();
}

// Finds the word that fewest edits of a letter lead to (put in, left out, exchanged, or two that changed places): at
// most one for three letters, though one is always allowed. Empty if none is that near; the first of several.
inline std::string nearest_word(const std::string& typed, const std::vector<std::string>& words)
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

// " (did you mean --orbit?)" where one of the words is near, or nothing.
inline std::string meant(const std::string& typed, const std::vector<std::string>& words)
{
    const std::string nearest = nearest_word(typed, words);
    return nearest.empty() ? "" : " (did you mean " + nearest + "?)";
}

}  // namespace lumi::host
