// Small trees, painted.
#ifndef COPPICE_TESTS_EDITOR_EXPORT_PAINTED_H_
#define COPPICE_TESTS_EDITOR_EXPORT_PAINTED_H_

#include <memory>
#include <string>

#include "editor/export/tree_picture.h"
#include "tests/editor/canvas/make_scene.h"

namespace coppice::editor {

/// A painting of one tree, which lives as long as the painting.
struct Painted {
  explicit Painted(const std::string& xml, const std::string& title = {}) : scene(MakeScene(xml)) {
    painting.trees.push_back({scene.get(), title, nullptr});
  }
  std::shared_ptr<const Scene> scene;
  TreePainting painting;
};

inline std::size_t CountOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_EXPORT_PAINTED_H_
