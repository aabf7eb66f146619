// Version 3 of behaviortree_cpp/utils/strcat.hpp.
#pragma once

#include "behaviortree_cpp/utils/strcat.hpp"
#include "behaviortree_cpp_v3/old_names.h"
