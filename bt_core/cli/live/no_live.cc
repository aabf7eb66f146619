// The verbs that need the live socket, without it (-DCOPPICE_LIVE=OFF).
#include <iostream>

#include "bt_core/cli/verbs.h"

namespace coppice {
namespace {

int Refuse(const Command& command, const Arguments& arguments) {
  const Options options = ParseOptions(command, arguments);
  return options.exit ? *options.exit : RefuseOptions(command, "built without the live view");
}

}  // namespace

const Command& LiveVerbCommand() {
  static const Command command{
      "coppice live", "watch and debug a robot (not in this build)", {"", 0, kAnyNumber}, "", {}};
  return command;
}

const Command& RecordCommand() {
  static const Command command{
      "coppice record", "record a robot (not in this build)", {"", 0, kAnyNumber}, "", {}};
  return command;
}

int RunLive(const Arguments& arguments) { return Refuse(LiveVerbCommand(), arguments); }
int RunRecord(const Arguments& arguments) { return Refuse(RecordCommand(), arguments); }

}  // namespace coppice
