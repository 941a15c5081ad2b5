// SPDX-License-Identifier: MIT
// The pictures and meshes that `lumi inspect -o` writes, of fields whose every byte is known.
#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <sstream>

#include "image/picture.h"
#include "image/picture_file.h"
#include "support/program.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"
#include "surface/see_through_bytes.h"

namespace lumi::tools
{

using test::lumi;
using test::Outcome;

namespace
{

using Colour = std::array<int, 3>;
constexpr Colour kEmpty = {32, 36, 40};
constexpr lumi::test::TestGlass kInspectedGlass = {{60, 20, 40}, {128, 64, 192}};
constexpr uint8_t kInspectedSquare = 200, kInspectedPane = 7;

Colour colour_at(const Picture& picture, int x, int y)
{
    const uint8_t* pixel = picture.pixel(x, y);
    return {pixel[0], pixel[1], pixel[2]};
}

std::map<Colour, int> pixels_by_colour(const Picture& picture)
{
    std::map<Colour, int> counts;
    for (int y = 0; y < picture.height_px; ++y)
        for (int x = 0; x < picture.width_px; ++x) ++counts[colour_at(picture, x, y)];
    return counts;
}

// These belong to surface_palette_section().
Colour entry(int k)
{
    return {k, 255 - k, 40 + k / 2 + 64 * (k & 1)};
}

void write(const std::string& path, const lumi::test::Bytes& bytes)
{
    test::write_content(path, std::string(bytes.begin(), bytes.end()));
}

// A square, and a smaller pane above it.
void write_panes(const std::string& path)
{
    lumi::test::GlassPalette palette{};
    palette[kInspectedPane] = kInspectedGlass;
    write(path, lumi::test::see_through_file(
                    lumi::test::panes({{8000, -4000, kInspectedSquare}, {4000, 4000, kInspectedPane}}), 1, palette));
}

void succeed(const test::Arguments& call)
{
    const Outcome outcome = lumi(call);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    CHECK_THAT(outcome.out, Catch::Contains("CRC-32"));
}

Picture picture_of(const test::TemporaryFolder& folder)
{
    succeed({"inspect", folder / "f.lumi", "-o", folder / "f.png"});
    return read_png(folder / "f.png");
}

using Place = std::array<double, 3>;

struct Mesh {
    std::vector<Place> vertices;
    std::map<std::string, std::vector<std::array<size_t, 3>>> groups;
};

Mesh mesh_of(const test::TemporaryFolder& folder, const std::string& up)
{
    succeed({"inspect", folder / "f.lumi", "-o", folder / "f.obj", "--up", up});
    Mesh mesh;
    std::istringstream lines(test::content_of(folder / "f.obj"));
    std::string group;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        Place p{};
        std::array<size_t, 3> face{};
        if (kind == "v" && words >> p[0] >> p[1] >> p[2]) mesh.vertices.push_back(p);
        if (kind == "g") words >> group;
        if (kind == "f" && words >> face[0] >> face[1] >> face[2]) mesh.groups[group].push_back(face);
    }
    return mesh;
}

// Twice its area, along an axis.
double facing(const Mesh& mesh, const std::array<size_t, 3>& face, size_t axis)
{
    const size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Place &a = mesh.vertices.at(face[0] - 1), &b = mesh.vertices.at(face[1] - 1),
                &c = mesh.vertices.at(face[2] - 1);
    return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
}

std::string chord_file(const test::TestField& field, const std::string& texels)
{
    return test::file_bytes(
        {{detail::format::kLayoutSection, test::layout_bytes(field)}, {detail::format::kTexelSection, texels}});
}

void check_refused(const test::Arguments& call, int code, const std::string& words)
{
    const Outcome outcome = lumi(call);
    INFO(outcome.err);
    CHECK(outcome.code == code);
    CHECK_THAT(outcome.err, Catch::Contains(words));
}

}  // namespace

