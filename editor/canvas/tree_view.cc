// A view outlives the versions of its tree: nodes of a new scene are matched with the old ones, and
// keep whether they are selected or collapsed and where they were. Nothing is animated step by
// step: the view knows where boxes came from and since when, so that what a frame shows depends on
// its time alone, however many frames there are.
#include "editor/canvas/tree_view.h"

#include <algorithm>
#include <utility>

namespace coppice::editor {
namespace {

constexpr double kMoveSeconds = 0.15;
constexpr float kChipRow = 20;
constexpr float kMargin = 18;  // around a fitted tree, on a screen of scale 1
constexpr float kLeastZoom = 0.0005F;
constexpr float kLargestZoom = 3;
constexpr float kWideCanvas = 1000;  // on wider ones a small tree is painted larger
constexpr float kLargestFit = 1.6F;
constexpr float kEasily = 1.4F;  // times the least zoom at which nodes can be read

float EaseOut(double t) {
  const auto rest = static_cast<float>(1 - std::clamp(t, 0.0, 1.0));
  return 1 - rest * rest * rest;
}

float ZoomToFit(const Box& box, Point canvas, float margin, float largest_zoom) {
  const float across = std::max(canvas.x - 2 * margin, 1.0F) / std::max(box.width(), 1.0F);
  const float down = std::max(canvas.y - 2 * margin, 1.0F) / std::max(box.height(), 1.0F);
  return std::clamp(std::min(across, down), kLeastZoom, largest_zoom);
}

}  // namespace

EdgeEnds Camera::ToScreen(EdgeEnds world) const {
  world.parent = ToScreen(world.parent);
  world.child = ToScreen(world.child);
  for (float* length : {&world.zoom, &world.parent_note, &world.child_note}) {
    *length *= zoom;
  }
  return world;
}

void TreeView::SetScene(std::shared_ptr<const Scene> scene, const SizeOf& size_of, double now) {
  TreeHashes hashes = HashTree(*scene);
  TreeMatch match;
  if (scene_ && !scene_->nodes.empty()) {
    match = MatchTrees(*scene_, hashes_, *scene, hashes);
  } else {
    match.before_of.assign(scene->nodes.size(), kNoSceneNode);
  }
  const Places before = PlacesAt(now);
  std::uint32_t anchor = Anchor(selected_, now);
  while (anchor != kNoSceneNode && match.after_of[anchor] == kNoSceneNode) {
    anchor = scene_->nodes[anchor].parent;
  }
  Places after = {std::vector<Box>(scene->nodes.size()),
                  std::vector<bool>(scene->nodes.size(), false)};
  std::vector<bool> collapsed(scene->nodes.size(), false);
  std::vector<NodeSizes> sizes(scene->nodes.size());
  for (std::uint32_t i = 0; i < scene->nodes.size(); ++i) {
    const std::uint32_t old = match.before_of[i];
    const bool looks_the_same = old != kNoSceneNode && hashes_.shown[old] == hashes.shown[i];
    sizes[i] = looks_the_same ? sizes_[old] : size_of(*scene, scene->nodes[i]);
    if (old == kNoSceneNode) continue;
    collapsed[i] = collapsed_[old] && scene->HasChildren(i);
    after.known[i] = before.known[old];
    after.at[i] = before.at[old];
  }
  if (!shown_.empty() && !after.known.empty() && !after.known[0]) {
    // What is new at the top comes from where the old root was.
    after.at[0] = before.at[0];
    after.known[0] = true;
  }
  const auto new_number = [&](std::uint32_t old) { return match.after_of[old]; };
  anchor = anchor == kNoSceneNode ? 0 : new_number(anchor);
  selected_ = selected_ == kNoSceneNode ? kNoSceneNode : new_number(selected_);
  for (std::uint32_t& node : selection_) node = new_number(node);
  std::sort(selection_.begin(), selection_.end());
  selection_.erase(std::lower_bound(selection_.begin(), selection_.end(), kNoSceneNode),
                   selection_.end());
  if (selected_ == kNoSceneNode && !selection_.empty()) selected_ = selection_.back();

  scene_ = std::move(scene);
  hashes_ = std::move(hashes);
  sizes_ = std::move(sizes);
  collapsed_ = std::move(collapsed);
  keys_ = FindKeyUses(*scene_);
  lit_key_ = kNoKey;
  gesture = {};
  ListShown();
  LayOutShown();
  Move(after, anchor, now);
}

void TreeView::MeasureAgain(const SizeOf& size_of, double now) {
  if (!scene_) return;
  const std::uint32_t anchor = Anchor(selected_, now);
  for (std::size_t i = 0; i < sizes_.size(); ++i) sizes_[i] = size_of(*scene_, scene_->nodes[i]);
  Relayout(anchor, now);
}

void TreeView::SetScreenScale(float scale) {
  const float factor = scale / std::exchange(screen_scale_, scale);
  if (factor == 1) return;
  const bool was_fitted = camera == fitted_;
  const Point middle = Point{canvas_.width(), canvas_.height()} * 0.5F;
  camera.offset = middle + (camera.offset - middle) * factor;
  camera.zoom *= factor;
  if (was_fitted) fitted_ = camera;
}

void TreeView::SetStyle(const LayoutStyle& style, double now) {
  if (style == style_) return;
  const LayoutStyle before = std::exchange(style_, style);
  const bool is_chosen_anew = before.growth != style.growth || before.ports != style.ports ||
                              before.wrapped != style.wrapped || before.layered != style.layered;
  if (style.growth != Growth::kByItself) {
    const bool across = style.growth == Growth::kAcross;
    choice_.orientation = across ? Orientation::kLeftToRight : Orientation::kTopToBottom;
  }
  if (style.ports != ShownPorts::kByItself) choice_.names_only = style.ports == ShownPorts::kNone;
  if (!style.wrapped || style.layered) choice_.rows = 0;
  if (!scene_) return;
  const Places places = PlacesAt(now);
  const std::uint32_t anchor = Anchor(selected_, now);
  if (is_chosen_anew) {
    needs_fit = needs_fit || (camera == fitted_ && !IsMouseOnNode());
    if (!needs_fit) Choose({canvas_.width(), canvas_.height()});
  }
  LayOutShown();
  Move(places, anchor, now);
}

void TreeView::SetCollapsed(std::uint32_t node, bool collapsed, double now) {
  if (!scene_->HasChildren(node) || collapsed_[node] == collapsed) return;
  const std::uint32_t anchor = Anchor(node, now);
  collapsed_[node] = collapsed;
  Relayout(anchor, now);
}

void TreeView::CollapseSubTrees(bool collapsed, double now) {
  for (std::uint32_t i = 0; i < scene_->nodes.size(); ++i) {
    if (scene_->nodes[i].shape == Shape::kSubTree) {
      collapsed_[i] = collapsed && scene_->HasChildren(i);
    }
  }
  Relayout(Anchor(selected_, now), now);
}

void TreeView::CollapseOthers(double now) {
  if (selection_.empty()) return;
  for (std::uint32_t i = 0; i < scene_->nodes.size(); ++i) {
    const auto inside = std::lower_bound(selection_.begin(), selection_.end(), i);
    const bool holds = inside != selection_.end() && *inside < scene_->nodes[i].end;
    collapsed_[i] = !holds && scene_->HasChildren(i);
  }
  for (const std::uint32_t node : selection_) {
    for (std::uint32_t i = node; i < scene_->nodes[node].end; ++i) collapsed_[i] = false;
  }
  Relayout(Anchor(selected_, now), now);
}

void TreeView::OpenAll(double now) {
  std::fill(collapsed_.begin(), collapsed_.end(), false);
  Relayout(Anchor(selected_, now), now);
}

std::vector<std::string> TreeView::ClosedNodes() const {
  std::vector<std::string> nodes;
  for (std::uint32_t i = 0; i < collapsed_.size(); ++i) {
    const SceneNode& node = scene_->nodes[i];
    if (collapsed_[i]) nodes.push_back(node.path + " " + std::string(node.id));
  }
  return nodes;
}

void TreeView::CloseAtFirst(const std::vector<std::string>& nodes) {
  if (nodes.empty() || !scene_) return;
  for (const std::string& node : nodes) {
    const std::string path = node.substr(0, node.find(' '));
    const std::uint32_t found = scene_->FindPath(path);
    if (found == kNoSceneNode || !scene_->HasChildren(found)) continue;
    collapsed_[found] = node == path + " " + std::string(scene_->nodes[found].id);
  }
  ListShown();
  LayOutShown();
  moved_at_ = kNeverMoved;
}

std::uint32_t TreeView::ShownOf(std::uint32_t node) const {
  const auto after = std::upper_bound(shown_.begin(), shown_.end(), node);
  return static_cast<std::uint32_t>(after - shown_.begin()) - 1;
}

TreeView::Places TreeView::PlacesAt(double now) const {
  const std::size_t count = scene_ ? scene_->nodes.size() : 0;
  Places places = {std::vector<Box>(count), std::vector<bool>(count, false)};
  for (std::uint32_t k = 0; k < shown_.size(); ++k) {
    places.at[shown_[k]] = BoxAt(k, now);
    places.known[shown_[k]] = true;
  }
  return places;
}

void TreeView::ListShown() {
  shown_.clear();
  shown_ends_.clear();
  shown_parents_.clear();
  const std::uint32_t count = scene_->nodes.empty() ? 0 : scene_->nodes[0].end;
  std::vector<std::uint32_t> branch;  // numbers of the nodes above
  for (std::uint32_t i = 0; i < count; i = collapsed_[i] ? scene_->nodes[i].end : i + 1) {
    const auto k = static_cast<std::uint32_t>(shown_.size());
    while (!branch.empty() && scene_->nodes[shown_[branch.back()]].end <= i) {
      shown_ends_[branch.back()] = k;
      branch.pop_back();
    }
    shown_parents_.push_back(branch.empty() ? 0 : branch.back());
    shown_.push_back(i);
    shown_ends_.push_back(0);
    branch.push_back(k);
  }
  for (const std::uint32_t k : branch) shown_ends_[k] = static_cast<std::uint32_t>(shown_.size());
}

MeasuredTree TreeView::Measured() const {
  MeasuredTree tree;
  tree.ends = shown_ends_;
  tree.sizes.reserve(shown_.size());
  tree.is_decorator.reserve(shown_.size());
  for (const std::uint32_t node : shown_) {
    const Point chip = {0, collapsed_[node] ? kChipRow : 0};
    tree.sizes.emplace_back(sizes_[node].full + chip, sizes_[node].name + chip);
    tree.is_decorator.push_back(scene_->nodes[node].shape == Shape::kDecorator);
  }
  return tree;
}

void TreeView::LayOutShown() { TakeLayout(Arrange(Measured(), style_, choice_)); }

void TreeView::TakeLayout(TreeLayout layout) {
  layout_ = std::move(layout);
  branches_ = layout_.boxes;
  for (auto k = static_cast<std::uint32_t>(shown_.size()); k-- > 1;) {
    Box& parent = branches_[shown_parents_[k]];
    parent = Union(parent, branches_[k]);
  }
}

Box TreeView::BoxAt(std::uint32_t k, double now) const {
  const Box& rest = layout_.boxes[k];
  if (!IsMoving(now)) return rest;
  const float t = EaseOut((now - moved_at_) / kMoveSeconds);
  const Point min = from_[k] + (rest.min - from_[k]) * t;
  return {min, min + (rest.max - rest.min)};
}

EdgeEnds TreeView::EdgeTo(std::uint32_t k, double now) const {
  EdgeEnds ends;
  ends.parent = BoxAt(shown_parents_[k], now);
  ends.child = BoxAt(k, now);
  ends.link = layout_.links[k];
  ends.orientation = choice_.orientation;
  return ends;
}

bool TreeView::IsMoving(double now) const { return now < moved_at_ + kMoveSeconds; }

void TreeView::PlaceIn(const Box& canvas) {
  const Box before = std::exchange(canvas_, canvas);
  const Point size = {canvas.width(), canvas.height()};
  if (needs_fit) return ShowAtFirst(size);
  if (before == canvas || before.width() < 1) return;
  const bool was_fitted = camera == fitted_;
  const bool was_in_sight = IsInSight({before.width(), before.height()});
  camera.offset = camera.offset + before.min - canvas.min;
  if (!was_fitted) return;
  const bool upper_edge_moved = before.min.x == canvas.min.x && before.max == canvas.max;
  const bool is_large = camera.zoom >= ZoomOfAll(size) * 0.999F;
  const bool may_stay = IsMouseOnNode() || (upper_edge_moved && is_large);
  const bool stays = may_stay && (!was_in_sight || MoveIntoSight(size));
  if (!stays) at_first_ ? ShowAtFirst(size) : FitAll(size);
  fitted_ = camera;
}

// But for a little, such as the row by which a node has just grown.
bool TreeView::IsInSight(Point canvas) const {
  const Box box = camera.ToScreen(layout_.bounds);
  const float out = kMargin * screen_scale_;
  return box.min.x >= -out && box.min.y >= -out && box.max.x <= canvas.x + out &&
         box.max.y <= canvas.y + out;
}

float TreeView::LargestFit(Point canvas) const {
  const float room = canvas.x / (kWideCanvas * screen_scale_);
  return screen_scale_ * std::clamp(room, 1.0F, kLargestFit);
}

// What is chosen anew is in its place at once.
void TreeView::Choose(Point canvas) {
  const float margins = 2 * kMargin * screen_scale_;
  const Point room = (canvas - Point{margins, margins}) * (1 / screen_scale_);
  ChosenLayout chosen = ChooseLayout(Measured(), style_, room);
  readable_ = chosen.readable;
  can_be_read_ = chosen.can_be_read;
  if (chosen.choice == choice_) return;
  choice_ = chosen.choice;
  TakeLayout(std::move(chosen.layout));
  moved_at_ = kNeverMoved;
}

float TreeView::ZoomOfAll(Point canvas) const {
  return ZoomToFit(layout_.bounds, canvas, kMargin * screen_scale_, LargestFit(canvas));
}

void TreeView::FitAll(Point canvas) {
  if (shown_.empty() || canvas.x < 1 || canvas.y < 1) return;
  Choose(canvas);
  Fit(layout_.bounds, canvas, LargestFit(canvas));
  fitted_ = camera;
  at_first_ = false;
  needs_fit = false;
}

// All of it if that can be read, else its top.
void TreeView::ShowAtFirst(Point canvas) {
  FitAll(canvas);
  if (needs_fit) return;
  if (!can_be_read_) ShowTop(canvas);
  at_first_ = true;
}

// The root at the upper or left edge, and what follows it as large as it must be to be read.
void TreeView::ShowTop(Point canvas) {
  camera.zoom = readable_ * screen_scale_;
  const float margin = kMargin * screen_scale_;
  const Box all = {layout_.bounds.min * camera.zoom, layout_.bounds.max * camera.zoom};
  const Point root = layout_.boxes[0].center() * camera.zoom;
  // As a whole in the middle if there is room, else from the edge, or around the root.
  const auto place = [margin](float size, float low, float high, float at, bool first) {
    if (high - low + 2 * margin <= size) return (size - low - high) / 2;
    return first || at - low < size / 2 ? margin - low : size / 2 - at;
  };
  const bool down = choice_.orientation == Orientation::kTopToBottom;
  camera.offset = {place(canvas.x, all.min.x, all.max.x, root.x, !down),
                   place(canvas.y, all.min.y, all.max.y, root.y, down)};
  fitted_ = camera;
}

void TreeView::FitSelection(Point canvas) {
  if (selection_.empty()) return;
  Box box = branches_[ShownOf(selection_.front())];
  for (const std::uint32_t node : selection_) box = Union(box, branches_[ShownOf(node)]);
  Fit(box, canvas, 1.4F * screen_scale_);
}

void TreeView::Fit(const Box& box, Point canvas, float largest_zoom) {
  camera.zoom = ZoomToFit(box, canvas, kMargin * screen_scale_, largest_zoom);
  camera.offset = canvas * 0.5F - box.center() * camera.zoom;
}

void TreeView::ZoomAt(Point screen, float factor) {
  const Point world = camera.ToWorld(screen);
  camera.zoom = std::clamp(camera.zoom * factor, kLeastZoom, kLargestZoom * screen_scale_);
  camera.offset = screen - world * camera.zoom;
}

void TreeView::RevealReadable(Point canvas) {
  if (selected_ == kNoSceneNode) return;
  if (needs_fit) FitAll(canvas);
  const float least = (choice_.names_only ? kReadableNames : kReadablePorts) * screen_scale_;
  if (camera.zoom < least * 0.999F) {
    camera.zoom = least * kEasily;
    camera.offset = canvas * 0.5F - layout_.boxes[ShownOf(selected_)].center() * camera.zoom;
  }
  Reveal(canvas);
}

void TreeView::RevealIfLost(Point canvas) {
  if (selected_ == kNoSceneNode) return;
  const Box box = camera.ToScreen(layout_.boxes[ShownOf(selected_)]);
  if (!Box{{0, 0}, canvas}.Contains(box.center())) Reveal(canvas);
}

void TreeView::Reveal(Point canvas) {
  if (selected_ == kNoSceneNode) return;
  const Box box = camera.ToScreen(layout_.boxes[ShownOf(selected_)]);
  const auto correction = [margin = kMargin * screen_scale_](float low, float high, float size) {
    if (low < margin) return margin - low;
    return high > size - margin ? std::max(size - margin - high, margin - low) : 0.0F;
  };
  camera.offset = camera.offset + Point{correction(box.min.x, box.max.x, canvas.x),
                                        correction(box.min.y, box.max.y, canvas.y)};
}

}  // namespace coppice::editor
