// Version 3 of behaviortree_cpp/controls/while_do_else_node.h.
#pragma once

// The names come first.
// clang-format off
#include "behaviortree_cpp_v3/old_names.h"
#include "behaviortree_cpp/controls/while_do_else_node.h"
// clang-format on
