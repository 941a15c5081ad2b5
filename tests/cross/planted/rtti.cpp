// SPDX-License-Identifier: MIT
// Planted for the test of the proof: run-time type information.
struct Planted {
    virtual ~Planted() = default;
    virtual int value() const;
};
int Planted::value() const
{
    return 1;
}
