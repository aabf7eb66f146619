#include "bt_core/analysis/why/why_text.h"

#include <cstdio>

#include "bt_core/data/value_bytes.h"

namespace coppice {
namespace {

std::string Quoted(const std::string& text) { return "\"" + text + "\""; }

std::string Printed(const std::string& bytes) {
  const ValueForm form = FormOfValue(bytes);
  if (form == ValueForm::kEmpty) return "(no value)";
  return form == ValueForm::kText ? "'" + PrintValueBytes(bytes) + "'" : PrintValueBytes(bytes);
}

std::string Print(const WhyValue& value) {
  const std::string name =
      value.name == value.key ? value.key : value.name + " {" + value.key + "}";
  std::string text = name + " = " + Printed(value.value);
  if (value.has_changed()) text += " (was " + Printed(*value.before) + ")";
  return text;
}

std::string Print(const std::vector<WhyValue>& values) {
  std::string text;
  for (const WhyValue& value : values) text += (text.empty() ? "" : ", ") + Print(value);
  return text;
}

std::string With(const std::vector<WhyValue>& values, const char* before) {
  return values.empty() ? "" : before + Print(values);
}

std::string Print(const WhyScript& script) {
  std::string text = script.attribute + "=" + Quoted(script.text);
  if (script.answer) text += *script.answer ? " is true" : " is false";
  return text + With(script.values, ": ");
}

std::string CauseOf(const RecordedTree& tree, const WhyStep& step) {
  switch (step.cause) {
    case WhyCause::kChild:
      return "because of " + Quoted(tree.NameOf(step.decisive));
    case WhyCause::kGuard:
      return "not ticked, " + Print(*step.script);
    case WhyCause::kScript:
      return Print(*step.script);
    case WhyCause::kException:
      return "threw: " + step.text;
    case WhyCause::kInjected:
      return "injected from outside";
    case WhyCause::kHalted:
      return "halted";
    case WhyCause::kOwn:
      return "";
  }
  return "";
}

std::string Seconds(Duration time) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6f", static_cast<double>(time.count()) * 1e-9);
  return text;
}

void AppendStep(const RecordedTree& tree, const WhyStep& step, std::string& text) {
  const bool is_new = !step.before || *step.before != step.result;
  const bool is_halt = step.cause == WhyCause::kHalted;
  text += step.is_asked ? "> " : "  ";
  text += std::string(2 * static_cast<std::size_t>(step.depth), ' ') + tree.NameOf(step.node);
  if (!is_halt) text += std::string("  ") + ToString(step.result);
  if (!is_halt && step.before && is_new)
    text += std::string(" (was ") + ToString(*step.before) + ")";
  const std::string reason = ReasonOf(tree, step);
  text += (reason.empty() ? "" : "  " + reason) + "\n";
}

}  // namespace

std::string ReasonOf(const RecordedTree& tree, const WhyStep& step) {
  std::string text = CauseOf(tree, step);
  const std::string values = Print(step.values);
  if (!values.empty()) text += (text.empty() ? "" : "; ") + values;
  for (const std::string& message : step.messages) {
    text += (text.empty() ? "says: " : "; says: ") + message;
  }
  return text;
}

std::string SentenceOf(const RecordedTree& tree, const WhyNot& why_not) {
  const std::string by = Quoted(tree.PathOf(why_not.by));
  const std::string towards = Quoted(tree.NameOf(why_not.towards));
  const std::string status = ToString(why_not.status);
  switch (why_not.cause) {
    case WhyNot::Cause::kNoTick:
      return "the tree was not ticked then";
    case WhyNot::Cause::kChild:
      return by + " did not reach " + towards + ", because " + Quoted(tree.NameOf(why_not.child)) +
             ", which comes before it, is " + status;
    case WhyNot::Cause::kDone:
      return by + " did not tick " + towards + " again, because it is already " + status;
    case WhyNot::Cause::kPassedOver:
      return by + " did not choose " + towards + "; it ticked " +
             Quoted(tree.NameOf(why_not.child)) + ", which is " + status;
    case WhyNot::Cause::kOwn:
      return by + " ticked none of its children and is " + status;
    case WhyNot::Cause::kInjected:
      return by + " was made " + status + " from outside, without being ticked";
    case WhyNot::Cause::kNotWhole:
      return "the tick has stopped at a breakpoint";
    case WhyNot::Cause::kAborted:
      return "an exception thrown by " + by + " ended the tick";
    case WhyNot::Cause::kNotTold:
      return "this run holds status changes only, and " + towards +
             " had none; it may have been ticked";
  }
  return "";
}

std::string SentenceOf(const RecordedTree& tree, const WhyChange& change) {
  std::string text = Quoted(tree.PathOf(change.step.node)) + " is " + ToString(change.step.result);
  text += change.was_ticked_before
              ? std::string(" and was ") + ToString(*change.step.before) + " before"
              : std::string(" and was not ticked before");
  const std::string reason = ReasonOf(tree, change.step);
  return reason.empty() ? text : text + "; " + reason;
}

std::string PrintWhy(const RecordedTree& tree, const Why& why, Time start) {
  std::string text = Quoted(tree.PathOf(why.node)) + " is " + ToString(why.status) +
                     " after tick " + std::to_string(why.tick) + " (" + Seconds(why.time - start) +
                     " s)";
  text += why.was_ticked || why.is_untold() ? "\n" : " and was not ticked\n";
  if (why.why_not) {
    text += (why.is_untold() ? "" : "why not: ") + SentenceOf(tree, *why.why_not) + "\n";
  }
  for (const WhyStep& step : why.steps) AppendStep(tree, step, text);
  if (why.change) {
    text += "first change: " + SentenceOf(tree, *why.change) + "\n";
  } else if (!why.steps.empty()) {
    text += "up to here, every node returned the same as in the tick before\n";
  }
  return text;
}

}  // namespace coppice
