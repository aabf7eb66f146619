// Version 3 of behaviortree_cpp/bt_parser.h.
#pragma once

#include "behaviortree_cpp/bt_parser.h"
#include "behaviortree_cpp_v3/old_names.h"
