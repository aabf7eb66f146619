#include "editor/export/tree_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/canvas/layout/node_metrics.h"
#include "editor/canvas/tree_painter.h"
#include "editor/render/rasteriser.h"
#include "editor/theme/imgui_context.h"
#include "editor/theme/item_registry.h"

namespace coppice::editor {
namespace {

constexpr float kMargin = 32;  // around each tree: the ground of SubTrees reaches out
constexpr float kTitleRow = 22;
constexpr float kTitleSize = 15;
constexpr float kLongestSide = 65500;
constexpr Point kPaper = {2000, 1500};  // trees that are larger stand in rows

// All of it is shown, and it grows as it is told to.
LayoutStyle OnPaper(LayoutStyle style) {
  style.ports = ShownPorts::kAll;
  style.whole_values = true;
  if (style.growth == Growth::kByItself) style.growth = Growth::kDown;
  return style;
}

}  // namespace

// The trees, laid out below each other.
class PictureMaker::Sheet {
 public:
  Sheet(const Fonts& fonts, float scale, const TreePainting& painting)
      : painting_(painting),
        ui_{GetPalette(painting.palette), fonts, items_, scale, 0, Time{}, true} {
    float y = 0;
    for (const PaintedTree& tree : painting.trees) {
      Placed placed;
      placed.top = y;
      placed.view = std::make_unique<TreeView>();
      placed.view->animated = false;
      placed.view->SetStyle(OnPaper(painting.style), 0);
      // The scene belongs to the caller.
      const std::shared_ptr<const Scene> scene(std::shared_ptr<const void>(), tree.scene);
      const auto size_of = [this](const Scene& all, const SceneNode& node) {
        return MeasureNode(ui_, all, node, true);
      };
      placed.view->SetScene(scene, size_of, 0);
      placed.view->FitAll(kPaper);
      const Box& bounds = placed.view->bounds();
      const float title = tree.title.empty() ? 0 : TitleWidth(tree.title);
      size_.x = std::max(size_.x, std::max(bounds.width(), title) + 2 * kMargin);
      y += TitleHeight(tree) + bounds.height() + 2 * kMargin;
      placed_.push_back(std::move(placed));
    }
    size_.y = y;
  }

  const Palette& palette() const { return ui_.palette; }
  const Ui& ui() const { return ui_; }
  /// At zoom 1.
  Point size() const { return {std::ceil(size_.x), std::ceil(size_.y)}; }

  void Paint(Pen& pen, float zoom) const {
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      const PaintedTree& tree = painting_.trees[i];
      const Placed& placed = placed_[i];
      CanvasOptions options;
      options.changes = tree.changes;
      Camera camera;
      camera.zoom = zoom;
      const float top = placed.top + TitleHeight(tree) + kMargin;
      camera.offset = Point{kMargin, top} * zoom;
      const Box box = {{0, 0}, size() * zoom};
      const std::vector<VisibleNode> visible = FindVisible(*placed.view, camera, box, 0);
      PaintTree(pen, {*placed.view, options, camera, box, visible, nullptr});
      const TextStyle style{Face::kBold, kTitleSize * zoom / ui_.scale, palette().text};
      pen.RowText(Point{kMargin, placed.top + kMargin / 2} * zoom, kTitleRow * zoom, tree.title,
                  style);
    }
  }

 private:
  struct Placed {
    float top = 0;
    std::unique_ptr<TreeView> view;
  };

  static float TitleHeight(const PaintedTree& tree) { return tree.title.empty() ? 0 : kTitleRow; }
  float TitleWidth(const std::string& title) const {
    return ui_.Width(title, {Face::kBold, kTitleSize, 0}) / ui_.scale;
  }

  const TreePainting& painting_;
  ItemRegistry items_;
  const Ui ui_;
  std::vector<Placed> placed_;
  Point size_;
};

PictureMaker::PictureMaker(float pixels, std::shared_ptr<const Fonts> fonts)
    : pixels_(pixels),
      fonts_(fonts ? std::move(fonts) : std::make_shared<const Fonts>(pixels)),
      context_(fonts_->MakeContext()) {}

PictureMaker::~PictureMaker() { ImGui::DestroyContext(context_); }

// Texts are measured here: then it is known which characters they have.
std::unique_ptr<const PictureMaker::Sheet> PictureMaker::LayOut(const TreePainting& painting) {
  auto sheet = std::make_unique<const Sheet>(*fonts_, pixels_, painting);
  CharacterSet characters = fonts_->TakeLacking();
  if (characters.empty()) return sheet;
  characters.insert(fonts_->more().begin(), fonts_->more().end());
  fonts_ = std::make_shared<const Fonts>(pixels_, std::move(characters));
  fonts_->UseInContext();
  return std::make_unique<const Sheet>(*fonts_, pixels_, painting);
}

Drawing PictureMaker::Draw(const TreePainting& painting) {
  const WithContext current(context_);
  const std::unique_ptr<const Sheet> sheet = LayOut(painting);
  Drawing drawing;
  drawing.size = sheet->size() * pixels_;
  drawing.background = sheet->palette().canvas;
  DrawingPen pen(sheet->ui(), drawing);
  sheet->Paint(pen, pixels_);
  return drawing;
}

Image PictureMaker::Paint(const TreePainting& painting, double most_pixels) {
  const WithContext current(context_);
  const std::unique_ptr<const Sheet> sheet = LayOut(painting);
  const Point size = sheet->size();
  const double area = static_cast<double>(size.x) * static_cast<double>(size.y);
  const auto by_area = static_cast<float>(std::sqrt(most_pixels / std::max(area, 1.0)));
  const float longest = kLongestSide / std::max({size.x, size.y, 1.0F});
  const float zoom = std::min({pixels_, by_area, longest});
  Image image = MakeImage(std::max(1, static_cast<int>(size.x * zoom)),
                          std::max(1, static_cast<int>(size.y * zoom)), sheet->palette().canvas);

  // A frame of Dear ImGui with nothing in it but the list that is painted.
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = {static_cast<float>(image.width), static_cast<float>(image.height)};
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  ImGui::NewFrame();
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  ScreenPen pen(sheet->ui(), list);
  sheet->Paint(pen, zoom);
  ImGui::Render();
  Texture texture;
  unsigned char* alpha = nullptr;
  io.Fonts->GetTexDataAsAlpha8(&alpha, &texture.width, &texture.height);
  texture.alpha = alpha;
  Rasterise(*ImGui::GetDrawData(), texture, image);
  return image;
}

}  // namespace coppice::editor
