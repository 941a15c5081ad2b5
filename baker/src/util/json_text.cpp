// SPDX-License-Identifier: MIT
// The one file of the baker that sees nlohmann-json.
#include "util/json_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "lumi/baker/scene.h"
#include "util/text_lines.h"

namespace lumi::baker
{

namespace
{

constexpr size_t kMaxDepth = 32;

// Feeds the parser and counts what it has read. It reads one character past a number, so the line of a value is that of
// the last character but one.
class CountedText
{
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountedText(const char* position, const char** furthest) : position_(position), furthest_(furthest) {}
    const char& operator*() const { return *position_; }
    CountedText& operator++()
    {
        *furthest_ = ++position_;
        return *this;
    }
    bool operator==(const CountedText& other) const { return position_ == other.position_; }
    bool operator!=(const CountedText& other) const { return position_ != other.position_; }

private:
    const char* position_;
    const char** furthest_;
};

class TreeBuilder : public nlohmann::json_sax<nlohmann::json>
{
public:
    TreeBuilder(const std::string& file, const char* begin, const char** furthest)
        : file_(file), counted_(begin), furthest_(furthest)
    {
    }

    bool null() override { return put({}); }
    bool boolean(bool value) override { return put_number(JsonValue::Kind::boolean, value ? 1 : 0); }
    bool number_integer(number_integer_t value) override { return put_double(static_cast<double>(value)); }
    bool number_unsigned(number_unsigned_t value) override { return put_double(static_cast<double>(value)); }
    bool number_float(number_float_t value, const string_t&) override { return put_double(value); }
    bool string(string_t& value) override
    {
        JsonValue v;
        v.kind = JsonValue::Kind::text;
        v.text = value;
        return put(std::move(v));
    }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(JsonValue::Kind::object); }
    bool start_array(std::size_t) override { return open(JsonValue::Kind::list); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override
    {
        if (!names_.back().insert(name).second)
            throw SceneError(at({file_, line()}, "'" + name + "' is given twice; remove one"));
        open_.back().members.emplace_back(name, JsonValue{});
        return true;
    }

    bool parse_error(std::size_t, const std::string& token, const nlohmann::detail::exception& e) override
    {
        const std::string what = e.what();
        const size_t reason = what.rfind("; ");
        const std::string last = token.substr(0, 40);
        throw SceneError(at({file_, line()}, "this is no JSON near '" + printable(last) + "' (" +
                                                 (reason == std::string::npos ? "syntax" : what.substr(reason + 2)) +
                                                 "); look for a missing comma, quote or bracket"));
    }

    JsonValue take() { return std::move(root_); }

private:
    static std::string printable(const std::string& text)
    {
        std::string result;
        std::copy_if(text.begin(), text.end(), std::back_inserter(result), [](char c) { return c >= ' ' && c <= '~'; });
        return result;
    }

    uint32_t line()
    {
        const char* last = std::max(*furthest_ - 1, counted_);
        line_ += static_cast<uint32_t>(std::count(counted_, last, '\n'));
        counted_ = last;
        return line_;
    }

    bool put_number(JsonValue::Kind kind, double value)
    {
        JsonValue v;
        v.kind = kind;
        v.number = value;
        return put(std::move(v));
    }
    bool put_double(double value) { return put_number(JsonValue::Kind::number, value); }

    bool put(JsonValue value)
    {
        value.line = value.line ? value.line : line();
        if (open_.empty())
            root_ = std::move(value);
        else if (open_.back().kind == JsonValue::Kind::list)
            open_.back().items.push_back(std::move(value));
        else
            open_.back().members.back().second = std::move(value);
        return true;
    }

    bool open(JsonValue::Kind kind)
    {
        if (open_.size() == kMaxDepth)
            throw SceneError(at({file_, line()}, "brackets nest too deeply; no scene needs that, check the file"));
        JsonValue v;
        v.kind = kind;
        v.line = line();
        open_.push_back(std::move(v));
        names_.emplace_back();
        return true;
    }

    bool close()
    {
        JsonValue v = std::move(open_.back());
        open_.pop_back();
        names_.pop_back();
        return put(std::move(v));
    }

    std::string file_;
    const char* counted_;
    const char** furthest_;
    uint32_t line_ = 1;
    std::vector<JsonValue> open_;
    std::vector<std::unordered_set<std::string>> names_;  // the names of the members of each open value
    JsonValue root_;
};

}  // namespace

JsonValue parse_json(const std::string& file, const std::string& text)
{
    const char* furthest = text.data();
    TreeBuilder builder(file, text.data(), &furthest);
    nlohmann::json::sax_parse(CountedText(text.data(), &furthest), CountedText(text.data() + text.size(), &furthest),
                              &builder, nlohmann::json::input_format_t::json, true, true);
    return builder.take();
}

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
