#include "bt_core/engine/compile/compiler_types.h"

#include <algorithm>
#include <utility>

#include "bt_core/data/enum.h"
#include "bt_core/data/literal.h"

namespace coppice {
namespace {

bool IsNumber(const Type& type) {
  return type.kind == TypeKind::kInt || type.kind == TypeKind::kUnsigned ||
         type.kind == TypeKind::kInt64 || type.kind == TypeKind::kUint64 ||
         type.kind == TypeKind::kFloat || type.kind == TypeKind::kDouble;
}

}  // namespace

std::string ExpectedText(const Type& type) {
  return "expected " + (type.enumerators ? Choices(*type.enumerators) : std::string(type.name));
}

bool IsList(const Type& type) { return std::string_view(type.name).substr(0, 8) == "list of "; }

void SlotTypes::Set(SlotIndex index, std::string_view owner, const PortDeclaration& port,
                    DocumentPlace place, bool may_convert) {
  SlotDefinition& slot = layout_.slots[index];
  if (!port.type) return;
  if (!slot.type) {
    slot.type = port.type;
    first_use_[index] = {owner, port.name};
  } else if (slot.type != port.type) {
    const FirstUse& first = first_use_.at(index);
    std::string message = "key " + Quoted(slot.key) + " is " + slot.type->name + " (from " +
                          std::string(first.owner) + "." + std::string(first.port) +
                          "), but port " + Quoted(port.name) + " of " + std::string(owner) +
                          " is " + port.type->name;
    const bool reads_text =
        slot.type == &TypeOf<std::string>() && port.direction == PortDirection::kInput;
    const bool converts = may_convert && reads_text;
    problems_.Add(converts ? Severity::kWarning : Severity::kError, *place.document, place.offset,
                  std::move(message),
                  converts ? "BehaviorTree.CPP converts the text whenever it is read" : "");
  }
}

void SlotTypes::Suggest(SlotIndex slot, const Type& type, DocumentPlace place) {
  suggestions_.push_back({slot, &type, place});
}

void SlotTypes::AddCopy(SlotIndex from, SlotIndex to, std::string_view owner, DocumentPlace place) {
  copies_.push_back({from, to, owner, place});
}

void SlotTypes::AddLiteral(SlotIndex slot, std::string_view text, std::string name,
                           DocumentPlace place) {
  literals_.push_back({slot, text, std::move(name), place});
}

void SlotTypes::Settle() {
  for (const Suggestion& suggestion : suggestions_) Settle(suggestion);
  SpreadAgainstCopies();
  for (const Copy& copy : copies_) Check(copy);
  for (const Literal& literal : literals_) Convert(literal);
}

void SlotTypes::Settle(const Suggestion& suggestion) {
  SlotDefinition& slot = layout_.slots[suggestion.slot];
  if (!slot.type) slot.type = suggestion.type;
  const bool numbers = IsNumber(*slot.type) && IsNumber(*suggestion.type);
  if (slot.type == suggestion.type || numbers) return;
  problems_.Warning(*suggestion.place.document, suggestion.place.offset,
                    std::string("the model says ") + suggestion.type->name + ", but it is " +
                        slot.type->name + " inside the tree");
}

void SlotTypes::SpreadAgainstCopies() {
  const auto by_target = [](const Copy& a, const Copy& b) { return a.to < b.to; };
  std::stable_sort(copies_.begin(), copies_.end(), by_target);
  std::vector<SlotIndex> typed;
  for (const Copy& copy : copies_) {
    if (layout_.slots[copy.to].type) typed.push_back(copy.to);
  }
  while (!typed.empty()) {
    Copy wanted{};
    wanted.to = typed.back();
    typed.pop_back();
    const auto [begin, end] = std::equal_range(copies_.begin(), copies_.end(), wanted, by_target);
    for (auto copy = begin; copy != end; ++copy) {
      SlotDefinition& from = layout_.slots[copy->from];
      if (from.type) continue;
      from.type = layout_.slots[copy->to].type;
      typed.push_back(copy->from);
    }
  }
}

void SlotTypes::Check(const Copy& copy) {
  const SlotDefinition& from = layout_.slots[copy.from];
  const SlotDefinition& to = layout_.slots[copy.to];
  if (!to.type || from.type == to.type) return;
  problems_.Error(*copy.place.document, copy.place.offset,
                  std::string(copy.owner) + " copies key " + Quoted(from.key) + ", which is " +
                      from.type->name + ", to key " + Quoted(to.key) + ", which is " +
                      to.type->name);
}

void SlotTypes::Convert(const Literal& literal) {
  SlotDefinition& slot = layout_.slots[literal.slot];
  if (!slot.type) {
    slot.initial = GuessValue(literal.text);
  } else if (!slot.initial.Parse(*slot.type, literal.text)) {
    problems_.Error(*literal.place.document, literal.place.offset,
                    Quoted(literal.text) + " is not a value for " + literal.name,
                    ExpectedText(*slot.type));
  }
}

}  // namespace coppice
