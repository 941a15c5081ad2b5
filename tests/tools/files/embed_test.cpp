// SPDX-License-Identifier: MIT
#include "files/embed.h"

#include <catch2/catch.hpp>

namespace lumi::tools
{

TEST_CASE("symbols are C identifiers, and any name has a nearest one")
{
    CHECK(is_symbol("field_2"));
    CHECK_FALSE(is_symbol(""));
    CHECK_FALSE(is_symbol("2field"));
    CHECK_FALSE(is_symbol("my-field"));
    CHECK(symbol_from("my-field.v2") == "my_field_v2");
    CHECK(symbol_from("2field") == "_2field");
    CHECK(symbol_from("") == "_");
    CHECK(is_symbol(symbol_from("dé jà")));
}

TEST_CASE("sections have names that every assembler takes")
{
    for (const char* name : {".flashdata.lumi", ".qspi", "$field", "a-b_c2"}) CHECK(is_section(name));
    for (const char* name : {"", "a b", "a,b", "a\"b", "a\nb"}) CHECK_FALSE(is_section(name));
}

TEST_CASE("words of C and C++ are no symbols, names like them are")
{
    for (const char* word : {"int", "restrict", "_Bool", "class", "xor", "co_await", "uint8_t", "int8_t", "main",
                             "lumi", "std", "NULL", "INT8_MAX", "uint_fast8_t", "__LINE__", "my__field", "_Field"})
        CHECK(is_taken(word));
    for (const char* word : {"int_", "Int", "field", "_", "_field", "interest", "INT_", "lumi_", ""})
        CHECK_FALSE(is_taken(word));
}

TEST_CASE("a path keeps its quotes and backslashes in the assembler file")
{
    CHECK_THAT(embed_assembler({"f", ""}, R"(C:\a "b".lumi)"), Catch::Contains(R"(.incbin "C:\\a \"b\".lumi")"));
}

}  // namespace lumi::tools
