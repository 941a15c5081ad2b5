// SPDX-License-Identifier: MIT
// Planted for the test of the proof: operator new.
int* planted();
int* planted()
{
    return new int(1);
}
