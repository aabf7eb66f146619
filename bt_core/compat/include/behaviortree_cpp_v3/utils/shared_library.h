// Version 3 of behaviortree_cpp/utils/shared_library.h.
#pragma once

#include "behaviortree_cpp/utils/shared_library.h"
#include "behaviortree_cpp_v3/old_names.h"
