// Version 3 of behaviortree_cpp/utils/signal.h.
#pragma once

#include "behaviortree_cpp/utils/signal.h"
#include "behaviortree_cpp_v3/old_names.h"
