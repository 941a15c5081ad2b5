// SPDX-License-Identifier: MIT
#pragma once

#include "text_line.h"

// What a program adds to the line that the board writes after a frame.
void add_report(lumi::firmware::TextLine& line);
