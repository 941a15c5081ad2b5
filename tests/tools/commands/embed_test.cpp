// SPDX-License-Identifier: MIT
// Embedded fields, assembled by real tools.
#include <catch2/catch.hpp>
#include <filesystem>

#include "files/field_file.h"
#include "lumi/surface/field.h"
#include "support/program.h"
#include "support/small_surface.h"
#include "support/temporary_folder.h"
#include "support/test_field.h"

namespace lumi::tools
{

using test::lumi;
using test::Outcome;
using test::run_program;

namespace
{

void require_success(const test::Arguments& arguments)
{
    done(run_program(arguments));
}

struct Embedded {
    test::TemporaryFolder folder;
    std::string bytes = test::field_bytes({});

    Embedded()
    {
        test::write_content(folder / "a field.lumi", bytes);
        done(lumi({"embed", folder / "a field.lumi", "-o", folder / "my-field.S", "--symbol", "demo_field"}));
    }
};

}  // namespace

TEST_CASE("a host program finds the field's very bytes, aligned to 8, through the header")
{
    const Embedded embedded;
    const std::string program = embedded.folder / "main";
    REQUIRE(lumi({"embed", embedded.folder / "a field.lumi", "-o", embedded.folder / "my-field.cpp", "--symbol",
                  "demo_field"})
                .code == 0);
    for (const std::string suffix : {".c", ".cpp"}) {
        test::write_content(program + suffix,
                            "#include <stdio.h>\n#include \"my-field.h\"\n"
                            "int main(void) { if ((uintptr_t)demo_field % 8 != 0) return 1;\n"
                            "return fwrite(demo_field, 1, demo_field_size(), stdout) != demo_field_size(); }\n");
        const std::string compiler = suffix == ".c" ? LUMI_C_COMPILER : LUMI_CXX_COMPILER;
        for (const char* bytes : {"my-field.S", "my-field.cpp"}) {
            require_success({compiler, "-Wall", "-Wextra", "-pedantic", "-Werror", "-I", LUMI_CORE_INCLUDE, "-I",
                             embedded.folder.path(), program + suffix, embedded.folder / bytes, "-o", program});
            const Outcome outcome = run_program({program});
            CHECK(outcome.code == 0);
            CHECK((outcome.out == embedded.bytes));
        }
    }
}

TEST_CASE("a program can hold a field's flash and RAM against its own limits when it is compiled")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "s.lumi", test::small_surface_bytes());
    test::write_content(folder / "c.lumi", test::field_bytes({}));
    for (const char* name : {"s", "c"})
        REQUIRE(
            lumi({"embed", folder / (std::string(name) + ".lumi"), "-o", folder / (std::string(name) + ".bin")}).code ==
            0);
    test::write_content(
        folder / "main.cpp",
        "#include \"s.h\"\n#include \"c.h\"\nusing namespace lumi;\n"
        "static s_view<Screen<100, 80, 4>, SurfaceMode::one_sample> view;\n"
        "static_assert(s_ram_bytes<decltype(view)> == sizeof view + 100 * 4 * 2, \"\");\n"
        "static_assert(s_ram_bytes<> == sizeof(s_view<>) + 240 * 16 * 2, \"\");\n"
        "static_assert(c_ram_bytes<c_view<Screen<9, 2, 4, PixelRgb888>>> == sizeof(c_view<>) + 54, \"\");\n"
        "static_assert(s_flash_bytes == " +
            std::to_string(test::small_surface_bytes().size()) + ", \"\");\nint main() {}\n");
    require_success({LUMI_CXX_COMPILER, "-std=c++17", "-Wall", "-Wextra", "-Wconversion", "-pedantic", "-Werror",
                     "-fsyntax-only", "-I", LUMI_CORE_INCLUDE, folder / "main.cpp"});
}

