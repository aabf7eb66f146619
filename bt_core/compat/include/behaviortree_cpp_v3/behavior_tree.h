// Version 3 of behaviortree_cpp/behavior_tree.h.
#pragma once

#include "behaviortree_cpp/behavior_tree.h"
#include "behaviortree_cpp_v3/old_names.h"
