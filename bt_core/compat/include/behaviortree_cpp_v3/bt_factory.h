// Version 3 of behaviortree_cpp/bt_factory.h.
#pragma once

#include "behaviortree_cpp/bt_factory.h"
#include "behaviortree_cpp_v3/old_names.h"
