#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "editor/panels/run/run_bodies.h"
#include "editor/panels/widgets/panel.h"

namespace coppice::editor {
namespace {

constexpr float kGap = 8;           // pixels at scale 1, here and below
constexpr float kLargestPixel = 8;  // of a robot's picture
constexpr float kLargestLamp = 48;  // of a picture of one pixel
constexpr float kLeastHeight = 48;
constexpr float kLeastWidth = 100;  // of what has room for its words
constexpr float kGapFrom = 4;       // pixels that are so large are drawn apart, as lamps are

// The largest first.
std::vector<const LivePicture*> Sorted(const PictureSet& pictures) {
  std::vector<const LivePicture*> sorted;
  for (const auto& [name, picture] : pictures.all()) sorted.push_back(&picture);
  std::stable_sort(sorted.begin(), sorted.end(), [](const LivePicture* a, const LivePicture* b) {
    return a->rgb.size() > b->rgb.size();
  });
  return sorted;
}

float PixelOf(const LivePicture& picture, Point room, float scale) {
  const bool is_lamp = picture.width == 1 && picture.height == 1;
  const float largest = (is_lamp ? kLargestLamp : kLargestPixel) * scale;
  const float pixel = std::min({room.x / static_cast<float>(picture.width),
                                room.y / static_cast<float>(picture.height), largest});
  return pixel > 1 ? std::floor(pixel) : pixel;
}

Color ColorOf(const LivePicture& picture, std::size_t pixel) {
  const std::uint8_t* rgb = picture.rgb.data() + 3 * pixel;
  return IM_COL32(rgb[0], rgb[1], rgb[2], 255);
}

// `pixel`: of the robot's picture, in pixels of the screen.
void Paint(const Ui& ui, const LivePicture& picture, float pixel, const Box& box) {
  constexpr Color kDark = IM_COL32(0, 0, 0, 255);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ui.Fill(list, box, kDark);
  const float gap = pixel >= kGapFrom * ui.scale && picture.width > 1 ? ui.scale : 0;
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      const Color color = ColorOf(picture, std::size_t{y} * picture.width + x);
      if (color == kDark) continue;
      const Point at =
          box.min + Point{static_cast<float>(x) * pixel, static_cast<float>(y) * pixel};
      ui.Fill(list, {at, at + Point{pixel - gap, pixel - gap}}, color);
    }
  }
  ui.Frame(list, box, ui.palette.border);
}

void Write(const Ui& ui, const LivePicture& picture, Point at, float width) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const TextStyle name{Face::kSans, 12, ui.palette.text_dim};
  const float x =
      ui.RowText(list, at, kRowHeight * ui.scale, InOneLine(picture.name), name, width) +
      6 * ui.scale;
  if (x >= width || picture.text.empty()) return;
  const TextStyle text{Face::kBold, 12, ui.palette.text};
  ui.RowText(list, at + Point{x, 0}, kRowHeight * ui.scale, InOneLine(picture.text), text,
             width - x);
}

}  // namespace

void DrawPictures(const Ui& ui, EditorState&, RunView& run) {
  if (run.pictures().empty()) return Hint(ui, "The robot shows nothing to people now.");
  if (!run.playhead().is_at_now()) Hint(ui, "As it is now, not at the shown tick.");
  const float gap = kGap * ui.scale;
  const float words = kRowHeight * ui.scale;
  const Point begin = FromIm(ImGui::GetCursorScreenPos()) + Point{gap, gap};
  const Point room = {
      ImGui::GetContentRegionAvail().x - 2 * gap,
      std::max(ImGui::GetContentRegionAvail().y - 2 * gap - words, kLeastHeight * ui.scale)};
  Point at = begin;
  float bottom = begin.y;
  for (const LivePicture* picture : Sorted(run.pictures())) {
    const float pixel = PixelOf(*picture, room, ui.scale);
    const Point size = {pixel * static_cast<float>(picture->width),
                        pixel * static_cast<float>(picture->height)};
    const float width = std::max(size.x, kLeastWidth * ui.scale);
    if (at.x > begin.x && at.x + width > begin.x + room.x) at = {begin.x, bottom + gap};
    const Box box = {at, at + Point{width, size.y + words}};
    ImGui::SetCursorScreenPos(ToIm(at));
    ImGui::Dummy({box.width(), box.height()});
    if (ImGui::IsItemVisible()) {
      ui.items.Add("run/pictures/" + picture->name, box);
      Paint(ui, *picture, pixel, {at, at + size});
      Write(ui, *picture, {at.x, at.y + size.y}, width);
    }
    at.x += width + gap;
    bottom = std::max(bottom, box.max.y);
  }
}

}  // namespace coppice::editor
