// SPDX-License-Identifier: MIT
// Embedded fields, assembled by real tools.
#include <catch2/catch.hpp>

#include "support/program.h"
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
    const Outcome outcome = run_program(arguments);
    INFO(arguments[0] << ": " << outcome.err);
    REQUIRE(outcome.code == 0);
}

struct Embedded {
    test::TemporaryFolder folder;
    std::string bytes = test::field_bytes({});

    Embedded()
    {
        test::write_content(folder / "a field.lumi", bytes);
        const Outcome outcome =
            lumi({"embed", folder / "a field.lumi", "-o", folder / "my-field.S", "--symbol", "demo_field"});
        INFO(outcome.err);
        REQUIRE(outcome.code == 0);
    }
};

}  // namespace

TEST_CASE("a host program finds the field's very bytes, aligned to 8, through the header")
{
    const Embedded embedded;
    const std::string program = embedded.folder / "main";
    for (const std::string suffix : {".c", ".cpp"}) {
        test::write_content(program + suffix,
                            "#include <stdio.h>\n#include \"my-field.h\"\n"
                            "int main(void) { if ((uintptr_t)demo_field % 8 != 0) return 1;\n"
                            "return fwrite(demo_field, 1, demo_field_size(), stdout) != demo_field_size(); }\n");
        const std::string compiler = suffix == ".c" ? LUMI_C_COMPILER : LUMI_CXX_COMPILER;
        require_success(
            {compiler, "-Wall", "-Wextra", "-Werror", program + suffix, embedded.folder / "my-field.S", "-o", program});
        const Outcome outcome = run_program({program});
        CHECK(outcome.code == 0);
        CHECK((outcome.out == embedded.bytes));
    }
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
    require_success(
        {LUMI_ARM_COMPILER, "-mcpu=cortex-m0plus", "-mthumb", "-c", embedded.folder / "my-field.S", "-o", object});
    require_success({LUMI_ARM_OBJCOPY, "-O", "binary", "-j", ".rodata.demo_field", object, raw});
    CHECK((test::content_of(raw) == embedded.bytes));
}
#endif

}  // namespace lumi::tools
