#include "editor/theme/item_registry.h"

namespace coppice::editor {

const Box* ItemRegistry::Find(std::string_view path) const {
  const auto found = items_.find(path);
  return found == items_.end() ? nullptr : &found->second;
}

}  // namespace coppice::editor
