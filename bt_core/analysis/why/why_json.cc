#include "bt_core/analysis/why/why_text.h"
#include "bt_core/base/json.h"
#include "bt_core/data/value_bytes.h"

namespace coppice {
namespace {

std::string ToJson(const WhyValue& value) {
  JsonObject object;
  object.AddText("name", value.name).AddText("key", value.key);
  object.Add("value", ValueBytesToJson(value.value));
  if (value.before) object.Add("before", ValueBytesToJson(*value.before));
  return object.Finish();
}

std::string ToJson(const std::vector<WhyValue>& values) {
  return JsonArray(values, [](const WhyValue& value) { return ToJson(value); });
}

std::string ToJson(const WhyScript& script) {
  JsonObject object;
  object.AddText("attribute", script.attribute).AddText("text", script.text);
  if (script.answer) object.AddBool("answer", *script.answer);
  return object.Add("values", ToJson(script.values)).Finish();
}

const char* ToString(WhyCause cause) {
  switch (cause) {
    case WhyCause::kOwn:
      return "own";
    case WhyCause::kChild:
      return "child";
    case WhyCause::kGuard:
      return "guard";
    case WhyCause::kScript:
      return "script";
    case WhyCause::kException:
      return "exception";
    case WhyCause::kInjected:
      return "injected";
    case WhyCause::kHalted:
      return "halted";
  }
  return "";
}

const char* ToString(WhyNot::Cause cause) {
  switch (cause) {
    case WhyNot::Cause::kNoTick:
      return "no_tick";
    case WhyNot::Cause::kChild:
      return "child";
    case WhyNot::Cause::kDone:
      return "done";
    case WhyNot::Cause::kPassedOver:
      return "passed_over";
    case WhyNot::Cause::kOwn:
      return "own";
    case WhyNot::Cause::kInjected:
      return "injected";
    case WhyNot::Cause::kNotWhole:
      return "not_whole";
    case WhyNot::Cause::kAborted:
      return "aborted";
    case WhyNot::Cause::kNotTold:
      return "not_told";
  }
  return "";
}

std::string ToJson(const RecordedTree& tree, const WhyStep& step) {
  JsonObject object;
  object.AddText("node", tree.PathOf(step.node)).Add("depth", std::uint64_t{step.depth});
  object.AddText("result", ToString(step.result));
  if (step.before) object.AddText("before", ToString(*step.before));
  object.AddText("cause", ToString(step.cause));
  if (step.decisive != kNoNode) object.AddText("child", tree.PathOf(step.decisive));
  if (step.script) object.Add("script", ToJson(*step.script));
  if (!step.values.empty()) object.Add("values", ToJson(step.values));
  if (!step.messages.empty()) object.Add("messages", JsonArray(step.messages, JsonString));
  if (!step.text.empty()) object.AddText("exception", step.text);
  return object.Finish();
}

std::string ToJson(const RecordedTree& tree, const WhyNot& why_not) {
  JsonObject object;
  object.AddText("cause", ToString(why_not.cause)).AddText("by", tree.PathOf(why_not.by));
  object.AddText("towards", tree.PathOf(why_not.towards));
  if (why_not.child != kNoNode) object.AddText("child", tree.PathOf(why_not.child));
  object.AddText("status", ToString(why_not.status));
  return object.AddText("text", SentenceOf(tree, why_not)).Finish();
}

}  // namespace

std::string WhyToJson(const RecordedTree& tree, const Why& why, Time start) {
  JsonObject object;
  object.Add("tick", why.tick).Add("time", JsonSeconds(why.time - start));
  object.AddText("node", tree.PathOf(why.node)).AddText("status", ToString(why.status));
  if (!why.is_untold()) object.AddBool("ticked", why.was_ticked);
  if (why.why_not) object.Add("why_not", ToJson(tree, *why.why_not));
  object.Add("steps",
             JsonArray(why.steps, [&](const WhyStep& step) { return ToJson(tree, step); }));
  if (why.change) object.Add("first_change", ToJson(tree, why.change->step));
  return object.Finish();
}

}  // namespace coppice
