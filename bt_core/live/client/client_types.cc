#include "bt_core/live/client/client_types.h"

#include <cstdio>
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

std::string ToString(const Hook& hook) {
  std::string text;
  if (hook.action == HookAction::kStop) {
    text = hook.position == HookPosition::kBefore ? "before" : "after";
  } else if (hook.action == HookAction::kReplace) {
    text = ToString(hook.status);
  } else {
    char seconds[32];
    std::snprintf(seconds, sizeof(seconds), "delay %.3g s",
                  static_cast<double>(hook.delay.count()) * 1e-9);
    text = seconds;
  }
  if (hook.times > 0) text += " x" + std::to_string(hook.times);
  if (!hook.condition.empty()) text += ", if " + hook.condition;
  if (hook.from_hit > 1) text += ", from hit " + std::to_string(hook.from_hit) + " on";
  return text;
}

std::string TokenFromEnvironment() {
  const char* const token = std::getenv(kTokenVariable);
  return token ? token : "";
}

}  // namespace coppice
