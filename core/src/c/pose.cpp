// SPDX-License-Identifier: MIT
#include "c/types.h"
#include "lumi/attitude.h"

using namespace lumi::detail;

lumi_pose lumi_pose_of(lumi_orbit orbit)
{
    return in_c(lumi::pose_of(in_cpp(orbit)));
}

lumi_pose lumi_held_pose(lumi_quaternion turn, int32_t distance_q20)
{
    return in_c(lumi::held_pose({turn.w, turn.x, turn.y, turn.z}, distance_q20));
}

lumi_pose lumi_moved_right(lumi_pose pose, int32_t offset_q20)
{
    return in_c(lumi::moved_right(in_cpp(pose), offset_q20));
}
