// SPDX-License-Identifier: MIT
// The zero of the sizes: start-up code alone.
int main(int, char**)
{
    return 0;
}
