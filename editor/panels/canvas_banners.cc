#include "editor/panels/canvas_banners.h"

#include <initializer_list>
#include <string>

#include "editor/commands/merge_commands.h"
#include "editor/document/project_names.h"
#include "editor/panels/widgets/panel.h"
#include "editor/workspace/file_keeper.h"
#include "editor/workspace/project_editor.h"
#include "editor/workspace/simulation_editor.h"

namespace coppice::editor {
namespace {

constexpr float kHeight = 26;
constexpr float kPad = 4;

class Banners {
 public:
  Banners(const Ui& ui, EditorState& state, const Box& box) : ui_(ui), state_(state), rest_(box) {}

  Box Draw() {
    DrawLeft();
    DrawElsewhere();
    DrawGone();
    DrawFailedSave();
    DrawUnkept();
    DrawDispute();
    DrawStale();
    DrawSimulation();
    DrawShared();
    return rest_;
  }

 private:
  struct BannerButton {
    const char* path;
    const char* text;
    const char* command;
  };

  void DrawBanner(const char* path, Color tint, const std::string& text,
                  std::initializer_list<BannerButton> buttons) {
    const Box box = {rest_.min, {rest_.max.x, rest_.min.y + kHeight * ui_.scale}};
    rest_.min.y = box.max.y;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ui_.Fill(list, box, Mix(ui_.palette.panel, tint, 0.3F));
    ui_.Fill(list, {box.min, {box.min.x + 3 * ui_.scale, box.max.y}}, tint);
    ui_.items.Add(path, box);
    const float pad = kPad * ui_.scale;
    float right = box.max.x - pad;
    for (const BannerButton& button : buttons) {
      const float width = ui_.Width(button.text, {Face::kSans, 12, 0}) + 20 * ui_.scale;
      const Box at = {{right - width, box.min.y + pad}, {right, box.max.y - pad}};
      right = at.min.x - pad;
      if (ui_.Button(button.path, at, button.text)) {
        state_.after_frame = [&s = state_, run = button.command] { s.commands.Run(run); };
      }
    }
    const Point at = box.min + Point{12 * ui_.scale, 0};
    ui_.RowText(list, at, box.height(), text, {Face::kSans, 12, ui_.palette.text},
                right - at.x - pad);
    if (ImGui::IsMouseHoveringRect(ToIm(box.min), {right, box.max.y})) Tooltip(ui_, text);
  }

  // Of the last time, after a crash.
  void DrawLeft() {
    const UnsavedCopy* const copy = FileKeeper(state_, ui_.now).Offered();
    if (!copy) return;
    DrawBanner(
        "banner/unsaved", ui_.palette.warning,
        "An earlier session ended with unsaved work on " + NameOf(copy->path) + ", " + AgeOf(*copy),
        {{"banner/forget", "forget it", "file.forget"},
         {"banner/restore", "restore it", "file.restore"}});
  }

  void DrawElsewhere() {
    const UnsavedCopy* const copy = FileKeeper(state_, ui_.now).Elsewhere();
    if (!copy) return;
    DrawBanner("banner/elsewhere", ui_.palette.warning,
               NameOf(copy->path) + " is open in another editor (process " +
                   std::to_string(copy->editor) + "), with changes that are not saved there",
               {});
  }

  void DrawGone() {
    for (const auto& [path, file] : state_.workspace.project().files()) {
      if (!file.is_gone) continue;
      return DrawBanner("banner/gone", ui_.palette.error,
                        NameOf(path) + " has been removed from the disk: this is the only copy",
                        {{"banner/write", "write it", "file.save"}});
    }
  }

  void DrawFailedSave() {
    for (const auto& [path, reason] : state_.unsaveable) {
      const EditedFile* const file = state_.workspace.project().Find(path);
      if (!file || !file->is_dirty() || file->other) continue;
      return DrawBanner("banner/failed_save", ui_.palette.error,
                        NameOf(path) + " could not be saved: " + reason,
                        {{"banner/save_as", "save as", "file.save_as"},
                         {"banner/save_again", "try again", "file.save"}});
    }
  }

  void DrawUnkept() {
    if (state_.work.trouble().empty()) return;
    DrawBanner("banner/unkept", ui_.palette.error,
               "A crash would lose unsaved work, because no copy of it can be kept: " +
                   state_.work.trouble(),
               {{"banner/save", "save", "file.save"}});
  }

  // The text is malformed; what is shown is older than it.
  void DrawStale() {
    const OpenFile* file = state_.workspace.file();
    if (state_.workspace.run() || !state_.workspace.view() || !file || !file->is_stale) return;
    DrawBanner(
        "banner/stale", ui_.palette.error,
        NameOf(file->path) + " has an error" + LineOfError(*file) +
            ": the tree is shown as it was before the error and cannot be edited on the canvas",
        {});
  }

  static std::string LineOfError(const OpenFile& file) {
    for (const Diagnostic& problem : file.problems) {
      if (problem.severity == Severity::kError && problem.where.line > 0) {
        return " on line " + std::to_string(problem.where.line);
      }
    }
    return "";
  }

  void DrawSimulation() {
    const std::string& problem = state_.simulator.problem();
    if (problem.empty() || !SimulationEditor(state_, ui_.now).IsShown()) return;
    DrawBanner(
        "banner/simulation", ui_.palette.error,
        "The text has an error; the simulation goes on with the tree as it was before: " + problem,
        {});
  }

  static std::string NameOf(const std::string& path) { return path.substr(path.rfind('/') + 1); }

  void DrawDispute() {
    const std::string path = DisputedFile(state_);
    if (path.empty()) return;
    DrawBanner("banner/dispute", ui_.palette.error,
               NameOf(path) +
                   " was changed on the disk in the same places as here; it will not be saved "
                   "until you choose which version to keep",
               {{"banner/resolve", "resolve", "file.resolve"}});
  }

  void DrawShared() {
    const SharedTree& shared = Shared();
    if (shared.uses < 2) return;
    DrawBanner("banner/shared", ui_.palette.accent,
               "\"" + shared.id + "\" is used in " + std::to_string(shared.uses) +
                   " places: a change here changes all of them",
               {{"banner/uses", "where", "tree.places"}});
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
