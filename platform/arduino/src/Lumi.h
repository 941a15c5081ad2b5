// SPDX-License-Identifier: MIT
// All of lumi that a sketch needs: include this file alone.
#pragma once

#include <lumi/gesture.h>
#include <lumi/quality.h>
#include <lumi/view.h>
