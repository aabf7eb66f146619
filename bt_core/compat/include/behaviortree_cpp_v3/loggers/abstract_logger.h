// Version 3 of behaviortree_cpp/loggers/abstract_logger.h.
#pragma once

#include "behaviortree_cpp/loggers/abstract_logger.h"
#include "behaviortree_cpp_v3/old_names.h"
