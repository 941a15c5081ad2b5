// SPDX-License-Identifier: MIT
// Takes the members of a JSON object one by one, checks them, and in the end refuses those that nobody asked for.
#pragma once

#include <functional>
#include <set>

#include "math/vec3.h"
#include "util/json_text.h"
#include "util/text_lines.h"

namespace lumi::baker
{

struct NumberRange {
    double low, high;
};

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
    // Three numbers, or one for grey.
    void colour(const std::string& name, const NumberRange& range, Rgb& value);
    std::string text(const std::string& name);  // required
    // The place of the text in `words`; `fallback` if absent.
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
