// The headers of version 4 under the names of version 3, with what that version called otherwise.
#pragma once

#ifndef USE_BTCPP3_OLD_NAMES
#define USE_BTCPP3_OLD_NAMES
#endif
