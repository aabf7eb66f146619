#include "editor/document/search.h"

#include <algorithm>
#include <utility>

#include "bt_core/model/attribute_edits.h"
#include "bt_core/model/element_edits.h"
#include "bt_core/model/xml_text.h"
#include "editor/document/key_names.h"

namespace coppice::editor {

namespace {

constexpr std::pair<const char*, TextRole> kRoles[] = {{"type", TextRole::kType},
                                                       {"name", TextRole::kName},
                                                       {"port", TextRole::kPort},
                                                       {"value", TextRole::kValue},
                                                       {"key", TextRole::kKey}};

std::optional<TextRole> TakeRole(std::string_view& typed) {
  for (const auto& [word, role] : kRoles) {
    const std::string prefix = std::string(word) + ":";
    if (typed.substr(0, prefix.size()) != prefix) continue;
    typed.remove_prefix(prefix.size());
    return role;
  }
  return std::nullopt;
}

bool HasCapitals(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
}

class Searcher {
 public:
  Searcher(const ProjectFiles& files, const NodeModels& models, const Query& query,
           std::size_t limit)
      : files_(files), models_(models), query_(query), limit_(limit) {}

  std::vector<Match> Run() {
    for (file_ = 0; file_ < files_.size(); ++file_) {
      if (query_.is_for_keys()) {
        FindKeys();
        continue;
      }
      for (ElementIndex i{0}; i < files_[file_].elements().size(); ++i) {
        const ElementIndex tree = TreeOf(files_[file_], i);
        if (tree != kNoElement) LookAt(i, tree == i);
      }
    }
    return std::move(matches_);
  }

 private:
  void FindKeys() {
    for (ElementIndex i{0}; i < files_[file_].elements().size(); ++i) {
      if (files_[file_].element(i).tag != "BehaviorTree") continue;
      for (const KeyName& name : KeyNamesIn(files_[file_], models_, i)) {
        const Attribute* attribute =
            files_[file_].FindAttribute(files_[file_].element(name.element), name.attribute);
        if (query_.pattern().In(name.key).empty() || IsLast(name.element, name.attribute)) continue;
        Add(name.element, TextRole::kKey, attribute->value, attribute->value_offset,
            name.attribute);
      }
    }
  }

  bool IsLast(ElementIndex element, std::string_view attribute) const {
    return !matches_.empty() && matches_.back().file == file_ &&
           matches_.back().element == element && matches_.back().attribute == attribute;
  }

  void LookAt(ElementIndex index, bool is_tree) {
    const Document& document = files_[file_];
    const Element& element = document.element(index);
    if (!is_tree) Try(index, TextRole::kType, element.tag, element.offset + 1, {});
    for (const Attribute* a = document.attributes_begin(element);
         a != document.attributes_end(element); ++a) {
      if (a->name == "ID" || a->name == "name") {
        const TextRole role = a->name == "ID" ? TextRole::kType : TextRole::kName;
        Try(index, role, a->value, a->value_offset, a->name);
        continue;
      }
      Try(index, TextRole::kPort, a->name, a->name_offset, a->name);
      Try(index, TextRole::kValue, a->value, a->value_offset, a->name);
    }
  }

  void Try(ElementIndex element, TextRole role, std::string_view text, std::uint32_t offset,
           std::string_view attribute) {
    if (query_.Wants(role) && !query_.pattern().In(text).empty()) {
      Add(element, role, text, offset, attribute);
    }
  }

  void Add(ElementIndex element, TextRole role, std::string_view text, std::uint32_t offset,
           std::string_view attribute) {
    if (matches_.size() >= limit_) return;
    matches_.push_back({file_, element, role, std::string(text), offset, std::string(attribute)});
  }

  const ProjectFiles& files_;
  const NodeModels& models_;
  const Query& query_;
  const std::size_t limit_;
  std::size_t file_ = 0;
  std::vector<Match> matches_;
};

Edit EditOf(const Document& document, const Match& match, const std::string& after) {
  if (match.attribute.empty()) return SetTag(document, match.element, after);
  if (match.role == TextRole::kPort) {
    return RenameAttribute(document, match.element, match.attribute, after);
  }
  return SetAttribute(document, match.element, match.attribute, after);
}

}  // namespace

const char* ToString(TextRole role) {
  for (const auto& [word, one] : kRoles) {
    if (one == role) return word;
  }
  return "";
}

Expected<Query> ParseQuery(std::string_view typed) {
  const std::optional<TextRole> role = TakeRole(typed);
  if (typed.empty()) return Problem{"type something"};
  const bool fold_case = !HasCapitals(typed);
  if (typed.size() < 3 || typed.front() != '/' || typed.back() != '/') {
    return Query(role, SearchPattern::Literal(typed, fold_case));
  }
  auto pattern = SearchPattern::Regular(typed.substr(1, typed.size() - 2), fold_case);
  if (pattern) return Query(role, *std::move(pattern));
  return Problem{"this is no regular expression, or one that takes too long"};
}

std::vector<Match> Search(const ProjectFiles& files, const NodeModels& models, const Query& query,
                          std::size_t limit) {
  return Searcher(files, models, query, limit).Run();
}

std::string Replaced(const Match& match, const Query& query, const std::string& with) {
  std::string after;
  std::size_t at = 0;
  for (const SearchPattern::Found& found : query.pattern().In(match.before, with)) {
    after += match.before.substr(at, found.begin - at) + found.with;
    at = found.end;
  }
  return after + match.before.substr(at);
}

std::vector<Edit> Replace(const ProjectFiles& files, const std::vector<Match>& matches,
                          const Query& query, const std::string& with) {
  std::vector<Edit> edits(files.size());
  for (const Match& match : matches) {
    edits[match.file] = Merge(std::move(edits[match.file]),
                              EditOf(files[match.file], match, Replaced(match, query, with)));
  }
  return edits;
}

}  // namespace coppice::editor
