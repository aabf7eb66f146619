// Version 3 of behaviortree_cpp/controls/parallel_node.h.
#pragma once

#include "behaviortree_cpp/controls/parallel_node.h"
#include "behaviortree_cpp_v3/old_names.h"
