#include <filesystem>

#include "editor/commands/menus.h"
#include "editor/panels/panels.h"
#include "editor/panels/widgets/panel.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

std::string FileName(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

void IconRow(const Ui& ui, const Box& box, float indent, std::string_view glyph,
             std::string_view text, Color color, std::string_view note) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float left = box.min.x + indent * ui.scale;
  const TextStyle small{Face::kSans, 11, ui.palette.text_dim};
  const float note_width = ui.Width(note, small);
  const float right = box.max.x - 8 * ui.scale - note_width;
  ui.RowText(list, {left, box.min.y}, box.height(), glyph, {Face::kSans, 12, ui.palette.text_dim});
  ui.RowText(list, {left + 20 * ui.scale, box.min.y}, box.height(), text, {Face::kSans, 12, color},
             right - left - 26 * ui.scale);
  ui.RowText(list, {right, box.min.y}, box.height(), note, small);
}

// Scrolls to the shown tree when it is another one than in the last frame.
void FollowShown(const Row& row, const std::string& tree) {
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  const ImGuiID id = ImGui::GetID("shown");
  const int shown = static_cast<int>(ImGui::GetID(tree.c_str()));
  if (storage.GetInt(id, 0) == shown) return;
  storage.SetInt(id, shown);
  const float top = ImGui::GetWindowPos().y;
  const bool is_in_sight = row.box.min.y >= top && row.box.max.y <= top + ImGui::GetWindowHeight();
  if (!is_in_sight) ImGui::SetScrollHereY(1);
}

void DrawFile(const Ui& ui, EditorState& state, std::size_t number) {
  Workspace& workspace = state.workspace;
  const OpenFile& file = workspace.files()[number];
  const auto forest = file.forest;  // a click may load the file anew
  const double now = ui.now;
  const std::string name = FileName(file.path);
  const bool broken = forest->documents().empty();
  if (broken) {
    const Row row = NextRow(ui, "project/" + name, workspace.file() == &file);
    IconRow(ui, row.box, 8, icon::kWarning, name, ui.palette.error, "cannot be read");
    if (row.clicked) workspace.ShowFileTree(number, -1, now);
    return;
  }
  for (std::uint32_t d = 0; d < forest->own_documents(); ++d) {
    const std::string document = FileName(forest->documents()[d]->file());
    const EditedFile* const edited = workspace.project().Find(forest->documents()[d]->file());
    const bool is_dirty = edited && edited->is_dirty();
    const Row row = NextRow(ui, "project/" + document, false);
    if (row.visible) {
      IconRow(ui, row.box, d == 0 ? 8 : 16, icon::kFolderOpen, (is_dirty ? "* " : "") + document,
              d == 0 ? ui.palette.text : ui.palette.text_dim,
              is_dirty ? "not saved"
              : d == 0 ? ""
                       : "included");
    }
    for (std::size_t t = 0; t < forest->trees().size(); ++t) {
      if (forest->trees()[t].document != d) continue;
      const int tree = static_cast<int>(t);
      const std::string& id = forest->trees()[t].id;
      const bool shown = workspace.file() == &file && workspace.tree() == tree;
      const Row item = NextRow(ui, "project/" + document + "/" + id, shown);
      if (shown) FollowShown(item, document + "/" + id);
      if (item.visible) {
        IconRow(ui, item.box, d == 0 ? 24 : 32, icon::kSitemap, id, ui.palette.text,
                tree == forest->main_tree() ? "main" : "");
      }
      if (item.clicked || item.right_clicked) workspace.ShowFileTree(number, tree, now);
      if (item.right_clicked) {
        if (TreeView* const view = workspace.view()) view->Select(kNoSceneNode);
        OpenMenu(state, menu::kTree, FromIm(ImGui::GetIO().MousePos));
      }
    }
  }
}

}  // namespace

void DrawProject(const Ui& ui, EditorState& state, const Box& box) {
  const std::size_t count = state.workspace.files().size();
  const std::string note = count == 0 ? "" : Count(count, "file");
  Panel(ui, "project", box, "PROJECT", note, [&] {
    if (count == 0) Hint(ui, "Files and their trees. Ctrl+O opens a file, Ctrl+N begins one.");
    for (std::size_t i = 0; i < count; ++i) DrawFile(ui, state, i);
  });
}

}  // namespace coppice::editor
