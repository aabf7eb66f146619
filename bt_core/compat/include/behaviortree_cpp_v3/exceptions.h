// Version 3 of behaviortree_cpp/exceptions.h.
#pragma once

#include "behaviortree_cpp/exceptions.h"
#include "behaviortree_cpp_v3/old_names.h"
