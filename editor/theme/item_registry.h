// Where everything is on the screen, by path: "canvas/MainTree/1.2", "outline/1.2",
// "strip/connect". Scripted tests click by path; so do help and the guided tour of a user's hand.
#ifndef COPPICE_EDITOR_THEME_ITEM_REGISTRY_H_
#define COPPICE_EDITOR_THEME_ITEM_REGISTRY_H_

#include <map>
#include <string>
#include <string_view>

#include "editor/theme/geometry.h"

namespace coppice::editor {

class ItemRegistry {
 public:
  /// Forgets the last frame.
  void Clear() { items_.clear(); }

  /// Adds what is drawn at `box` of the window. Items that are not drawn are not added.
  void Add(std::string path, const Box& box) { items_[std::move(path)] = box; }

  /// The box of that path in the last frame, or null.
  const Box* Find(std::string_view path) const;

  const std::map<std::string, Box, std::less<>>& all() const { return items_; }

 private:
  std::map<std::string, Box, std::less<>> items_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_THEME_ITEM_REGISTRY_H_
