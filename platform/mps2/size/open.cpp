// SPDX-License-Identifier: MIT
// What every firmware links of core, whatever it draws with.
#include "probe.h"

int main(int, char**)
{
    lumi::Field field;
    lumi::Camera camera;
    return lumi::size::open(field, camera) ? 0 : 1;
}
