#include "editor/live/key_writes.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bt_core/data/value_bytes.h"
#include "editor/live/key_item.h"

namespace coppice::editor {
namespace {

using Json = nlohmann::json;

constexpr char kAnyType[] = "any";       // of a key that only scripts use
constexpr std::size_t kTicksToShow = 2;  // one may have begun before the value came

// JSON of a value like the present one, which is plain.
Expected<std::string> JsonLike(ValueForm present, const std::string& text) {
  if (present == ValueForm::kText) {
    return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  const Json json = Json::parse(text, nullptr, false);
  if (present == ValueForm::kBool) {
    if (json.is_boolean()) return text;
    return Problem{"\"" + text + "\" is neither true nor false"};
  }
  if (present == ValueForm::kDouble) {
    if (json.is_number()) return Json(json.get<double>()).dump();
    return Problem{"\"" + text + "\" is not a number"};
  }
  if (json.is_number_integer()) return json.dump();
  return Problem{"\"" + text + "\" is not a whole number"};
}

bool IsPlain(ValueForm form) {
  return form == ValueForm::kText || form == ValueForm::kBool || form == ValueForm::kSigned ||
         form == ValueForm::kUnsigned || form == ValueForm::kDouble;
}

std::string ValueIn(const RunView& view, SlotIndex slot) {
  const auto& values = view.follower().values();
  return slot < values.size() ? values[slot] : std::string();
}

}  // namespace

Expected<LiveCommand> WriteOf(const TreeDescription& tree, SlotIndex slot,
                              const std::string& present, const std::string& text) {
  const DescribedSlot& described = tree.slots[slot];
  LiveCommand command =
      WriteKey(described.scope == tree.main_tree ? "" : described.scope, described.name, text);
  const ValueForm form = FormOfValue(present);
  if (described.type != kAnyType || !IsPlain(form)) return command;
  Expected<std::string> json = JsonLike(form, text);
  if (!json) return Problem{json.problem()};
  command.value = *std::move(json);
  command.is_json = true;
  return command;
}

std::optional<std::string> TextOf(const LiveCommand& write) {
  const Json json = write.is_json ? Json::parse(write.value, nullptr, false) : Json();
  if (!json.is_string()) return std::nullopt;
  return json.get<std::string>();
}

Outcome KeyWrites::Send(RunView& view, SlotIndex slot, const std::string& text) {
  const TreeDescription& tree = *view.tree()->description();
  if (slot >= tree.slots.size()) return Problem{"the key no longer exists"};
  Expected<LiveCommand> command = WriteOf(tree, slot, ValueIn(view, slot), text);
  if (!command) return Problem{command.problem()};
  const Run& run = view.run();
  const Tracks& newest = run.TracksAt(run.size());
  const std::size_t writes = slot < newest.tree()->slots.size() ? newest.WritesOf(slot).size() : 0;
  const std::string path = ItemOfKey(tree.slots[slot]);
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(),
                                [&](const Waiting& other) {
                                  return other.run == view.name() && other.path == path;
                                }),
                 waiting_.end());
  auto is_refused = std::make_shared<bool>(false);
  waiting_.push_back({view.name(), path, run.size(), writes, is_refused});
  view.Send(*std::move(command), [is_refused] { *is_refused = true; });
  return {};
}

bool KeyWrites::IsWaiting(const RunView& view, SlotIndex slot) const {
  if (waiting_.empty()) return false;
  const Run& run = view.run();
  const Tracks& newest = run.TracksAt(run.size());
  if (slot >= newest.tree()->slots.size()) return false;
  const std::string path = ItemOfKey(newest.tree()->slots[slot]);
  return std::any_of(waiting_.begin(), waiting_.end(), [&](const Waiting& waiting) {
    return waiting.run == view.name() && waiting.path == path && !*waiting.is_refused &&
           newest.WritesOf(slot).size() == waiting.writes && run.size() >= waiting.ticks &&
           run.size() < waiting.ticks + kTicksToShow;
  });
}

}  // namespace coppice::editor
