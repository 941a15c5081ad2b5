// SPDX-License-Identifier: MIT
#pragma once

class SPIClass;
class HardwareSPI;
