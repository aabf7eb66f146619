// What the editor promises about every file that it can open: saving it unchanged gives the same
// bytes, and one edit touches one place. COPPICE_TREES names a folder with further files.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "editor/document/tree_edits.h"
#include "editor/workspace/workspace.h"
#include "tests/editor/driver.h"
#include "tests/support/folders.h"

namespace coppice::editor {
namespace {

std::string BytesOf(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> Files() {
  std::vector<std::string> files;
  std::vector<std::string> folders = {SourceFolder() + "/trees", SourceFolder() + "/tests"};
  if (const char* more = std::getenv("COPPICE_TREES")) folders.emplace_back(more);
  for (const std::string& folder : folders) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      if (entry.path().extension() == ".xml") files.push_back(entry.path().string());
    }
  }
  return files;
}

std::vector<std::string> Lines(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    lines.back() += c;
    if (c == '\n') lines.emplace_back();
  }
  return lines;
}

// How many lines there are between the first and the last that differ.
std::size_t ChangedLines(const std::string& before, const std::string& after) {
  const std::vector<std::string> a = Lines(before);
  const std::vector<std::string> b = Lines(after);
  std::size_t first = 0;
  while (first < std::min(a.size(), b.size()) && a[first] == b[first]) ++first;
  std::size_t last = 0;
  while (last < std::min(a.size(), b.size()) - first &&
         a[a.size() - 1 - last] == b[b.size() - 1 - last]) {
    ++last;
  }
  return std::max(a.size(), b.size()) - first - last;
}

TEST(EveryFile, SavedWithoutAnEditIsTheSameBytes) {
  const TemporaryFile folder("copy.xml", "");
  int opened = 0;
  for (const std::string& path : Files()) {
    SCOPED_TRACE(path);
    const std::string bytes = BytesOf(path);
    Workspace workspace([](const Scene&, const SceneNode&) { return Point{100, 30}; });
    const bool shown = workspace.Open(path, 0);
    Diagnostics diagnostics;
    ASSERT_TRUE(workspace.project().SaveAs(path, folder.path(), diagnostics));
    ASSERT_EQ(BytesOf(folder.path()), bytes);
    opened += shown;
  }
  std::printf("saved without an edit: %d files with trees\n", opened);
  EXPECT_GT(opened, 0);
}

TEST(EveryFile, OneEditTouchesOnePlace) {
  const NodeModels models;
  const NodeRules rules(models);
  int edited = 0;
  for (const std::string& path : Files()) {
    SCOPED_TRACE(path);
    OpenProject project;
    Diagnostics diagnostics;
    const EditedFile* file = project.Open(path, diagnostics);
    if (!file || !file->document) continue;
    const std::string before = file->text;
    const Document document = *file->document;
    ElementIndex node{0};
    while (node < document.elements().size() && !IsNode(document, node)) ++node;
    if (node == document.elements().size()) continue;
    Draft draft(document, {node});
    ASSERT_EQ(SetValue(draft, "coppice_test", "a < b").problem(), "");
    ASSERT_TRUE(project.Do({"Set", {std::move(draft).Finish(path)}}, {}, diagnostics));
    ASSERT_LE(ChangedLines(before, file->text), 2U);
    project.Undo();
    ASSERT_EQ(file->text, before);
    ++edited;
  }
  std::printf("edited in one place: %d files\n", edited);
  EXPECT_GT(edited, 0);
}

// Of the processor, whatever else the machine does.
double Milliseconds(const std::function<void()>& what) {
  const std::clock_t start = std::clock();
  what();
  return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST(EveryFile, OfOneMegabyteOpensAndIsUndone) {
  std::string xml = "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\"><Sequence>\n";
  while (xml.size() < 1000000) {
    xml +=
        "  <Fallback name=\"some branch\">\n    <IsDark light=\"{light}\"/>\n"
        "    <SwitchOn lamp=\"hall\" level=\"{level}\"/>\n  </Fallback>\n";
  }
  const TemporaryFile file("large.xml", xml + "</Sequence></BehaviorTree></root>\n");
  Driver driver;
  const double open = Milliseconds([&] { driver.editor.Open(file.path()); });
  const double frame = Milliseconds([&] { driver.Frames(1); });
  driver.Frames();
  driver.view().Select(driver.view().scene()->FindPath("1.500"));
  driver.Press('D');
  auto& state = driver.editor.state();
  const double undo = Milliseconds([&] { state.commands.Run("edit.undo"); });
  const EditedFile* edited = state.workspace.project().Find(file.path());
  EXPECT_EQ(edited->text, edited->saved);
  OpenProject project;
  Diagnostics diagnostics;
  project.Open(file.path(), diagnostics);
  Draft draft(*project.Find(file.path())->document, {ElementIndex{5}});
  ASSERT_TRUE(SetValue(draft, "name", "b"));
  project.Do({"Set", {std::move(draft).Finish(file.path())}}, {}, diagnostics);
  const double bytes = Milliseconds([&] { project.Undo(); });
  std::printf(
      "1 MB: open %.1f ms, check and first frame %.1f ms, undo %.1f ms (its text %.1f ms)\n", open,
      frame, undo, bytes);
}

}  // namespace
}  // namespace coppice::editor
