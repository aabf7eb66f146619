// What the options of `coppice live` ask of a robot.
#ifndef COPPICE_BT_CORE_CLI_LIVE_LIVE_COMMANDS_H_
#define COPPICE_BT_CORE_CLI_LIVE_LIVE_COMMANDS_H_

#include <string>
#include <vector>

#include "bt_core/base/command_line.h"
#include "bt_core/base/outcome.h"
#include "bt_core/live/client/client_types.h"

namespace coppice {

struct NamedCommand {
  std::string option;  ///< "--break dock/Retry"; for messages
  LiveCommand command;
  /// A node instead: what others have set there is to be removed.
  std::string unhooked;
};

/// In the order in which they are sent: hooks first, then what lets the tree go on.
Expected<std::vector<NamedCommand>> ReadCommands(const Options& options);

/// "dock/Drive=FAILUREx3": a result that is forced on a node, three times; without x3 for ever.
/// Nothing else of the hook is set. False if the text is none.
bool ReadInjection(const std::string& text, Hook& hook);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_LIVE_LIVE_COMMANDS_H_
