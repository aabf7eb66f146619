#include "editor/panels/popup/type_choices.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "bt_core/model/xml_text.h"
#include "editor/keys/fuzzy.h"
#include "editor/keys/recent.h"

namespace coppice::editor {
namespace {

constexpr int kNameBonus = 1;

class TypeCollector {
 public:
  TypeCollector(const EditorState& state, const std::string& typed)
      : recent_(state.recent.types), typed_(typed) {}

  void Offer(TypeChoice choice) {
    choice.score = Score(choice);
    if (choice.score == 0) return;
    // Among those that fit alike, what was used last comes first.
    choice.score += BonusOf(recent_, choice.type);
    choices_.push_back(std::move(choice));
  }

  // By name; else by a word of category or description, behind all that fit by name.
  int Score(const TypeChoice& choice) const {
    const int by_name = FuzzyScore(typed_, choice.type);
    if (by_name > 0) return by_name + kNameBonus;
    if (typed_.size() < 3) return 0;
    return Contains(choice.kind) || Contains(choice.note) ? 1 : 0;
  }

  bool Contains(const std::string& text) const {
    return std::search(text.begin(), text.end(), typed_.begin(), typed_.end(), [](char a, char b) {
             return std::tolower(static_cast<unsigned char>(a)) ==
                    std::tolower(static_cast<unsigned char>(b));
           }) != text.end();
  }

  std::vector<TypeChoice> Best(std::size_t limit) {
    std::stable_sort(choices_.begin(), choices_.end(),
                     [](const auto& a, const auto& b) { return a.score > b.score; });
    if (choices_.size() > limit) choices_.resize(limit);
    return std::move(choices_);
  }

 private:
  const std::vector<std::string>& recent_;
  const std::string& typed_;
  std::vector<TypeChoice> choices_;
};

void OfferTrees(const Forest& forest, const std::string& shown, TypeCollector& collector) {
  for (const TreeEntry& tree : forest.trees()) {
    if (tree.id.empty() || tree.id == shown) continue;
    collector.Offer({tree.id, "SubTree", "a tree of this project",
                     "<SubTree ID=\"" + EscapeXmlValue(tree.id, '"') + "\"/>"});
  }
}

// Neither a part of the language nor described by a model.
bool IsUnknown(std::string_view tag, const NodeModels& models) {
  return tag != "BehaviorTree" && tag != "include" && tag != "TreeNodesModel" &&
         tag != "SubTreePlus" && !CategoryFromTag(tag) && !models.Find(tag);
}

// Types that are used in the files although no model describes them.
void OfferUnknown(const Forest& forest, const NodeModels& models, TypeCollector& collector) {
  for (const std::string_view used : forest.used_tags()) {
    if (!IsUnknown(used, models)) continue;
    const std::string tag(used);
    collector.Offer({tag, "unknown", "used in this project", "<" + tag + "/>"});
  }
}

}  // namespace

std::vector<TypeChoice> FindTypes(const EditorState& state, const std::string& typed,
                                  bool with_trees, std::size_t limit) {
  TypeCollector collector(state, typed);
  const OpenFile* file = state.workspace.file();
  if (!file) return {};
  for (const auto& [id, model] : file->models->all()) {
    collector.Offer({id, ToString(model.category), model.description, "<" + id + "/>"});
  }
  OfferUnknown(*file->forest, *file->models, collector);
  if (with_trees) OfferTrees(*file->forest, state.workspace.ShownTreeId(), collector);
  std::vector<TypeChoice> best = collector.Best(limit);
  const bool is_there = std::any_of(best.begin(), best.end(),
                                    [&](const TypeChoice& one) { return one.type == typed; });
  if (IsXmlName(typed) && !is_there) {
    if (best.size() == limit) best.pop_back();
    best.push_back({typed, "new", "a type that no model describes yet", "<" + typed + "/>"});
  }
  return best;
}

}  // namespace coppice::editor
