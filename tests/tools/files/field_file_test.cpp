// SPDX-License-Identifier: MIT
#include "files/field_file.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "files/field_report.h"
#include "support/small_surface.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"

namespace lumi::tools
{

TEST_CASE("a report holds every layout field and accounts for every byte")
{
    const test::TemporaryFolder folder;
    test::TestField field = {100, 33, 50, TexelFormat::palette8};
    const std::string bytes = test::field_bytes(field);
    test::write_content(folder / "a.lumi", bytes);
    const auto json = nlohmann::json::parse(report_json(FieldFile(folder / "a.lumi"), true));
    CHECK(json["bytes"] == bytes.size());
    CHECK(json["version"] == 1);
    CHECK(json["origins"] == 100);
    CHECK(json["used_origins"] == 50);
    CHECK(json["directions"] == 33);
    CHECK(json["texel_format"] == "palette8");
    CHECK(json["colour_space"] == "srgb");
    CHECK(json["row_bytes"] == 33);
    CHECK(json["row_stride_bytes"] == 40);
    CHECK(json["centre"] == std::vector<double>{1.5, -2, 0.25});
    CHECK(json["radius"] == 3.5);
    uint64_t sum = json["other_bytes"];
    std::vector<std::string> types;
    for (const auto& section : json["sections"]) {
        sum += section["bytes"].get<uint64_t>();
        types.push_back(section["type"]);
        CHECK(section["intact"] == true);
        CHECK(section["required"] == true);
    }
    CHECK(sum == bytes.size());
    CHECK(types == std::vector<std::string>{"LAYO", "PALT", "TEXL"});
}

TEST_CASE("the report for people names every section")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "a.lumi", test::field_bytes({}));
    const std::string text = report_text(FieldFile(folder / "a.lumi"), false);
    for (const char* word : {"a.lumi", "40, of which 40 used", "60", "rgb888", "LAYO", "TEXL", "radius 3.5"})
        CHECK_THAT(text, Catch::Contains(word));
    CHECK_THAT(text, !Catch::Contains("intact"));
}

TEST_CASE("a damaged texel is found by the CRC and named with its section")
{
    const test::TemporaryFolder folder;
    std::string bytes = test::field_bytes({});
    bytes.back() = static_cast<char>(bytes.back() ^ 1);
    test::write_content(folder / "a.lumi", bytes);
    const FieldFile file(folder / "a.lumi");
    CHECK_THROWS_WITH(
        file.require_intact(),
        folder / "a.lumi" + ": the texel section's bytes are damaged (CRC); copy the file again or bake it again");
    CHECK_THAT(report_text(file, true), Catch::Contains("DAMAGED"));
}

TEST_CASE("a damaged gloss map is found and named in words, as every section of a surface field is")
{
    const test::TemporaryFolder folder;
    std::string bytes = test::glossy_surface_bytes();
    test::write_content(folder / "g.lumi", bytes);
    for (const Section& section : FieldFile(folder / "g.lumi").sections()) {
        CHECK_THAT(title_of(section.type), !Catch::Contains("\""));
        char& middle = bytes[section.offset + section.bytes / 2];
        if (section.type == "SGLO") middle = static_cast<char>(middle ^ 1);
    }
    test::write_content(folder / "g.lumi", bytes);
    CHECK_THROWS_WITH(FieldFile(folder / "g.lumi").require_intact(),
                      Catch::Contains("g.lumi: the gloss section's bytes are damaged (CRC); "));
}

TEST_CASE("what is no field is refused with its name and a mend")
{
    const test::TemporaryFolder folder;
    const std::string whole = test::field_bytes({});
    for (const std::string& bytes :
         {std::string(), std::string("OBJ"), std::string(64, 'x'), whole.substr(0, 70), whole + "x"}) {
        test::write_content(folder / "b.lumi", bytes);
        CHECK_THROWS_WITH(FieldFile(folder / "b.lumi"),
                          Catch::StartsWith(folder / "b.lumi: ") && Catch::Contains("; "));
    }
    CHECK_THROWS_WITH(FieldFile(folder / "none.lumi"), Catch::Contains("No such file"));
    CHECK_THROWS_WITH(FieldFile(folder.path()), Catch::Contains("cannot be read (Is a directory)"));
    CHECK_THROWS_WITH(FieldFile("/dev/zero"), Catch::Contains("is a device or a pipe; name a file"));
}

TEST_CASE("a field's file may be cut short and overwritten once it is read")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "c.lumi", test::field_bytes({}));
    const FieldFile file(folder / "c.lumi");
    const std::string before(reinterpret_cast<const char*>(file.bytes()), file.size());
    std::filesystem::resize_file(folder / "c.lumi", 10);
    test::write_content(folder / "c.lumi", "x");
    CHECK(before == std::string(reinterpret_cast<const char*>(file.bytes()), file.size()));
    file.require_intact();
}

}  // namespace lumi::tools
