#include "bt_core/live/client/client_types.h"

#include <cstdlib>
#include <utility>

#include "bt_core/live/server/token_keys.h"

namespace coppice {

LiveCommand MakeCommand(LiveCommand::Kind kind) {
  LiveCommand command;
  command.kind = kind;
  return command;
}

LiveCommand SetHook(Hook hook) {
  LiveCommand command = MakeCommand(LiveCommand::Kind::kAddHook);
  command.hook = std::move(hook);
  return command;
}

LiveCommand WriteKey(std::string scope, std::string key, std::string value) {
  LiveCommand command = MakeCommand(LiveCommand::Kind::kWrite);
  command.scope = std::move(scope);
  command.key = std::move(key);
  command.value = std::move(value);
  return command;
}

LiveReply FailedReply(std::string error) {
  LiveReply reply;
  reply.error = std::move(error);
  return reply;
}

std::string TokenFromEnvironment() {
  const char* const token = std::getenv(kTokenVariable);
  return token ? token : "";
}

}  // namespace coppice
