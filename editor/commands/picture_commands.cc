#include "editor/commands/picture_commands.h"

#include <filesystem>
#include <utility>

#include "editor/export/write_picture.h"
#include "editor/workspace/file_dialog.h"

namespace coppice::editor {
namespace {

constexpr float kPixels = 2;

// Beside the file, with the name of the tree.
std::string SuggestedPath(const EditorState& state, const std::string& tree) {
  const OpenFile* file = state.workspace.file();
  const auto folder = std::filesystem::path(file ? file->path : "").parent_path();
  return (folder / (tree + ".svg")).string();
}

// The tree as it is shown, or the comparison that stands in its place.
Outcome Export(EditorState& state, double now, const std::string& path) {
  TreeView* view = state.workspace.view();
  if (!view) return Problem{"there is no tree to paint"};
  if (Outcome may = MayReplace(state, path); !may) return may;
  TreePainting painting;
  painting.style = view->style();
  painting.palette = state.screen.palette;
  PaintedTree tree = {view->scene().get(), view->scene()->tree_id, nullptr};
  if (const auto& comparison = state.canvas.comparison) {
    tree.scene = comparison->view().scene().get();
    tree.title += ": " + comparison->summary();
    tree.changes = &comparison->changes();
  }
  painting.trees.push_back(std::move(tree));
  Outcome written = WritePicture(painting, path, kPixels);
  if (written) state.Notify("Painted " + path, now);
  return written;
}

// An empty path means the file as it was saved last.
Outcome Compare(EditorState& state, std::string path) {
  if (path.empty() && state.workspace.file()) path = state.workspace.file()->path;
  auto comparison = Comparison::With(path);
  if (!comparison) return Problem{comparison.problem()};
  state.canvas.comparison = *std::move(comparison);
  return {};
}

}  // namespace

void AddPictureCommands(EditorState& state) {
  state.commands.Add(
      {"file.export", "Export picture", {'E', kCtrl | kAlt}, [&state] {
         const TreeView* view = state.workspace.view();
         if (!view) return state.Notify("there is no tree to paint", state.now, true);
         OpenSaveDialog(
             state, std::string("Paint the shown tree into a file that ends in ") + kPictureEndings,
             SuggestedPath(state, view->scene()->tree_id),
             [&state](const std::string& path) { return Export(state, state.now, path); });
       }});
  state.commands.Add({"file.compare", "Compare with another version", {'D', kAlt}, [&state] {
                        if (!state.workspace.view()) {
                          return state.Notify("there is no tree to compare", state.now, true);
                        }
                        OpenPickDialog(
                            state, "Compare with a file; empty: with what was saved last",
                            [&state](const std::string& path) { return Compare(state, path); });
                      }});
  state.commands.Add({"file.stop_comparing", "Stop comparing", {'D', kAlt | kShift}, [&state] {
                        state.canvas.comparison.reset();
                      }});
}

}  // namespace coppice::editor
