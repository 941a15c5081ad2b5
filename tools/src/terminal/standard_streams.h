// SPDX-License-Identifier: MIT
// The streams that every command has without opening them.
#pragma once

namespace lumi::tools
{

// Call first of all. A stream that the caller closed (`lumi … >&-`) stays unusable, but its number is taken: no file
// that a command opens can get it, and receive what is meant for the stream.
void occupy_standard_streams();

// Call last of all. Throws Failure if something that was printed to standard output did not arrive there.
void finish_standard_output();

}  // namespace lumi::tools
