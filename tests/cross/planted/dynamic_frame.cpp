// SPDX-License-Identifier: MIT
// Planted for the test of the proof: a frame whose size only run time knows.
void use(char* bytes);
void planted(unsigned count);
void planted(unsigned count)
{
    use(static_cast<char*>(__builtin_alloca(count)));
}
