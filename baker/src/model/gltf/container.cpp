// SPDX-License-Identifier: MIT
#include "model/gltf/container.h"

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

#include "lumi/baker/scene.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

constexpr std::string_view kMagic = "glTF";
constexpr size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;
constexpr size_t kMaxJsonBytes = size_t{1} << 28;
constexpr size_t kMaxJsonObjects = 4'000'000;  // each takes the parser up to 1 kB
constexpr size_t kMaxJsonDepth = 64;

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& text)
{
    throw SceneError(at({file.string()}, text));
}

size_t number_at(std::string_view bytes, size_t place)
{
    size_t value = 0;
    for (size_t k = 4; k-- > 0;) value = value << 8 | static_cast<uint8_t>(bytes[place + k]);
    return value;
}

// The JSON of a GLB whose chunks all lie inside it.
std::string_view json_of_glb(const std::filesystem::path& file, std::string_view bytes)
{
    const auto short_of = [&](size_t end) {
        if (bytes.size() < end)
            fail(file, "the file is cut short: it has " + std::to_string(bytes.size()) + " bytes and needs " +
                           std::to_string(end) + "; copy or export it again");
    };
    short_of(kHeaderBytes + kChunkHeaderBytes);
    if (number_at(bytes, 4) == 1)
        fail(file, "this is glTF 1.0, only 2.0 is read; open it in a program such as Blender and export glTF 2.0");
    short_of(number_at(bytes, 8));
    const size_t length = number_at(bytes, kHeaderBytes);
    size_t begin = kHeaderBytes;
    do {  // the first chunk has to be there, even if the header says that the file is shorter
        const size_t end = begin + kChunkHeaderBytes + number_at(bytes, begin);
        if (end > number_at(bytes, 8)) fail(file, "a chunk reaches beyond the file's end; export it again");
        begin = end;
    } while (begin + kChunkHeaderBytes <= number_at(bytes, 8));
    return bytes.substr(kHeaderBytes + kChunkHeaderBytes, length);
}

// Counts brackets outside of texts.
void check_json(const std::filesystem::path& file, std::string_view json)
{
    size_t depth = 0, objects = 0;
    bool in_text = false;
    for (size_t k = 0; k < json.size(); ++k) {
        const char c = json[k];
        if (in_text) {
            k += c == '\\' ? 1u : 0u;
            in_text = c != '"';
        } else if (c == '"') {
            in_text = true;
        } else if (c == '{' || c == '[') {
            if (++depth > kMaxJsonDepth) fail(file, "its JSON nests too deeply; no model needs that, check the file");
            if (++objects > kMaxJsonObjects)
                fail(file, "it has more than " + std::to_string(kMaxJsonObjects) + " parts; join meshes and materials");
        } else if (c == '}' || c == ']') {
            depth -= depth > 0 ? 1u : 0u;
        }
    }
}

// By its first character, and by what no text holds.
bool is_json_object(const std::string& bytes)
{
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF", kBlanks = " \t\r\n";
    const bool has_mark = bytes.compare(0, kByteOrderMark.size(), kByteOrderMark) == 0;
    const size_t first = bytes.find_first_not_of(kBlanks, has_mark ? kByteOrderMark.size() : 0);
    return first != std::string::npos && bytes[first] == '{' && bytes.find('\0') == std::string::npos;
}

}  // namespace

bool is_glb(std::string_view bytes)
{
    return bytes.substr(0, kMagic.size()) == kMagic;
}

namespace
{

constexpr const char* kMeshopt = "EXT_meshopt_compression";
constexpr const char* kDraco = "KHR_draco_mesh_compression";

// Calls take() for each object in a list that is a member.
template <class Take>
void for_each_object(nlohmann::json& parent, const char* member, const Take& take)
{
    if (!parent.contains(member) || !parent[member].is_array()) return;
    for (nlohmann::json& item : parent[member])
        if (item.is_object()) take(item);
}

void fill_fallback(nlohmann::json& buffer)
{
    const nlohmann::json::json_pointer fallback(std::string("/extensions/") + kMeshopt + "/fallback");
    if (buffer.contains("uri") || !buffer.contains(fallback) || buffer[fallback] != true) return;
    buffer["uri"] = "data:application/octet-stream;base64,AAAA";
    buffer["byteLength"] = 3;
}

}  // namespace

std::string plain_for_parser(const std::string& bytes)
{
    if (bytes.find(kMeshopt) == std::string::npos && bytes.find(kDraco) == std::string::npos) return bytes;
    const bool in_chunk = is_glb(bytes);
    const size_t begin = in_chunk ? kHeaderBytes + kChunkHeaderBytes : 0;
    const size_t length = in_chunk ? number_at(bytes, kHeaderBytes) : bytes.size();
    nlohmann::json root = nlohmann::json::parse(bytes.substr(begin, length), nullptr, false);
    if (!root.is_object()) return bytes;
    for_each_object(root, "buffers", fill_fallback);
    for_each_object(root, "meshes", [](nlohmann::json& mesh) {
        for_each_object(mesh, "primitives", [](nlohmann::json& primitive) {
            if (primitive.contains(nlohmann::json::json_pointer(std::string("/extensions/") + kDraco)))
                primitive.erase("indices");
        });
    });
    std::string text = root.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    if (!in_chunk) return text;
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::string rest = bytes.substr(begin + length);
    const auto word = [](size_t value) {
        std::string four;
        for (unsigned shift = 0; shift < 32; shift += 8) four += static_cast<char>(value >> shift & 0xFF);
        return four;
    };
    return bytes.substr(0, 8) + word(begin + text.size() + rest.size()) + word(text.size()) +
           bytes.substr(kHeaderBytes + 4, 4) + text + rest;
}

void check_gltf_container(const std::filesystem::path& file, const std::string& bytes)
{
    if (bytes.size() > std::numeric_limits<uint32_t>::max())
        fail(file, "a glTF file has less than 4 GiB; split or simplify the model");
    const std::string_view json = is_glb(bytes) ? json_of_glb(file, bytes) : bytes;
    if (json.size() > kMaxJsonBytes) {
        fail(file, "its text has " + std::to_string(json.size()) + " bytes, at most " + std::to_string(kMaxJsonBytes) +
                       " are read; export it as .glb, which keeps meshes and pictures out of the text");
    }
    if (!is_glb(bytes) && !is_json_object(bytes)) fail(file, "this is neither glTF nor GLB; export it again as .glb");
    check_json(file, json);
}

}  // namespace lumi::baker
