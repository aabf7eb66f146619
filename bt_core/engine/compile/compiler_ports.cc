#include "bt_core/engine/compile/compiler_ports.h"

#include <algorithm>
#include <string>
#include <utility>

#include "bt_core/model/keys.h"
#include "bt_core/model/upgrade.h"

namespace coppice {
namespace {

bool IsOfUser(const Registry::Entry& entry) {
  return entry.type == NodeType::kLeaf || entry.type == NodeType::kUser;
}

// A model, in contrast to a class, may not say all types, nor the right ones.
bool IsOnlyAModel(const Registry::Entry& entry) { return IsOfUser(entry) && !entry.build; }

// Groot 1 writes port="" for whatever is not given.
bool IsLeftEmpty(const PortDeclaration& port, std::string_view text) {
  return text.empty() && !port.required && port.direction != PortDirection::kInput;
}

bool IsScript(const PortDeclaration& port) { return port.type == &TypeOf<ScriptCode>(); }

// A port that is about a key and not about its value takes the plain name, too, as in
// BehaviorTree.CPP: output_key="x" is output_key="{x}".
bool IsAboutKey(const PortDeclaration& port) {
  return !port.type && !port.converts &&
         (port.direction == PortDirection::kOutput || port.name == "entry");
}

ScriptUse UseOf(NodeType type) {
  const bool asks = type == NodeType::kScriptCondition || type == NodeType::kPrecondition;
  return asks ? ScriptUse::kCondition : ScriptUse::kAction;
}

// What a port that can be written is given instead of a key.
std::string LostIn(const PortDeclaration& port, std::string_view text) {
  return "what is written to " + std::string(ToString(port.direction)) + " " + Quoted(port.name) +
         " is lost: " + Quoted(text) + " is no key";
}

bool HasBraces(std::string_view text) {
  const std::size_t open = text.find('{');
  return open != std::string_view::npos && text.find('}', open) != std::string_view::npos;
}

}  // namespace

void PortBinder::Bind(const Registry::Entry& entry, const Site& site,
                      std::vector<PortBinding>& ports) {
  CheckNames(entry, site);
  for (const PortDeclaration& port : entry.declarations) {
    ports.push_back(BindPort(entry, port, site));
  }
  BindCopies(entry, site, ports.data() + ports.size() - entry.declarations.size());
}

void PortBinder::BindCopies(const Registry::Entry& entry, const Site& site,
                            const PortBinding* ports) {
  if (IsOnlyAModel(entry)) return;
  SlotIndex from = kNoSlot;
  SlotIndex to = kNoSlot;
  for (std::size_t k = 0; k < entry.declarations.size(); ++k) {
    const PortDeclaration& port = entry.declarations[k];
    if (port.type || port.converts || port.direction == PortDirection::kMailbox) continue;
    (port.direction == PortDirection::kInput ? from : to) = ports[k].slot;
  }
  if (from != kNoSlot && to != kNoSlot) {
    types_.AddCopy(from, to, entry.manifest.id, {&site.document, site.element.offset});
  }
}

void PortBinder::CheckNames(const Registry::Entry& entry, const Site& site) {
  const std::vector<PortDeclaration>& ports = entry.manifest.ports;
  for (const Attribute& attribute : site) {
    if (IsReservedAttribute(attribute.name)) continue;
    const auto is_meant = [&](const PortDeclaration& port) { return port.name == attribute.name; };
    if (std::any_of(ports.begin(), ports.end(), is_meant)) continue;
    const auto name_of = [](const PortDeclaration& port) { return port.name; };
    const std::string_view now = PortNameInFormat4(entry.manifest.id, attribute.name);
    problems_.Error(site.document, attribute.name_offset,
                    entry.manifest.id + " has no port " + Quoted(attribute.name),
                    now.empty() ? problems_.Advise(attribute.name, ports, name_of)
                                : "in format 4 it is " + std::string(now),
                    {ProblemKind::kUnknownPort, std::string(attribute.name)});
  }
}

PortBinding PortBinder::BindPort(const Registry::Entry& entry, const PortDeclaration& port,
                                 const Site& site) {
  if (port.direction == PortDirection::kMailbox) return {keys_.AddSlot("", site.scope, port.type)};
  const Attribute* attribute = site.document.FindAttribute(site.element, port.name);
  if (attribute && IsLeftEmpty(port, attribute->value)) attribute = nullptr;
  if (!attribute && !port.default_text) {
    if (port.required) {
      problems_.Error(site.document, site.element.offset,
                      entry.manifest.id + " needs its port " + Quoted(port.name), port.description,
                      {ProblemKind::kMissingPort, port.name});
    }
    return {};
  }
  const Given given{entry,
                    port,
                    site,
                    attribute,
                    attribute ? attribute->value : std::string_view(*port.default_text),
                    attribute ? attribute->value_offset : site.element.offset};
  if (IsScript(port)) return {kNoSlot, BindScript(given)};
  const std::string_view key = KeyOf(given.text, port.name);
  if (!key.empty()) return {BindKey(given, key)};
  if (IsAboutKey(port) && !given.text.empty() && !HasBraces(given.text) && given.text != "@") {
    return {BindKey(given, given.text)};
  }
  return {BindLiteral(given)};
}

ScriptIndex PortBinder::BindScript(const Given& given) {
  const ScriptUse use = UseOf(given.entry.type);
  return given.attribute ? scripts_.Add(given.site, *given.attribute, use)
                         : scripts_.AddDefault(given.site, given.text, use);
}

SlotIndex PortBinder::BindKey(const Given& given, std::string_view key) {
  const SlotIndex slot = keys_.Resolve(key, given.site.scope);
  if (given.port.converts) {
    types_.Declare(slot);
  } else {
    types_.Set(slot, given.entry.manifest.id, given.port, {&given.site.document, given.offset},
               IsOnlyAModel(given.entry));
  }
  return slot;
}

SlotIndex PortBinder::BindLiteral(const Given& given) {
  const PortDeclaration& port = given.port;
  if (port.converts) {
    return keys_.AddSlot("", given.site.scope, nullptr, Value(std::string(given.text)));
  }
  if (port.direction == PortDirection::kOutput) return ReportNoKey(given);
  if (port.direction == PortDirection::kInOut) {
    problems_.Warning(given.site.document, given.offset, LostIn(given.port, given.text),
                      "write {key}");
  }
  const bool is_json = given.text.compare(0, 5, "json:") == 0;
  if (port.type != &TypeOf<std::string>() && HasBraces(given.text) && !is_json) {
    problems_.Warning(given.site.document, given.offset,
                      Quoted(given.text) + " is taken as it stands",
                      "a key is the whole text, as in \"{key}\", or none of it");
  }
  if (!port.type) return BindUntypedLiteral(given);
  Value value;
  if (!value.Parse(*port.type, given.text)) ReportLiteral(given);
  return keys_.AddSlot("", given.site.scope, port.type, std::move(value));
}

// What an output of texts, or of anything, is given is easily taken for a literal; robots run so.
SlotIndex PortBinder::ReportNoKey(const Given& given) {
  const Type* const type = given.port.type;
  if (given.text.empty() || (type && type != &TypeOf<std::string>())) {
    problems_.Error(given.site.document, given.offset,
                    "output " + Quoted(given.port.name) + " needs a key", "write {key}");
  } else {
    problems_.Warning(given.site.document, given.offset, LostIn(given.port, given.text),
                      "write {key}");
  }
  return kNoSlot;
}

SlotIndex PortBinder::BindUntypedLiteral(const Given& given) {
  const SlotIndex slot = keys_.AddSlot("", given.site.scope, nullptr);
  types_.AddLiteral(slot, given.text, "port " + Quoted(given.port.name),
                    {&given.site.document, given.offset});
  return slot;
}

void PortBinder::ReportLiteral(const Given& given) {
  std::string hint = ExpectedText(*given.port.type);
  if (given.text.empty() && given.port.default_text) {
    hint += "; without the attribute it is " + *given.port.default_text;
  }
  if (IsList(*given.port.type) && given.text.find(',') != given.text.npos) {
    hint += "; its elements are separated by semicolons";
  }
  problems_.Error(given.site.document, given.offset,
                  Quoted(given.text) + " is not a value for port " + Quoted(given.port.name) +
                      " of " + given.entry.manifest.id,
                  std::move(hint));
}

}  // namespace coppice
