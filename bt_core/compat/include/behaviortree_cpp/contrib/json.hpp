// nlohmann::json, as Debian packs it.
#pragma once

#include <nlohmann/json.hpp>
