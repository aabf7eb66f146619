#include "editor/panels/tour/tour.h"

#include <algorithm>
#include <string>

#include "editor/workspace/tour.h"

namespace coppice::editor {
namespace {

constexpr float kWidth = 300;  // pixels at scale 1
constexpr float kPad = 12;
constexpr float kButton = 24;
constexpr float kBetween = 8;
constexpr ImGuiWindowFlags kFlags =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;

class TourBubble {
 public:
  TourBubble(const Ui& ui, EditorState& state, const TourStep& step)
      : ui_(ui),
        state_(state),
        step_(step),
        text_(TextOf(step, state)),
        screen_(FromIm(ImGui::GetIO().DisplaySize)) {}

  void Draw() {
    const Box* const item = ui_.items.Find(std::string(step_.item));
    const Box pointed = item ? *item : Box{screen_ * 0.5F, screen_ * 0.5F};
    const Point size = Size();
    const Point at = Place(pointed, size);
    ImGui::SetNextWindowPos(ToIm(at));
    ImGui::SetNextWindowSize(ToIm(size));
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ui_.palette.panel);
    ImGui::PushStyleColor(ImGuiCol_Border, ui_.palette.accent);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::Begin("tour", nullptr, kFlags | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    if (item) Mark(pointed);
    Content({at, at + size});
    ImGui::End();
  }

 private:
  TextStyle TextLook() const { return {Face::kSans, 13, ui_.palette.text}; }

  Point Size() const {
    const float room = (kWidth - 2 * kPad) * ui_.scale;
    const float text = ui_.ParagraphHeight(text_, TextLook(), room);
    return {kWidth * ui_.scale, text + (2 * kPad + 22 + kBetween + kButton + kBetween) * ui_.scale};
  }

  // Beside it, where there is room; in it if it fills the window.
  Point Place(const Box& item, Point size) const {
    const float gap = kPad * ui_.scale;
    Point at = {item.center().x - size.x / 2, item.max.y - size.y - gap};
    if (item.max.x + gap + size.x <= screen_.x) {
      at = {item.max.x + gap, item.min.y};
    } else if (item.min.x - gap - size.x >= 0) {
      at = {item.min.x - gap - size.x, item.min.y};
    }
    if (item.height() < 2 * kButton * ui_.scale) at = {item.min.x, item.max.y + gap};
    if (item.width() > screen_.x / 3 && item.height() > screen_.y / 3) {
      at = {item.center().x - size.x / 2, item.max.y - size.y - gap};
    }
    return {std::clamp(at.x, 0.0F, std::max(screen_.x - size.x, 0.0F)),
            std::clamp(at.y, 0.0F, std::max(screen_.y - size.y, 0.0F))};
  }

  // Over all tiles.
  void Mark(const Box& item) const {
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const float out = 2 * ui_.scale;
    const Box around = {item.min - Point{out, out}, item.max + Point{out, out}};
    ui_.Frame(list, around, ui_.palette.accent, 5 * ui_.scale, 2.5F * ui_.scale);
    ui_.items.Add("tour/item", item);
  }

  void Content(const Box& box) {
    ui_.items.Add("tour", box);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float pad = kPad * ui_.scale;
    const Point at = box.min + Point{pad, pad};
    const TextStyle dim{Face::kSans, 11, ui_.palette.text_dim};
    ui_.Text(list, at, step_.title, {Face::kBold, 14, ui_.palette.text});
    const std::string count =
        std::to_string(state_.tour.step + 1) + " of " + std::to_string(TourSteps().size());
    ui_.Text(list, {box.max.x - pad - ui_.Width(count, dim), at.y}, count, dim);
    ui_.Paragraph(list, at + Point{0, 22 * ui_.scale}, text_, TextLook(), box.width() - 2 * pad);
    float right = box.max.x - pad;
    const bool is_last = state_.tour.step + 1 == static_cast<int>(TourSteps().size());
    if (!is_last) Button("tour/end", "end", "tour.end", right, box.max.y - pad);
    if (state_.tour.step > 0) Button("tour/back", "back", "tour.back", right, box.max.y - pad);
    Button("tour/next", is_last ? "done" : "next", "tour.next", right, box.max.y - pad);
  }

  // From the right to the left.
  void Button(const char* path, const char* text, const char* command, float& right, float bottom) {
    const float width = 64 * ui_.scale;
    const Box box = {{right - width, bottom - kButton * ui_.scale}, {right, bottom}};
    right -= width + kBetween * ui_.scale;
    const bool is_next = std::string(command) == "tour.next";
    if (!ui_.Button(path, box, text, is_next)) return;
    state_.after_frame = [&s = state_, command] { s.commands.Run(command); };
  }

  const Ui& ui_;
  EditorState& state_;
  const TourStep step_;
  const std::string text_;
  const Point screen_;
};

}  // namespace

void DrawTour(const Ui& ui, EditorState& state) {
  UpdateTour(state);
  const TourStep* const step = ShownStep(state);
  const bool is_covered = state.popup.kind != Popup::kNone || !state.menu.open.empty();
  if (step && !is_covered) TourBubble(ui, state, *step).Draw();
}

}  // namespace coppice::editor
