// SPDX-License-Identifier: MIT
#include "files/symbol.h"

#include <string>

namespace lumi::tools
{

namespace
{

// C23 and C++23, in their order; and the types that the header itself needs. A space stands around each.
constexpr std::string_view kTaken =
    " alignas alignof and and_eq asm atomic_cancel atomic_commit atomic_noexcept auto bitand bitor"
    " bool break case catch char char16_t char32_t char8_t class co_await co_return co_yield compl"
    " concept const const_cast consteval constexpr constinit continue decltype default delete do"
    " double dynamic_cast else enum explicit export extern false float for friend goto if inline int"
    " long mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected"
    " public register reinterpret_cast requires restrict return short signed sizeof static"
    " static_assert static_cast struct switch template this thread_local throw true try typedef"
    " typeid typename typeof typeof_unqual union unsigned using virtual void volatile wchar_t while"
    " xor xor_eq main size_t uint8_t unix linux _Alignas _Alignof _Atomic _BitInt _Bool _Complex"
    " _Decimal128 _Decimal32 _Decimal64 _Generic _Imaginary _Noreturn _Static_assert _Thread_local ";

}  // namespace

bool is_taken(std::string_view symbol)
{
    return !symbol.empty() && kTaken.find(" " + std::string(symbol) + " ") != std::string_view::npos;
}

}  // namespace lumi::tools
