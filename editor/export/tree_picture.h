// Pictures of whole trees, painted by the painters of the canvas; needs neither window nor display.
//
//   TreePainting painting;
//   painting.trees.push_back({&scene, "MainTree", nullptr});
//   PictureMaker maker(1);
//   WriteFile("tree.svg", ToSvg(maker.Draw(painting), glyphs));
#ifndef COPPICE_EDITOR_EXPORT_TREE_PICTURE_H_
#define COPPICE_EDITOR_EXPORT_TREE_PICTURE_H_

#include <memory>
#include <string>
#include <vector>

#include "editor/canvas/canvas.h"
#include "editor/export/drawing.h"
#include "editor/render/image.h"

struct ImGuiContext;

namespace coppice::editor {

/// One tree of a picture. What it points to must live until the picture is made.
struct PaintedTree {
  const Scene* scene = nullptr;
  std::string title;                             ///< written above it; may be empty
  const std::vector<Change>* changes = nullptr;  ///< by node; null: none
};

/// Trees below each other.
struct TreePainting {
  std::vector<PaintedTree> trees;
  LayoutStyle style;
  PaletteName palette = PaletteName::kLight;
};

class PictureMaker {
 public:
  /// For pictures with so many pixels for one of the canvas at 100 %. `fonts`: of that scale,
  /// shared with others; null: its own.
  explicit PictureMaker(float pixels, std::shared_ptr<const Fonts> fonts = nullptr);
  ~PictureMaker();
  PictureMaker(const PictureMaker&) = delete;
  PictureMaker& operator=(const PictureMaker&) = delete;

  /// Why nothing can be drawn (a font is missing), or empty. With an error, draw nothing.
  const std::string& error() const { return fonts_->error(); }

  /// The picture as shapes and texts.
  Drawing Draw(const TreePainting& painting);

  /// The picture as pixels. It is made smaller if it would have more than `most_pixels`, or be
  /// longer than 65500 pixels.
  Image Paint(const TreePainting& painting, double most_pixels = 64e6);

 private:
  class Sheet;

  std::unique_ptr<const Sheet> LayOut(const TreePainting& painting);

  const float pixels_;
  std::shared_ptr<const Fonts> fonts_;
  ImGuiContext* const context_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_EXPORT_TREE_PICTURE_H_