TEST_CASE("an array in C holds the field's very bytes, in C and in C++")
{
    const test::TemporaryFolder folder;
    const std::string bytes = test::field_bytes({}), program = folder / "main";
    test::write_content(folder / "a.lumi", bytes);
    REQUIRE(lumi({"embed", folder / "a.lumi", "-o", folder / "a.c", "--section", ".my_section"}).code == 0);
    test::write_content(
        program + ".c",
        "#include <stdio.h>\n#include \"a.h\"\n"
        "int main(void) { return (uintptr_t)a % 8 != 0 || fwrite(a, 1, a_size(), stdout) != a_size(); }\n");
    for (const char* language : {"c", "c++"}) {
        require_success({LUMI_C_COMPILER, "-pedantic", "-Wall", "-Wextra", "-Werror", "-I", LUMI_CORE_INCLUDE, "-x",
                         language, program + ".c", folder / "a.c", "-o", program});
        const Outcome outcome = run_program({program});
        CHECK(outcome.code == 0);
        CHECK((outcome.out == bytes));
        CHECK_THAT(run_program({"objdump", "-h", program}).out, Catch::Contains(".my_section"));
    }
}

TEST_CASE("a field to be flashed on its own is a copy, and its header tells the size")
{
    const test::TemporaryFolder folder;
    const std::string bytes = test::field_bytes({});
    test::write_content(folder / "a.lumi", bytes);
    REQUIRE(lumi({"embed", folder / "a.lumi", "-o", folder / "a.bin"}).code == 0);
    CHECK((test::content_of(folder / "a.bin") == bytes));
    CHECK_THAT(test::content_of(folder / "a.h"), Catch::Contains("return " + std::to_string(bytes.size()) + "u;"));
    check_refused(lumi({"embed", folder / "a.lumi", "-o", folder / "a.bin", "--section", "s"}), 2,
                  "flashed on its own");
}

TEST_CASE("a UF2 file holds the field page by page from its address on, which the header says too")
{
    const test::TemporaryFolder folder;
    const std::string field = folder / "a.lumi", uf2 = folder / "a.uf2", bytes = test::field_bytes({});
    test::write_content(field, bytes);
    done(lumi({"embed", field, "-o", uf2, "--address", "0x10100000", "--family", "rp2350"}));
    const std::string file = test::content_of(uf2);
    REQUIRE(file.size() % 512 == 0);
    const auto word = [&](size_t at) {
        uint32_t value = 0;
        for (size_t k = 4; k-- > 0;) value = value << 8 | static_cast<uint8_t>(file[at + k]);
        return value;
    };
    std::string flashed;
    for (size_t at = 0; at < file.size(); at += 512) {
        CHECK(file.compare(at, 8, "UF2\x0AWQ\x5D\x9E") == 0);
        CHECK(word(at + 8) == 0x2000);
        CHECK(word(at + 12) == 0x10100000 + flashed.size());
        CHECK(word(at + 16) == 256);
        CHECK(word(at + 20) == at / 512);
        CHECK(word(at + 24) == file.size() / 512);
        CHECK(word(at + 28) == 0xE48BFF57);
        CHECK(word(at + 508) == 0x0AB16F30);
        flashed += file.substr(at + 32, 256);
    }
    CHECK(flashed.size() - bytes.size() < 256);
    CHECK((flashed.substr(0, bytes.size()) == bytes));
    CHECK_THAT(test::content_of(folder / "a.h"), Catch::Contains("a = (const uint8_t*)0x10100000u;"));
    CHECK_THAT(lumi({"embed", field, "-o", uf2}).err, Catch::Contains("needs --address"));
    for (const char* address : {"0x10100100", "x", "-4096", "0x100000000", ""}) {
        CAPTURE(address);
        CHECK(lumi({"embed", field, "-o", uf2, "--address", address}).code == 2);
    }
    CHECK((test::content_of(uf2) == file));
    CHECK(lumi({"embed", field, "-o", folder / "a.c", "--address", "0x10100000"}).code == 2);
}

TEST_CASE("a field's address lies in the flash of its board, behind the program's first sector")
{
    const test::TemporaryFolder folder;
    const std::string field = folder / "a.lumi", uf2 = folder / "a.uf2";
    test::write_content(field, test::field_bytes({}));
    const auto embed = [&](const std::string& address, const std::string& family) {
        return lumi({"embed", field, "-o", uf2, "--address", address, "--family", family});
    };
    for (const char* family : {"rp2040", "rp2350"}) {
        CAPTURE(family);
        CHECK_THAT(embed("0x10000000", family).err,
                   Catch::Contains("the program lies there and would be lost") && Catch::Contains("from 0x10001000"));
        for (const char* address : {"0x0", "0x08000000", "0x0FFFF000", "0x12000000", "0x20000000", "0xFFFF0000"}) {
            CAPTURE(address);
            check_refused(embed(address, family), 2, "the board's flash is 0x10000000 to 0x1");
        }
        CHECK(embed("0x10001000", family).code == 0);
    }
    CHECK_THAT(embed("0x11000000", "rp2040").err, Catch::Contains("flash is 0x10000000 to 0x10FFFFFF"));
    CHECK(embed("0x11000000", "rp2350").code == 0);
    CHECK(lumi({"embed", field, "-o", folder / "b.bin", "--address", "0x08000000"}).code == 0);
}

