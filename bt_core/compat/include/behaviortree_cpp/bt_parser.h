// Included by code that reads trees; what there is lies in xml_parsing.h.
#pragma once

#include "behaviortree_cpp/bt_factory.h"
