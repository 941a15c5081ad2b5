// SPDX-License-Identifier: MIT
#pragma once

#include "text_line.h"

// A program adds this to the line that the board writes after a frame.
void add_report(lumi::firmware::TextLine& line);
