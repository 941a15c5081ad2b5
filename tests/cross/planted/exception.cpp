// SPDX-License-Identifier: MIT
// Planted for the test of the proof: an exception.
void planted();
void planted()
{
    throw 1;
}
