#include "editor/panels/canvas_banners.h"

#include <string>

#include "editor/core/merge_commands.h"
#include "editor/core/project_editor.h"
#include "editor/document/project_names.h"

namespace coppice::editor {
namespace {

constexpr float kHeight = 26;
constexpr float kPad = 4;

class Banners {
 public:
  Banners(const Ui& ui, EditorState& state, const Box& box) : ui_(ui), state_(state), rest_(box) {}

  Box Draw() {
    DrawDispute();
    DrawShared();
    return rest_;
  }

 private:
  struct Banner {
    const char* path;
    const char* button_path;
    const char* button;
    const char* command;
    Color tint;
  };

  void DrawBanner(const Banner& banner, const std::string& text) {
    const Box box = {rest_.min, {rest_.max.x, rest_.min.y + kHeight * ui_.scale}};
    rest_.min.y = box.max.y;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ui_.Fill(list, box, Mix(ui_.palette.panel, banner.tint, 0.3F));
    ui_.items.Add(banner.path, box);
    const TextStyle style{Face::kSans, 12, ui_.palette.text};
    const float pad = kPad * ui_.scale;
    const float width = ui_.Width(banner.button, style) + 20 * ui_.scale;
    const Box button = {{box.max.x - width - pad, box.min.y + pad},
                        {box.max.x - pad, box.max.y - pad}};
    ui_.RowText(list, box.min + Point{10 * ui_.scale, 0}, box.height(), text, style,
                button.min.x - box.min.x - 20 * ui_.scale);
    if (!ui_.Button(banner.button_path, button, banner.button)) return;
    state_.after_frame = [&s = state_, command = banner.command] { s.commands.Run(command); };
  }

  void DrawDispute() {
    const std::string path = DisputedFile(state_);
    if (path.empty()) return;
    DrawBanner({"banner/dispute", "banner/resolve", "resolve", "file.resolve", ui_.palette.error},
               path.substr(path.rfind('/') + 1) +
                   " was changed on the disk in the same places as here; it is not saved until you "
                   "say whose stays");
  }

  void DrawShared() {
    const SharedTree& shared = Shared();
    if (shared.uses < 2) return;
    DrawBanner({"banner/shared", "banner/uses", "where", "tree.places", ui_.palette.accent},
               shared.id + " is used in " + std::to_string(shared.uses) +
                   " places: what you change here changes all of them");
  }

  // Counted anew when something was changed or another tree was selected.
  const SharedTree& Shared() {
    SharedTree& shared = state_.canvas.shared;
    const std::string id = ProjectEditor(state_, ui_.now).TreeAroundSelection();
    const std::uint64_t version = state_.workspace.project().version();
    if (shared.id == id && shared.version == version) return shared;
    shared = {id, version, 0};
    if (!id.empty()) {
      shared.uses = SubTreesOf(ProjectEditor(state_, ui_.now).Files(), id).size();
    }
    return shared;
  }

  const Ui& ui_;
  EditorState& state_;
  Box rest_;
};

}  // namespace

Box DrawCanvasBanners(const Ui& ui, EditorState& state, const Box& box) {
  return Banners(ui, state, box).Draw();
}

}  // namespace coppice::editor
