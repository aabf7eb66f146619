#include "bt_core/cli/live/live_commands.h"

#include <charconv>
#include <chrono>
#include <utility>

namespace coppice {
namespace {

using Kind = LiveCommand::Kind;

bool ReadNumber(std::string_view text, std::uint32_t& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

bool ReadResult(std::string_view text, Status& status) {
  for (const Status known :
       {Status::kRunning, Status::kSuccess, Status::kFailure, Status::kSkipped}) {
    if (text != ToString(known)) continue;
    status = known;
    return true;
  }
  return false;
}

// "PATH=WHAT"; false if one of them is missing.
bool Split(const std::string& text, std::string& path, std::string& what) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) return false;
  path = text.substr(0, equals);
  what = text.substr(equals + 1);
  return true;
}

class Reader {
 public:
  explicit Reader(const Options& options) : options_(options) {}

  Expected<std::vector<NamedCommand>> Read() {
    for (const std::string& path : options_.GetAll("--unhook")) {
      commands_.push_back({"--unhook " + path, {}, path});
    }
    ReadBreakpoints();
    for (const std::string& text : options_.GetAll("--inject")) ReadInjected(text);
    for (const std::string& text : options_.GetAll("--delay")) ReadDelay(text);
    for (const std::string& text : options_.GetAll("--set")) ReadValue(text);
    Add("--pause", Kind::kPause);
    Add("--step-node", Kind::kStepNode);
    Add("--step", Kind::kStepTick);
    Add("--continue", Kind::kContinue);
    if (!problem_.text.empty()) return std::move(problem_);
    return std::move(commands_);
  }

 private:
  void Add(const char* option, Kind kind) {
    if (options_.Has(option)) commands_.push_back({option, MakeCommand(kind), {}});
  }
  void Add(const std::string& option, const std::string& text, LiveCommand command) {
    commands_.push_back({option + " " + text, std::move(command), {}});
  }

  // The first --if belongs to the first --break, and so on.
  void ReadBreakpoints() {
    const std::vector<std::string> paths = options_.GetAll("--break");
    const std::vector<std::string> conditions = options_.GetAll("--if");
    if (conditions.size() > paths.size()) problem_ = {"each --if needs a --break"};
    for (std::size_t i = 0; i < paths.size(); ++i) {
      Hook hook;
      hook.path = paths[i];
      if (i < conditions.size()) hook.condition = conditions[i];
      Add("--break", paths[i], SetHook(std::move(hook)));
    }
  }

  void ReadInjected(const std::string& text) {
    Hook hook;
    if (ReadInjection(text, hook)) return Add("--inject", text, SetHook(std::move(hook)));
    problem_ = {"--inject " + text +
                ": expected PATH=STATUS or PATH=STATUSxN; STATUS is RUNNING, " +
                "SUCCESS, FAILURE or SKIPPED"};
  }

  void ReadDelay(const std::string& text) {
    Hook hook;
    std::string milliseconds;
    std::uint32_t number = 0;
    if (!Split(text, hook.path, milliseconds) || !ReadNumber(milliseconds, number) || number == 0) {
      problem_ = {"--delay " + text + ": expected PATH=MILLISECONDS"};
      return;
    }
    hook.action = HookAction::kDelay;
    hook.delay = std::chrono::milliseconds(number);
    Add("--delay", text, SetHook(std::move(hook)));
  }

  void ReadValue(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
      problem_ = {"--set " + text + ": expected KEY=VALUE or SUBTREE/KEY=VALUE"};
      return;
    }
    const std::string key = text.substr(0, equals);
    const std::size_t slash = key.rfind('/');
    const std::string scope = slash == std::string::npos ? "" : key.substr(0, slash);
    Add("--set", text, WriteKey(scope, key.substr(slash + 1), text.substr(equals + 1)));
  }

  const Options& options_;
  Problem problem_;  // the last one
  std::vector<NamedCommand> commands_;
};

}  // namespace

bool ReadInjection(const std::string& text, Hook& hook) {
  std::string what;
  if (!Split(text, hook.path, what)) return false;
  hook.action = HookAction::kReplace;
  if (ReadResult(what, hook.status)) return true;
  const std::size_t x = what.rfind('x');
  return x != std::string::npos && ReadResult(what.substr(0, x), hook.status) &&
         ReadNumber(std::string_view(what).substr(x + 1), hook.times) && hook.times > 0;
}

Expected<std::vector<NamedCommand>> ReadCommands(const Options& options) {
  return Reader(options).Read();
}

}  // namespace coppice
