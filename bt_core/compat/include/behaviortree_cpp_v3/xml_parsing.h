// Version 3 of behaviortree_cpp/xml_parsing.h.
#pragma once

#include "behaviortree_cpp/xml_parsing.h"
#include "behaviortree_cpp_v3/old_names.h"
