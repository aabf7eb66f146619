#include "editor/export/diff_verb.h"

#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <optional>

#include "editor/export/diff_picture.h"
#include "editor/export/verb_options.h"

namespace coppice::editor {
namespace {

constexpr int kSame = 0;
constexpr int kDifferent = 1;
constexpr int kTrouble = 2;

// Green, red, blue, yellow; nothing if the output is no terminal.
const char* ColorOf(DiffKind kind) {
  constexpr const char* kColors[] = {"\x1b[32m", "\x1b[31m", "\x1b[34m", "\x1b[33m"};
  return kColors[static_cast<std::size_t>(kind)];
}

class Printer {
 public:
  Printer(const Forest& before, const Forest& after)
      : before_(before),
        after_(after),
        colored_(::isatty(STDOUT_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr) {}

  void Print(const TreeComparison& tree) const {
    if (tree.diffs.empty()) return;
    if (tree.before.nodes.empty()) return Line(DiffKind::kAdded, "+ tree " + tree.id);
    if (tree.after.nodes.empty()) return Line(DiffKind::kRemoved, "- tree " + tree.id);
    std::cout << tree.id << ": " << CountDiffs(tree.diffs) << "\n";
    for (const NodeDiff& diff : tree.diffs) {
      Line(diff.kind, "  " + ToString(diff, tree.before, tree.after),
           "   " + PlaceOf(diff, tree, before_, after_));
    }
  }

 private:
  void Line(DiffKind kind, const std::string& text, const std::string& place = {}) const {
    std::cout << (colored_ ? ColorOf(kind) : "") << text << (colored_ ? "\x1b[0m" : "") << place
              << "\n";
  }

  const Forest& before_;
  const Forest& after_;
  const bool colored_;
};

}  // namespace

const Command& DiffCommand() {
  static const Command command{
      "coppice diff",
      "say and paint what became of the trees of a file",
      {"A.xml B.xml", 2, 2},
      R"(Says which nodes were added (+), removed (-), moved (>) and changed (~) from A to B.
Ends with 0 if the trees are the same, 1 if they differ.)",
      PictureOptions()};
  return command;
}

int RunDiff(const std::vector<std::string>& arguments) {
  const Options options = ParseOptions(DiffCommand(), arguments);
  if (options.exit) return *options.exit;
  const auto order = ReadPictureOrder(options);
  if (!order) return RefuseOptions(DiffCommand(), order.problem());
  Diagnostics diagnostics;
  const Forest before = Forest::FromFile(options.files[0], diagnostics);
  const Forest after = Forest::FromFile(options.files[1], diagnostics);
  const NodeModels models_before = ModelsFor(before, order->models, diagnostics);
  const NodeModels models_after = ModelsFor(after, order->models, diagnostics);
  std::cerr << diagnostics.ToString();
  if (diagnostics.has_errors()) return kTrouble;

  const auto trees = CompareForests({before, models_before}, {after, models_after});
  const Printer printer(before, after);
  bool same = true;
  for (const TreeComparison& tree : trees) {
    same = same && tree.diffs.empty();
    printer.Print(tree);
  }
  if (order->path.empty() || same) return same ? kSame : kDifferent;
  const DiffPicture picture(trees);
  TreePainting painting = order->painting;
  picture.AddTo(painting);
  const Outcome written = WritePicture(painting, order->path, order->pixels);
  if (!written) std::cerr << "coppice diff: " << written.problem() << "\n";
  return written ? kDifferent : kTrouble;
}

}  // namespace coppice::editor
