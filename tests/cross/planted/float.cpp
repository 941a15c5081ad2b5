// SPDX-License-Identifier: MIT
// Planted for the test of the proof: single precision in software.
float planted(float a, float b);
float planted(float a, float b)
{
    return a * b;
}
