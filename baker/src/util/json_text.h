// SPDX-License-Identifier: MIT
// A JSON text as a tree that remembers the line of every value, for messages. // and /* */ comments are allowed.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace lumi::baker
{

struct JsonValue {
    enum class Kind : uint8_t { null, boolean, number, text, list, object };

    Kind kind = Kind::null;
    uint32_t line = 0;  // where the value ends; where the list or object begins
    double number = 0;  // boolean: 0 or 1
    std::string text;
    std::vector<JsonValue> items;                            // a list's
    std::vector<std::pair<std::string, JsonValue>> members;  // an object's, in the file's order; no name occurs twice
};

// `file` only serves messages. Throws SceneError for anything that is no JSON, names a member twice, or nests deeper
// than any scene does.
JsonValue parse_json(const std::string& file, const std::string& text);

}  // namespace lumi::baker
