// SPDX-License-Identifier: MIT
#include "model/readers.h"

#include <cmath>
#include <cstring>

#include "lumi/baker/scene.h"
#include "model/facets.h"
#include "util/text_lines.h"

namespace lumi::baker
{
namespace
{

// A binary file: a heading, the number of facets, and of each a normal, three corners and two bytes.
constexpr size_t kCountAt = 80, kFirstFacet = 84, kFacetBytes = 50, kNormalBytes = 12;

uint32_t count_in(std::string_view bytes)
{
    uint32_t count = 0;
    for (size_t k = 4; k-- > 0;) count = count << 8 | static_cast<uint8_t>(bytes[kCountAt + k]);
    return count;
}

size_t size_of_binary(uint32_t count)
{
    return kFirstFacet + kFacetBytes * size_t{count};
}

bool is_binary(std::string_view head, size_t bytes)
{
    return head.size() >= kFirstFacet && count_in(head) != 0 && size_of_binary(count_in(head)) == bytes;
}

float float_at(const char* bytes)
{
    uint32_t bits = 0;
    for (size_t k = 4; k-- > 0;) bits = bits << 8 | static_cast<uint8_t>(bytes[k]);
    float value = 0;
    static_assert(sizeof value == sizeof bits);
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

class StlReader
{
public:
    explicit StlReader(const std::filesystem::path& file) : file_(file.string()) {}

    Facets read(const std::string& bytes)
    {
        const bool text = !is_binary(bytes, bytes.size()) && bytes.find('\0') == std::string::npos &&
                          bytes.find("solid") != std::string::npos;
        text ? read_text(bytes) : read_binary(bytes);
        if (facets_.triangles.empty())
            throw SceneError(at({file_}, "there is no facet in it; export at least one body"));
        return std::move(facets_);
    }

private:
    void read_binary(std::string_view bytes)
    {
        if (bytes.size() < kFirstFacet) short_of(bytes.size(), kFirstFacet);
        const uint32_t count = count_in(bytes);
        if (bytes.size() < size_of_binary(count)) short_of(bytes.size(), size_of_binary(count));
        for (size_t f = 0; f < count; ++f) {
            const char* corner = bytes.data() + size_of_binary(static_cast<uint32_t>(f)) + kNormalBytes;
            for (size_t k = 0; k < 3; ++k, corner += 3 * sizeof(float)) add(point_at(corner, f));
            close();
        }
    }

    [[noreturn]] void short_of(size_t has, size_t needs) const
    {
        throw SceneError(at({file_}, "the file is cut short or no STL: it has " + std::to_string(has) +
                                         " bytes and needs " + std::to_string(needs) + "; copy or export it again"));
    }

    void read_text(const std::string& text)
    {
        bool open = false;
        uint32_t last = 0;
        Lines lines(text);
        for (Line line; lines.next(line);) {
            last = line.number;
            line.keyword = in_small_letters(line.keyword);
            if (line.keyword == "solid" || line.keyword == "endsolid")
                open = line.keyword == "solid";
            else if (line.keyword == "vertex")
                take_vertex(line);
            else if (line.keyword == "endloop")
                take_loop(line);
            else if (line.keyword != "facet" && line.keyword != "outer" && line.keyword != "endfacet")
                fail(line, "'" + line.keyword + "' is no word of an STL text; export it again");
        }
        if (open || corners_ != 0)
            throw SceneError(at({file_, last}, "the file ends before 'endsolid', it is cut short; export it again"));
    }

    void take_vertex(const Line& line)
    {
        const std::vector<double> p = numbers_of({file_, line.number}, line, 3, 3, kMaxCoordinate);
        add({p[0], p[1], p[2]});
    }

    void take_loop(const Line& line)
    {
        if (corners_ != 3)
            fail(line, "a facet of " + std::to_string(corners_) + " corners, STL has three; export it again");
        close();
    }

    [[noreturn]] void fail(const Line& line, const std::string& text) const
    {
        throw SceneError(at({file_, line.number}, text));
    }

    Point point_at(const char* bytes, size_t facet) const
    {
        Point p{};
        for (size_t k = 0; k < p.size(); ++k) {
            p[k] = static_cast<double>(float_at(bytes + k * sizeof(float)));
            if (!(std::abs(p[k]) <= kMaxCoordinate)) {
                throw SceneError(at({file_}, "facet " + std::to_string(facet + 1) +
                                                 " has a coordinate that is not finite or above " +
                                                 number_text(kMaxCoordinate) + "; export it again"));
            }
        }
        return p;
    }

    void add(const Point& p)
    {
        facets_.positions.push_back(p);
        ++corners_;
    }

    void close()
    {
        const uint32_t end = static_cast<uint32_t>(facets_.positions.size());
        facets_.triangles.push_back({end - 3, end - 2, end - 1});
        corners_ = 0;
    }

    std::string file_;
    Facets facets_;
    uint32_t corners_ = 0;  // the facet that is open has so many
};

}  // namespace

bool is_stl(std::string_view head, size_t file_bytes)
{
    const bool text = head.substr(0, 5) == "solid" && head.find("facet") != std::string_view::npos;
    return text || is_binary(head, file_bytes);
}

SceneParts read_stl(const std::filesystem::path& file, std::vector<std::string>& warnings)
{
    Losses losses;
    SceneParts parts = parts_of_facets(file, StlReader(file).read(read_file(file)), losses);
    parts.up = UpAxis::z;
    losses.report(file, warnings);
    return parts;
}

}  // namespace lumi::baker
