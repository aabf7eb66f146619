// Version 3 of behaviortree_cpp/controls/reactive_sequence.h.
#pragma once

#include "behaviortree_cpp/controls/reactive_sequence.h"
#include "behaviortree_cpp_v3/old_names.h"
