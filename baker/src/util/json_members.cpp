// SPDX-License-Identifier: MIT
#include "util/json_members.h"

#include <algorithm>

#include "lumi/baker/scene.h"

namespace lumi::baker
{

JsonMembers::JsonMembers(const std::string& file, const JsonValue& object, std::string what)
    : file_(file), object_(object), what_(std::move(what))
{
    if (object.kind != JsonValue::Kind::object) fail(object, what_ + " must be an object; write { ... }");
}

void JsonMembers::fail(const JsonValue& where, const std::string& text) const
{
    throw SceneError(at({file_, where.line}, text));
}

const JsonValue* JsonMembers::find(const std::string& name)
{
    known_.insert(name);
    const auto& members = object_.members;
    const auto found = std::find_if(members.begin(), members.end(), [&](const auto& m) { return m.first == name; });
    return found == members.end() ? nullptr : &found->second;
}

const JsonValue& JsonMembers::require(const std::string& name)
{
    const JsonValue* value = find(name);
    if (!value) fail(object_, what_ + " has no '" + name + "'; add it");
    return *value;
}

double JsonMembers::number_of(const JsonValue& value, const std::string& name, const NumberRange& range) const
{
    if (value.kind != JsonValue::Kind::number)
        fail(value, "'" + name + "' of " + what_ + " must be a number; correct it");
    if (!(value.number >= range.low && value.number <= range.high)) {
        fail(value, "'" + name + "' of " + what_ + " is " + number_text(value.number) + "; choose it from " +
                        number_text(range.low) + " to " + number_text(range.high));
    }
    return value.number;
}

Vec3 JsonMembers::vector_of(const JsonValue& value, const std::string& name, const NumberRange& range) const
{
    if (value.kind != JsonValue::Kind::list || value.items.size() != 3)
        fail(value, "'" + name + "' of " + what_ + " must be three numbers; write [x, y, z]");
    float v[3];
    for (size_t k = 0; k < 3; ++k) v[k] = static_cast<float>(number_of(value.items[k], name, range));
    return {v[0], v[1], v[2]};
}

Rgb JsonMembers::colour_of(const JsonValue& value, const std::string& name, const NumberRange& range) const
{
    if (value.kind == JsonValue::Kind::number) return grey(static_cast<float>(number_of(value, name, range)));
    if (value.kind != JsonValue::Kind::list || value.items.size() != 3)
        fail(value, "'" + name + "' of " + what_ + " must be a colour; write [r, g, b], or one number for grey");
    const Vec3 v = vector_of(value, name, range);
    return {v.x, v.y, v.z};
}

std::string JsonMembers::text_of(const JsonValue& value, const std::string& name) const
{
    if (value.kind != JsonValue::Kind::text)
        fail(value, "'" + name + "' of " + what_ + " must be a text; put it in quotes");
    return value.text;
}

void JsonMembers::number(const std::string& name, const NumberRange& range, double& value)
{
    const JsonValue* found = find(name);
    value = found ? number_of(*found, name, range) : value;
}

void JsonMembers::number(const std::string& name, const NumberRange& range, float& value)
{
    const JsonValue* found = find(name);
    value = found ? static_cast<float>(number_of(*found, name, range)) : value;
}

void JsonMembers::vector(const std::string& name, const NumberRange& range, Vec3& value)
{
    const JsonValue* found = find(name);
    value = found ? vector_of(*found, name, range) : value;
}

void JsonMembers::colour(const std::string& name, const NumberRange& range, Rgb& value)
{
    const JsonValue* found = find(name);
    value = found ? colour_of(*found, name, range) : value;
}

std::string JsonMembers::text(const std::string& name)
{
    return text_of(require(name), name);
}

size_t JsonMembers::choice(const std::string& name, const std::vector<std::string>& words, size_t fallback)
{
    const JsonValue* value = find(name);
    if (!value) return fallback;
    const std::string word = text_of(*value, name);
    const auto found = std::find(words.begin(), words.end(), word);
    if (found == words.end())
        fail(*value, "'" + name + "' of " + what_ + " is '" + word + "'; choose one of: " + joined(words, ", "));
    return static_cast<size_t>(found - words.begin());
}

void JsonMembers::finish() const
{
    for (const auto& [name, value] : object_.members) {
        if (known_.count(name) == 0) {
            fail(value,
                 what_ + " knows no '" + name + "'; choose among: " + joined({known_.begin(), known_.end()}, ", "));
        }
    }
}

}  // namespace lumi::baker
