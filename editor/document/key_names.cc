#include "editor/document/key_names.h"

#include <algorithm>
#include <set>

#include "bt_core/model/keys.h"
#include "bt_core/model/upgrade.h"
#include "bt_core/model/xml_text.h"
#include "bt_core/nodes/guards.h"
#include "bt_core/script/token.h"
#include "editor/document/draft.h"
#include "editor/document/node_rules.h"
#include "editor/scene/script_words.h"

namespace coppice::editor {
namespace {

using script::Token;
using script::TokenKind;

bool IsInCapitals(std::string_view word) {
  return std::all_of(word.begin(), word.end(), [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

// Where what stands in a value is written, from one place to the next.
class RawPlace {
 public:
  RawPlace(const Document& document, const Attribute& attribute)
      : begin_(attribute.value_offset), raw_(document.RawValue(attribute)) {}

  std::uint32_t Of(std::size_t decoded) {
    if (decoded < decoded_) raw_at_ = decoded_ = 0;
    raw_at_ += RawOffset(raw_.substr(raw_at_), decoded - decoded_);
    decoded_ = decoded;
    return begin_ + static_cast<std::uint32_t>(raw_at_);
  }

 private:
  const std::uint32_t begin_;
  const std::string_view raw_;
  std::size_t raw_at_ = 0;
  std::size_t decoded_ = 0;
};

class Collector {
 public:
  Collector(const Document& document, const NodeModels& models)
      : document_(document), models_(models), is_format_3_(IsFormat3(document)) {}

  std::vector<KeyName> Run(ElementIndex branch) {
    const ElementIndex end = EndOfBranch(document_, branch);
    for (ElementIndex i = branch; i < end; ++i) {
      if (IsNode(document_, i)) AddElement(i);
    }
    DropConstants();
    return std::move(names_);
  }

 private:
  void AddElement(ElementIndex index) {
    const Element& element = document_.element(index);
    const NodeModel* model = models_.Find(TypeOf(document_, index));
    const bool is_subtree = element.tag == "SubTree" || element.tag == "SubTreePlus";
    for (const Attribute* a = document_.attributes_begin(element);
         a != document_.attributes_end(element); ++a) {
      const PortModel* port = model && !is_subtree ? model->FindPort(a->name) : nullptr;
      if (IsGuardAttribute(a->name) || (port && port->type == "script")) {
        AddScript(index, *a);
      } else {
        AddPort(index, *a, port, is_subtree);
      }
    }
  }

  void AddPort(ElementIndex element, const Attribute& attribute, const PortModel* port,
               bool is_subtree) {
    if (IsReservedAttribute(attribute.name)) return;
    KeyName name;
    const Element& of = document_.element(element);
    std::string_view key = KeyHandedOn(of, attribute, is_format_3_);
    if (!key.empty() && KeyOf(attribute.value, attribute.name).empty()) name.form = KeyForm::kPlain;
    if (key.empty() && port && port->name == "output_key") {
      name.form = KeyForm::kPlain;
      key = attribute.value;
    }
    if (key.empty()) return;
    name.reads = !is_subtree && (!port || port->direction != PortDirection::kOutput);
    name.writes = !is_subtree && port && port->direction != PortDirection::kInput;
    name.guessed = !is_subtree && !port;
    Add(std::move(name), key, element, attribute);
    names_.back().begin = attribute.value_offset;
    names_.back().end = attribute.value_end;
  }

  void Add(KeyName name, std::string_view key, ElementIndex element, const Attribute& attribute) {
    name.is_global = key.front() == '@';
    name.key = key.substr(name.is_global ? 1 : 0);
    name.element = element;
    name.attribute = attribute.name;
    names_.push_back(std::move(name));
  }

  void AddScript(ElementIndex element, const Attribute& attribute) {
    RawPlace place(document_, attribute);
    for (const ScriptWord& word : WordsOf(attribute.value)) {
      KeyName name;
      name.form = KeyForm::kScript;
      name.writes = word.writes;
      name.reads = word.reads;
      Add(std::move(name), word.text, element, attribute);
      names_.back().begin = place.Of(word.offset);
      names_.back().end = place.Of(word.offset + word.text.size());
      if (names_.back().writes) written_.insert(names_.back().key);
    }
  }

  void DropConstants() {
    for (const KeyName& name : names_) {
      if (name.form != KeyForm::kScript) written_.insert(name.key);
    }
    const auto is_constant = [this](const KeyName& name) {
      return name.form == KeyForm::kScript && IsInCapitals(name.key) &&
             written_.count(name.key) == 0;
    };
    names_.erase(std::remove_if(names_.begin(), names_.end(), is_constant), names_.end());
  }

  const Document& document_;
  const NodeModels& models_;
  const bool is_format_3_;
  std::vector<KeyName> names_;
  std::set<std::string, std::less<>> written_;
};

}  // namespace

ElementIndex EndOfBranch(const Document& document, ElementIndex element) {
  const std::vector<Element>& all = document.elements();  // in the order of the text
  const Element& branch = document.element(element);
  const auto behind = std::lower_bound(
      all.begin() + static_cast<std::ptrdiff_t>(element) + 1, all.end(), branch.end,
      [](const Element& one, std::uint32_t end) { return one.offset < end; });
  return static_cast<ElementIndex>(behind - all.begin());
}

std::vector<KeyName> KeyNamesIn(const Document& document, const NodeModels& models,
                                ElementIndex branch) {
  return Collector(document, models).Run(branch);
}

std::string_view KeyHandedOn(const Element& element, const Attribute& attribute, bool is_format_3) {
  const std::string_view key = KeyOf(attribute.value, attribute.name);
  const bool may_be_plain = is_format_3 && element.tag == "SubTree" && key.empty();
  return may_be_plain && IsKeyName(attribute.value) ? std::string_view(attribute.value) : key;
}

Splice WithKey(const KeyName& name, std::string_view key) {
  const std::string text(key);
  return Replacement(name.begin, name.end, name.form == KeyForm::kBraces ? "{" + text + "}" : text);
}

bool IsKeyName(std::string_view text) {
  std::vector<ScriptProblem> problems;
  const std::vector<Token> tokens = script::Tokenize(text, problems);
  return problems.empty() && tokens.size() == 2 && tokens[0].kind == TokenKind::kName &&
         tokens[0].text.size() == text.size();
}

}  // namespace coppice::editor
