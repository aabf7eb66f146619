// Version 3 of behaviortree_cpp/basic_types.h.
#pragma once

#include "behaviortree_cpp/basic_types.h"
#include "behaviortree_cpp_v3/old_names.h"
