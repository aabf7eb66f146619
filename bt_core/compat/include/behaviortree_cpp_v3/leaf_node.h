// Version 3 of behaviortree_cpp/leaf_node.h.
#pragma once

#include "behaviortree_cpp/leaf_node.h"
#include "behaviortree_cpp_v3/old_names.h"
