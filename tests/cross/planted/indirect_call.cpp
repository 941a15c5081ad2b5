// SPDX-License-Identifier: MIT
// Planted for the test of the proof: a call whose target only run time knows.
int planted(int (*function)(int));
int planted(int (*function)(int))
{
    return function(1) + 1;
}