TEST_CASE(
    "inspect writes a mesh in the units and axes of the scene, seen from outside, see-through parts by themselves")
{
    constexpr double kRadius = 4, kHalf = kRadius * 8000 / 16384, kDown = kRadius * -4000 / 16384, kDigits = 1e-5;
    const Place centre = {1, 2, 3};  // of TestSurface
    const test::TemporaryFolder folder;
    write_panes(folder / "f.lumi");
    for (const auto& [up, axis] : {std::pair<std::string, size_t>{"y", 1}, {"z", 2}}) {
        INFO("up " << up);
        const Mesh mesh = mesh_of(folder, up);
        REQUIRE(mesh.vertices.size() == 8);
        for (size_t k = 0; k < 3; ++k)
            CHECK(mesh.vertices[0][k] == Approx(centre[k] + (k == axis ? kDown : -kHalf)).margin(kDigits));
        // The second vertex lies along the sphere's x, which is the scene's z where y is up.
        const size_t along = up == "y" ? 2 : 0;
        CHECK(mesh.vertices[1][along] == Approx(centre[along] + kHalf).margin(kDigits));
        REQUIRE(mesh.groups.size() == 2);
        for (const auto& [name, half] : {std::pair<std::string, double>{"opaque", 8000}, {"see_through", 4000}}) {
            const double side = 2 * half * kRadius / 16384;
            REQUIRE(mesh.groups.at(name).size() == 2);
            for (const auto& face : mesh.groups.at(name))
                CHECK(facing(mesh, face, axis) == Approx(side * side).epsilon(kDigits));
        }
    }
}

TEST_CASE("a picture of a surface field shows every texel once, in the rectangle of its patch")
{
    constexpr int kColumns = 5, kRows = 3;
    lumi::test::TestSurface surface = lumi::test::panes({{8000, 4000, 0}, {4000, -4000, 0}});
    surface.patches[0].columns = kColumns;
    surface.patches[0].rows = kRows;
    surface.patches[1].columns = surface.patches[1].rows = 2;
    surface.patches[1].begin = kColumns * kRows;
    surface.patches[1].d = detail::format::kNoVertex;
    for (uint32_t k = 0; k < surface.texels.size() && k < 256; ++k) surface.texels[k] = static_cast<uint8_t>(k);
    surface.texels.resize(kColumns * kRows + detail::format::patch_reach(kColumns));
    const test::TemporaryFolder folder;
    write(folder / "f.lumi", lumi::test::file_of(lumi::test::surface_sections(surface)));
    const Picture picture = picture_of(folder);
    std::map<Colour, int> counts = pixels_by_colour(picture);
    const int texel_pixels = counts[entry(0)];
    const int size = static_cast<int>(std::lround(std::sqrt(texel_pixels)));
    CHECK(size * size == texel_pixels);
    // A lone triangle with corners at (0, 0), (2, 0) and (0, 2) covers nothing of the last texel of four.
    constexpr int kUsed = kColumns * kRows + 3;
    for (int k = 0; k < kUsed; ++k) {
        INFO(k);
        CHECK(counts[entry(k)] == texel_pixels);
    }
    CHECK(counts[kEmpty] == picture.width_px * picture.height_px - kUsed * texel_pixels);
    for (int j = 0; j < kRows; ++j)
        for (int i = 0; i < kColumns; ++i)
            CHECK(colour_at(picture, (1 + i) * size, (1 + j) * size) == entry(j * kColumns + i));
}

TEST_CASE("a picture of a surface field shows see-through texels over light and dark, apart from opaque ones")
{
    const test::TemporaryFolder folder;
    write_panes(folder / "f.lumi");
    const Picture picture = picture_of(folder);
    std::map<Colour, int> counts = pixels_by_colour(picture);
    constexpr int kLight = 200;
    Colour pane{};
    for (size_t c = 0; c < pane.size(); ++c)
        pane[c] = static_cast<int>(std::lround(kInspectedGlass.added[c] + kInspectedGlass.passed[c] * kLight / 255.0));
    CHECK(counts.size() == 3);
    CHECK(counts[entry(kInspectedSquare)] > 0);
    CHECK(counts[pane] == counts[entry(kInspectedSquare)]);
    CHECK(counts[kEmpty] == picture.width_px * picture.height_px - 2 * counts[pane]);
}