TEST_CASE("the last address of a field leaves room for its whole sectors")
{
    const test::TemporaryFolder folder;
    const std::string field = folder / "a.lumi", uf2 = folder / "a.uf2";
    test::TestField large;
    large.origins = large.used_origins = large.directions = 64;
    const std::string bytes = test::field_bytes(large);
    REQUIRE(bytes.size() > 3 * 4096);
    REQUIRE(bytes.size() < 4 * 4096);
    test::write_content(field, bytes);
    CHECK(lumi({"embed", field, "-o", uf2, "--address", "0x10FFC000"}).code == 0);
    CHECK_THAT(lumi({"embed", field, "-o", uf2, "--address", "0x10FFD000"}).err, Catch::Contains("to 0x10FFC000"));
}

TEST_CASE("outputs that share a header agree, or the second is refused and nothing is written")
{
    const test::TemporaryFolder folder;
    for (const char* name : {"a.lumi", "b.lumi"}) test::write_content(folder / name, test::field_bytes({}));
    const std::string header = folder / "a.h";
    const auto embed = [&](const std::string& field, const std::string& output, const test::Arguments& more = {}) {
        test::Arguments arguments = {"embed", folder / field, "-o", folder / output};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return lumi(arguments);
    };
    const auto refused = [&](const Outcome& outcome, const std::string& kept, const std::string& unwritten) {
        CHECK(outcome.code == 1);
        CHECK_THAT(outcome.err, Catch::Contains("a.h: serves") && Catch::Contains("remove " + (folder / kept)));
        CHECK_FALSE(std::filesystem::exists(folder / unwritten));
    };
    REQUIRE(embed("a.lumi", "a.c").code == 0);
    const std::string of_array = test::content_of(header);
    refused(embed("a.lumi", "a.bin"), "a.c", "a.bin");
    refused(embed("a.lumi", "a.S"), "a.c", "a.S");
    CHECK(test::content_of(header) == of_array);
    CHECK(embed("b.lumi", "a.c", {"--symbol", "other"}).code == 0);  // the same output, anew
    std::filesystem::remove(folder / "a.c");
    CHECK(embed("a.lumi", "a.bin", {"--address", "0x10100000"}).code == 0);
    CHECK(embed("a.lumi", "a.uf2", {"--address", "0x10100000"}).code == 0);
    refused(embed("a.lumi", "a.cpp"), "a.bin", "a.cpp");
    for (const auto& [field, more] : std::vector<std::pair<std::string, test::Arguments>>{
             {"a.lumi", {"--address", "0x10200000"}},
             {"b.lumi", {"--address", "0x10100000"}},
             {"a.lumi", {"--address", "0x10100000", "--symbol", "other"}}})
        check_refused(embed(field, "a.bin", more), 1, Catch::Contains("remove " + (folder / "a.uf2")));
}

TEST_CASE("a header that somebody wrote is not replaced")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "main.lumi", test::field_bytes({}));
    test::write_content(folder / "main.h", "#define MINE 1\n");
    check_refused(lumi({"embed", folder / "main.lumi", "-o", folder / "main.S", "--symbol", "f"}), 1,
                  "main.h: `lumi embed` did not write it");
    CHECK(test::content_of(folder / "main.h") == "#define MINE 1\n");
}

