// SPDX-License-Identifier: MIT
// The size report's zero: start-up code alone.
int main(int, char**)
{
    return 0;
}
