// Version 3 of behaviortree_cpp/bt_parser.h.
#pragma once

// The names come first.
// clang-format off
#include "behaviortree_cpp_v3/old_names.h"
#include "behaviortree_cpp/bt_parser.h"
// clang-format on