TEST_CASE("header and inspect name the view of exactly this field")
{
    const test::TemporaryFolder folder;
    test::TestField chord;
    chord.origins = chord.used_origins = chord.directions = 64;
    chord.texel = TexelFormat::luma8;
    test::write_content(folder / "chord.lumi", test::field_bytes(chord));
    test::write_content(folder / "few.lumi", test::field_bytes({}));
    test::write_content(folder / "surface.lumi", test::small_surface_bytes());
    const auto check = [&](const std::string& name, const std::string& drawing, const std::string& last) {
        const std::string view = "lumi::View<" + drawing + ", " + last + ">, Screen>";
        CHECK_THAT(lumi({"inspect", folder / (name + ".lumi")}).out,
                   Catch::Contains("drawn by      lumi::View<" + drawing + ">, lumi::Screen<240, 240, 16>>\n"));
        REQUIRE(lumi({"embed", folder / (name + ".lumi"), "-o", folder / (name + ".bin")}).code == 0);
        const std::string opener = drawing.find("Surface") == std::string::npos ? "open_field" : "open_surface";
        CHECK_THAT(test::content_of(folder / (name + ".h")),
                   Catch::Contains("using " + name + "_view = " + view + ";") &&
                       Catch::Contains("lumi::" + opener + "(" + name + ", " + name + "_size(), field)"));
    };
    check("chord", "lumi::ChordDrawing<lumi::TexelLuma8", "Reconstruction");
    check("few", "lumi::ExactChordDrawing<lumi::TexelRgb888", "Reconstruction");
    const std::string bytes = test::small_surface_bytes();
    SurfaceField field;
    REQUIRE(open_surface(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size(), field) == FieldError::none);
    check("surface",
          "lumi::SurfaceDrawing<" + std::to_string(field.vertex_count) + ", " + std::to_string(field.patch_count),
          field.viewed_count == 0 ? "Finest, 0, 0" : "Finest");
    // A field that needs no code for view tables says so.
    REQUIRE(lumi({"bake", test::write_cube(folder.path()), "-o", folder / "plain.lumi", "--layout", "surface",
                  "--triangles", "12", "--texel-density", "10", "--paths", "2", "--no-view-tables"})
                .code == 0);
    const FieldFile plain(folder / "plain.lumi");
    check("plain",
          "lumi::SurfaceDrawing<" + std::to_string(plain.surface().vertex_count) + ", " +
              std::to_string(plain.surface().patch_count),
          "Finest, 0, 0");
}

TEST_CASE("an assembler file names its field from its own folder, and the section that was asked for")
{
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "out");
    test::write_content(folder / "f.lumi", test::field_bytes({}));
    REQUIRE(lumi({"embed", folder / "f.lumi", "-o", folder / "out/f.S", "--section", ".flashdata.f"}).code == 0);
    CHECK_THAT(test::content_of(folder / "out/f.S"),
               Catch::Contains(".incbin \"../f.lumi\"") && Catch::Contains(".section .flashdata.f, "));
    require_success({LUMI_C_COMPILER, "-c", "-I", folder / "out", folder / "out/f.S", "-o", folder / "f.o"});
    CHECK(lumi({"embed", folder / "f.lumi", "-o", folder / "f.S", "--section", "a b"}).code == 2);
}

TEST_CASE("a relative .incbin path is written as given and found through -I")
{
    const test::TemporaryFolder folder;
    test::write_content(folder / "f.lumi", test::field_bytes({}));
    REQUIRE(lumi({"embed", folder / "f.lumi", "-o", folder / "f.S", "--incbin", "f.lumi"}).code == 0);
    CHECK_THAT(test::content_of(folder / "f.S"), Catch::Contains(".incbin \"f.lumi\""));
    require_success({LUMI_C_COMPILER, "-c", "-I", folder.path(), folder / "f.S", "-o", folder / "f.o"});
}

#ifdef LUMI_ARM_COMPILER
TEST_CASE("an ARM object holds the field's very bytes in .rodata")
{
    const Embedded embedded;
    const std::string object = embedded.folder / "f.o", raw = embedded.folder / "f.bin";
    require_success({LUMI_ARM_COMPILER, "-mcpu=cortex-m0plus", "-mthumb", "-I", embedded.folder.path(), "-c",
                     embedded.folder / "my-field.S", "-o", object});
    require_success({LUMI_ARM_OBJCOPY, "-O", "binary", "-j", ".rodata.demo_field", object, raw});
    CHECK((test::content_of(raw) == embedded.bytes));
}
#endif

}  // namespace lumi::tools
