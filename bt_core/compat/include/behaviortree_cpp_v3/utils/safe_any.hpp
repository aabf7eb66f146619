// Version 3 of behaviortree_cpp/utils/safe_any.hpp.
#pragma once

#include "behaviortree_cpp/utils/safe_any.hpp"
#include "behaviortree_cpp_v3/old_names.h"
