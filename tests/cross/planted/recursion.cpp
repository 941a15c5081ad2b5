// SPDX-License-Identifier: MIT
// Planted for the test of the proof: a function that calls itself.
unsigned planted(unsigned n);
unsigned planted(unsigned n)
{
    return n < 2 ? n : planted(n - 1) + planted(n - 2);
}
