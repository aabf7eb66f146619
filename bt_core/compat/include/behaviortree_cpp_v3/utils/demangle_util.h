// Version 3 of behaviortree_cpp/utils/demangle_util.h.
#pragma once

#include "behaviortree_cpp/utils/demangle_util.h"
#include "behaviortree_cpp_v3/old_names.h"
