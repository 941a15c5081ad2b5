// SPDX-License-Identifier: MIT
// Planted for the test of the proof: double precision in software.
double planted(double a, double b);
double planted(double a, double b)
{
    return a + b;
}