TEST_CASE("a picture of a chord field holds a map for every origin, in their order")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "f.lumi", test::field_bytes({}));
    const Picture picture = picture_of(folder);
    const int kHeight = 4, kWidth = 13, kColumns = 4;  // maps of 60 directions; 40 of them about as wide as high
    REQUIRE(picture.width_px == kColumns * (kWidth + kSheetGap) - kSheetGap);
    for (int k = 0; k < 40; ++k) {
        INFO("origin " << k);
        const int x = k % kColumns * (kWidth + kSheetGap), y = k / kColumns * (kHeight + kSheetGap);
        const int value = 1 + k * 7 % 250;  // test::texel_bytes()
        for (const int dx : {0, kWidth - 1})
            for (const int dy : {0, kHeight - 1})
                CHECK(colour_at(picture, x + dx, y + dy) == Colour{value, value, value});
    }
}

TEST_CASE("a map of a chord field has the north pole above, and rays that miss are empty")
{
    constexpr uint32_t kDirections = 2000;
    const test::TestField field = {1, kDirections, 1, TexelFormat::rgb888};
    std::string texels(detail::format::padded_row_stride(kDirections, field.texel), '\0');
    for (uint32_t j = 0; j < kDirections / 2; ++j) texels[3 * j] = static_cast<char>(250);
    const test::TemporaryFolder folder;
    test::write_content(folder / "f.lumi", chord_file(field, texels));
    const Picture picture = picture_of(folder);
    for (int x = 0; x < picture.width_px; ++x) {
        CHECK(colour_at(picture, x, picture.height_px / 2 - 2) == Colour{250, 0, 0});
        CHECK(colour_at(picture, x, 0) == Colour{250, 0, 0});
        CHECK(colour_at(picture, x, (picture.height_px + 1) / 2 + 1) == kEmpty);
        CHECK(colour_at(picture, x, picture.height_px - 1) == kEmpty);
    }
}

TEST_CASE("a picture of a large chord field shows some of its origins, from pole to pole")
{
    const test::TestField field = {1000, 60, 1000, TexelFormat::rgb888};
    const test::TemporaryFolder folder;
    test::write_content(folder / "f.lumi", test::field_bytes(field));
    const Picture picture = picture_of(folder);
    constexpr int kWidth = 13, kHeight = 4;
    const int columns = (picture.width_px + kSheetGap) / (kWidth + kSheetGap);
    const int rows = (picture.height_px + kSheetGap) / (kHeight + kSheetGap);
    CHECK(columns * rows >= 256);
    CHECK((columns - 1) * rows < 256);
    const int last = 255 * 1000 / 256, value = 1 + last * 7 % 250;
    CHECK(colour_at(picture, 255 % columns * (kWidth + kSheetGap), 255 / columns * (kHeight + kSheetGap)) ==
          Colour{value, value, value});
}

TEST_CASE("inspect -o says what it cannot write, and leaves what is there")
{
    const test::TemporaryFolder folder;
    const std::string chord = folder / "chord.lumi", surface = folder / "f.lumi", old = folder / "old.obj";
    test::write_content(chord, test::field_bytes({}));
    test::write_content(old, "old");
    write_panes(surface);
    check_refused({"inspect", chord, "-o", old}, 1, "has no mesh; write its picture (-o OUT.png), or bake a surface");
    CHECK(test::content_of(old) == "old");
    check_refused({"inspect", surface, "-o", folder / "f.stl"}, 2, "takes a picture (.png) or a mesh (.obj)");
    check_refused({"inspect", surface, "-o", folder / "f.png", "--up", "z"}, 2, "--up belongs to a mesh");
    check_refused({"inspect", surface, "--up", "z"}, 2, "--up belongs to a mesh");
    std::string damaged = test::content_of(surface);
    damaged.back() = static_cast<char>(damaged.back() ^ 1);
    test::write_content(surface, damaged);
    check_refused({"inspect", surface, "-o", old}, 1, "f.lumi");
    CHECK(test::content_of(old) == "old");
    CHECK(folder.entries() == 3);
}

}  // namespace lumi::tools
