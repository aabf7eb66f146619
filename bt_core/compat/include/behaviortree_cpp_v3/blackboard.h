// Version 3 of behaviortree_cpp/blackboard.h.
#pragma once

#include "behaviortree_cpp/blackboard.h"
#include "behaviortree_cpp_v3/old_names.h"
