// Open requests and the page's passes in a file, so that a restart of the program loses neither a
// question nor the links that people have in their messages.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_ASSISTANCE_STORE_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_ASSISTANCE_STORE_H_

#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "robot_app/assistance/help_request.h"
#include "robot_app/assistance/page/page_access.h"

namespace coppice::robot::assistance {

struct AssistanceState {
  std::vector<HelpRequest> requests;
  PageAccess::State passes;
};

/// JSON.
std::string ToText(const AssistanceState& state);
/// What is no such text reads as an empty state, with an error.
AssistanceState ReadState(const std::string& text, Diagnostics& diagnostics);

/// A missing file is an empty state.
AssistanceState LoadState(const std::string& path, Diagnostics& diagnostics);
/// For its owner only (mode 0600). False, with the reason in `diagnostics`, if it fails.
bool SaveState(const std::string& path, const AssistanceState& state, Diagnostics& diagnostics);

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_ASSISTANCE_STORE_H_
