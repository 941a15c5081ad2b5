// SPDX-License-Identifier: MIT
// A JSON text as a tree that remembers the line of every value, for messages. // and /* */ comments are allowed.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "math/vec3.h"
#include "util/text_lines.h"

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

struct NumberRange {
    double low, high;
};

// Takes the members of a JSON object one by one, checks them, and in the end refuses those that nobody asked for.
// Every method throws SceneError with file and line. A reader lives shorter than the file name and the value.
class JsonMembers
{
public:
    // `what` names the object in messages, such as "a light".
    JsonMembers(const std::string& file, const JsonValue& object, std::string what);

    const JsonValue* find(const std::string& name);  // null if absent
    const JsonValue& require(const std::string& name);

    // Leave `value` as it is if the member is absent.
    void number(const std::string& name, const NumberRange& range, double& value);
    void number(const std::string& name, const NumberRange& range, float& value);
    void vector(const std::string& name, const NumberRange& range, Vec3& value);
    // Takes three numbers, or one for grey.
    void colour(const std::string& name, const NumberRange& range, Rgb& value);
    std::string text(const std::string& name);  // required
    // Returns the place of the text in `words`, and `fallback` if it is absent.
    size_t choice(const std::string& name, const std::vector<std::string>& words, size_t fallback);

    // Refuses members that no call has named.
    void finish() const;

    [[noreturn]] void fail(const JsonValue& where, const std::string& text) const;
    const JsonValue& object() const { return object_; }

    // These check values that are no members in the same way.
    double number_of(const JsonValue& value, const std::string& name, const NumberRange& range) const;
    Rgb colour_of(const JsonValue& value, const std::string& name, const NumberRange& range) const;
    Vec3 vector_of(const JsonValue& value, const std::string& name, const NumberRange& range) const;
    std::string text_of(const JsonValue& value, const std::string& name) const;

private:
    const std::string& file_;
    const JsonValue& object_;
    std::string what_;
    std::set<std::string> known_;
};

}  // namespace lumi::baker
